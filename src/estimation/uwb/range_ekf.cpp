// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/range_ekf.h"

#include "estimation/uwb/robust_fix.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {} // namespace

RangeEkf::RangeEkf(const RangeEkfSettings& settings) : m_settings(settings)
{
    m_seen.fill(Obstruction(settings.obstruction));
}

void RangeEkf::start(const State& state, const Covariance& covariance)
{
    m_state = state;
    m_covariance = covariance;
    m_seen.fill(Obstruction(m_settings.obstruction));
    m_started = true;
}

bool RangeEkf::start(AnchorRanges ranges)
{
    RobustFixSettings settings;
    settings.height = TagHeight{m_settings.height_m, 0.0};
    settings.obstruction = m_settings.obstruction;
    const UwbFix fix = robustFix(ranges, settings).fix;
    if (!fix.ok())
        return false;
    Covariance covariance = Covariance::Zero();
    const double position = m_settings.startSd_m * m_settings.startSd_m;
    const double speed = m_settings.startSpeedSd * m_settings.startSpeedSd;
    covariance.diagonal() << position, position, speed, speed;
    start(State(fix.position.x(), fix.position.y(), 0.0, 0.0), covariance);
    return true;
}

void RangeEkf::predict(double dt_s)
{
    if (!m_started || !(dt_s > 0.0) || !std::isfinite(dt_s))
        return;
    m_state.head<2>() += dt_s * m_state.tail<2>();
    // F P F' with F = [1 dt; 0 1] in blocks.
    Covariance& p = m_covariance;
    p.topRows<2>() += dt_s * p.bottomRows<2>();
    p.leftCols<2>() += dt_s * p.rightCols<2>();
    const double q = m_settings.acceleration * m_settings.acceleration;
    const double half = 0.5 * dt_s * dt_s;
    p.diagonal().head<2>().array() += q * half * half;
    p.diagonal().tail<2>().array() += q * dt_s * dt_s;
    for (const int i : {0, 1}) {
        p(i, i + 2) += q * half * dt_s;
        p(i + 2, i) += q * half * dt_s;
    }
    if (m_settings.mode == RangeEkfMode::LineOfSight)
        for (Obstruction& seen : m_seen)
            seen.predict(m_settings.obstruction, dt_s);
}

MeasurementRecord RangeEkf::use(const AnchorRange& range)
{
    MeasurementRecord record;
    record.source = range.index;
    if (range.index < 0 || range.index >= kMaxAnchors || !std::isfinite(range.range_m) ||
        !(range.sd_m > 0.0) || !range.anchor.allFinite()) {
        record.rejected = true;
        return record;
    }
    const Eigen::Vector3d away(m_state(0) - range.anchor.x(), m_state(1) - range.anchor.y(),
                               m_settings.height_m - range.anchor.z());
    const double d = std::max(away.norm(), kLeastDistance_m);
    const Eigen::Vector2d h = away.head<2>() / d;
    const State ph = m_covariance.leftCols<2>() * h;
    const double predicted = h.dot(ph.head<2>());
    const double noise = range.sd_m * range.sd_m;
    const double nu = range.range_m - d;
    record.innovation = nu;
    record.variance = predicted + noise;
    record.testRatio = nu * nu / (kRecordGate * kRecordGate * record.variance);
    record.fused = true;
    record.weight = 1.0;
    double s = record.variance;
    if (m_settings.mode == RangeEkfMode::LineOfSight) {
        const double p =
            m_seen[static_cast<std::size_t>(range.index)].update(m_settings.obstruction, nu, record.variance);
        const State gain = ph / s;
        m_state += p * nu * gain;
        const double spread = p * (1.0 - p) * std::min(nu * nu, 9.0 * s);
        m_covariance += (spread - p * s) * gain * gain.transpose();
        record.weight = p;
        record.rejected = p < 0.5;
        return record;
    }
    if (m_settings.mode == RangeEkfMode::Robust) {
        const double t = nu / std::sqrt(s);
        const double f = std::max(std::abs(t) / (t > 0.0 ? m_settings.gate : 2.0 * m_settings.gate), 1.0);
        const double inflated = predicted + noise * f * f * f;
        record.weight = s / inflated;
        record.rejected = record.testRatio > 1.0;
        s = inflated;
    }
    const State gain = ph / s;
    m_state += gain * nu;
    m_covariance -= gain * ph.transpose();
    return record;
}

const MeasurementRecords& RangeEkf::update(AnchorRanges ranges)
{
    m_records.clear();
    if (m_started)
        for (const AnchorRange& range : ranges)
            m_records.add(use(range));
    return m_records;
}

} // namespace agv::estimation
