// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fusion/range_model.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace agv::estimation {

namespace {

/// d = |tag - anchor| depends on the state as u_x x' + u_y y'.
SensitivityRow along(const Eigen::Vector2d& u, const Placement& tag)
{
    SensitivityRow row;
    for (const Sensitivity& s : tag.x)
        row.add({s.state, u.x() * s.value});
    for (const Sensitivity& s : tag.y) {
        Sensitivity* same = std::ranges::find(row, s.state, &Sensitivity::state);
        if (same != row.end())
            same->value += u.y() * s.value;
        else
            row.add({s.state, u.y() * s.value});
    }
    return row;
}

bool usable(const AnchorRange& range)
{
    return range.index >= 0 && range.index < kMaxAnchors && std::isfinite(range.range_m) &&
           range.sd_m > 0.0 && range.anchor.allFinite();
}

} // namespace

RangeModel::RangeModel(const RangeModelSettings& settings) : m_settings(settings)
{
    m_seen.fill(Obstruction(settings.obstruction));
}

int RangeModel::biasStates(const RangeModelSettings& settings, int anchors)
{
    if (settings.biasSd_m <= 0.0)
        return 0;
    return std::clamp(anchors, 0, kMaxAnchors) + (settings.commonBiasSd_m > 0.0 ? 1 : 0);
}

void RangeModel::startBiases(GaussianState& state, int firstBias) const
{
    if (firstBias < 0)
        return;
    state.p.diagonal().tail(state.size() - firstBias).array() = m_settings.biasSd_m * m_settings.biasSd_m;
    if (hasCommon())
        state.p(state.size() - 1, state.size() - 1) = m_settings.commonBiasSd_m * m_settings.commonBiasSd_m;
}

void RangeModel::predict(GaussianState& state, int firstBias, double dt_s)
{
    if (m_settings.weighing == RangeWeighing::LineOfSight)
        for (Obstruction& seen : m_seen)
            seen.predict(m_settings.obstruction, dt_s);
    if (firstBias < 0)
        return;
    // Ornstein-Uhlenbeck: the memory fades, the variance stays what it was at first.
    const auto fade = [&](int first, int count, double sd, double time_s) {
        const double keep = std::exp(-dt_s / time_s);
        state.mean.segment(first, count) *= keep;
        state.p.middleRows(first, count) *= keep;
        state.p.middleCols(first, count) *= keep;
        state.p.diagonal().segment(first, count).array() += sd * sd * (1.0 - keep * keep);
    };
    const int common = hasCommon() ? 1 : 0;
    fade(firstBias, state.size() - firstBias - common, m_settings.biasSd_m, m_settings.biasTime_s);
    if (common > 0)
        fade(state.size() - 1, 1, m_settings.commonBiasSd_m, m_settings.commonBiasTime_s);
}

MeasurementRecord RangeModel::range(GaussianState& state, const Placement& tag, const AnchorRange& range,
                                    int firstBias)
{
    MeasurementRecord record;
    record.source = range.index;
    if (!usable(range)) {
        record.rejected = true;
        return record;
    }
    const Eigen::Vector3d away(tag.position.x() - range.anchor.x(), tag.position.y() - range.anchor.y(),
                               m_settings.height_m - range.anchor.z());
    const double d = std::max(away.norm(), kLeastDistance_m);
    SensitivityRow row = along(away.head<2>() / d, tag);
    double predicted = d;
    const int bias = firstBias + range.index;
    const int common = state.size() - 1;
    if (firstBias >= 0 && bias < state.size() - (hasCommon() ? 1 : 0)) {
        row.add({bias, 1.0});
        predicted += state.mean(bias);
    }
    if (firstBias >= 0 && hasCommon()) {
        row.add({common, 1.0});
        predicted += state.mean(common);
    }
    const double sd = range.sd_m + m_settings.sdPerMetre * std::max(0.0, d - m_settings.sdFrom_m);
    const double known = state.variance(row);
    const double nu = range.range_m - predicted;
    double s = known + sd * sd;
    record.innovation = nu;
    record.variance = s;
    record.testRatio = nu * nu / (s * m_settings.gate * m_settings.gate);
    record.weight = 1.0;
    record.fused = true;
    if (m_settings.weighing == RangeWeighing::LineOfSight) {
        const double seen =
            m_seen[static_cast<std::size_t>(range.index)].update(m_settings.obstruction, nu, s);
        state.update(row, nu, s, seen, seen * (1.0 - seen) * std::min(nu * nu, 9.0 * s));
        record.weight = seen;
        record.rejected = seen < 0.5;
        return record;
    }
    if (record.testRatio > 1.0) {
        record.rejected = true;
        s = known + 2.0 * record.testRatio * sd * sd;
        record.weight = record.variance / s;
    }
    state.update(row, nu, s);
    return record;
}

MeasurementRecord RangeModel::floorTag(GaussianState& state, const Placement& antenna,
                                       const Eigen::Vector2d& position, double sd_m) const
{
    MeasurementRecord record;
    record.kind = MeasurementKind::FloorTag;
    if (!position.allFinite()) {
        record.rejected = true;
        return record;
    }
    const double sd = sd_m > 0.0 ? sd_m : m_settings.floorTagSd_m;
    Eigen::Matrix2d noise = sd * sd * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d nu = position - antenna.position;
    const Eigen::Matrix2d s = state.covariance(antenna.x, antenna.y) + noise;
    record.innovation = nu.norm();
    record.variance = s.trace();
    record.testRatio = nu.dot(s.inverse() * nu) / (2.0 * m_settings.gate * m_settings.gate);
    record.weight = 1.0;
    record.fused = true;
    if (record.testRatio > 1.0) {
        record.rejected = true;
        record.weight = 1.0 / (2.0 * record.testRatio);
        noise *= 2.0 * record.testRatio;
    }
    state.update(antenna.x, antenna.y, nu, noise);
    return record;
}

} // namespace agv::estimation
