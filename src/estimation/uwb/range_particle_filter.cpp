// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/range_particle_filter.h"

#include "estimation/log_sum_exp.h"
#include "estimation/uwb/robust_fix.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

/// Kernel width after resampling, in sds of the cloud.
constexpr double kRangeRoughening = 0.15;
/// Density of an outlier, 1/m: no range excludes a particle for good.
constexpr double kOutlierDensity = 1e-4;
constexpr double kSoftEdge_m = 0.01;
constexpr double kLeastLog = -60.0;

double spreadOf(const std::vector<double>& values)
{
    double mean = 0.0;
    for (const double v : values)
        mean += v;
    mean /= static_cast<double>(values.size());
    double sum = 0.0;
    for (const double v : values)
        sum += (v - mean) * (v - mean);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

} // namespace

RangeParticleFilter::RangeParticleFilter(const RangeParticleSettings& settings)
    : m_settings(settings),
      m_random(settings.seed)
{
    const auto n = static_cast<std::size_t>(std::max(settings.particles, 16));
    for (auto* column : {&m_x, &m_y, &m_vx, &m_vy, &m_weight, &m_log, &m_spare})
        column->assign(n, 0.0);
}

void RangeParticleFilter::start(const Eigen::Vector2d& position)
{
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        m_x[i] = position.x() + m_settings.startSd_m * m_random.normal();
        m_y[i] = position.y() + m_settings.startSd_m * m_random.normal();
        m_vx[i] = m_settings.startSpeedSd * m_random.normal();
        m_vy[i] = m_settings.startSpeedSd * m_random.normal();
        m_weight[i] = 1.0 / static_cast<double>(m_x.size());
    }
    m_started = true;
}

bool RangeParticleFilter::start(AnchorRanges ranges)
{
    RobustFixSettings settings;
    settings.height = TagHeight{m_settings.height_m, 0.0};
    const UwbFix fix = robustFix(ranges, settings).fix;
    if (fix.ok())
        start(fix.position.head<2>());
    return fix.ok();
}

void RangeParticleFilter::predict(double dt_s)
{
    if (!m_started || !(dt_s > 0.0) || !std::isfinite(dt_s))
        return;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        const double ax = m_settings.acceleration * m_random.normal();
        const double ay = m_settings.acceleration * m_random.normal();
        m_x[i] += (m_vx[i] + 0.5 * ax * dt_s) * dt_s;
        m_y[i] += (m_vy[i] + 0.5 * ay * dt_s) * dt_s;
        m_vx[i] += ax * dt_s;
        m_vy[i] += ay * dt_s;
    }
}

double RangeParticleFilter::logLikelihood(double error, double sd_m) const
{
    const double z = error / sd_m;
    double log = -0.5 * z * z - std::log(sd_m) - 0.91893853320467274178;
    if (m_settings.hidden > 0.0)
        log = logSumExp(std::log1p(-m_settings.hidden) + log,
                        std::log(m_settings.hidden) +
                            logNormalPlusExponential(error, sd_m, m_settings.meanBias_m));
    return logSumExp(log, std::log(kOutlierDensity));
}

const MeasurementRecords& RangeParticleFilter::update(AnchorRanges ranges)
{
    m_records.clear();
    if (!m_started)
        return m_records;
    const Eigen::Vector2d before = position();
    const Eigen::Matrix2d spread = covariance();
    std::ranges::fill(m_log, 0.0);
    for (const AnchorRange& range : ranges) {
        MeasurementRecord record;
        record.source = range.index;
        if (!std::isfinite(range.range_m) || !(range.sd_m > 0.0) || !range.anchor.allFinite()) {
            record.rejected = true;
            m_records.add(record);
            continue;
        }
        const double rise = m_settings.height_m - range.anchor.z();
        for (std::size_t i = 0; i < m_x.size(); ++i) {
            const double dx = m_x[i] - range.anchor.x();
            const double dy = m_y[i] - range.anchor.y();
            m_log[i] += logLikelihood(range.range_m - std::sqrt(dx * dx + dy * dy + rise * rise), range.sd_m);
        }
        const Eigen::Vector3d away(before.x() - range.anchor.x(), before.y() - range.anchor.y(), rise);
        const double d = std::max(away.norm(), 1e-6);
        const Eigen::Vector2d u = away.head<2>() / d;
        record.innovation = range.range_m - d;
        record.variance = u.dot(spread * u) + range.sd_m * range.sd_m;
        record.testRatio =
            record.innovation * record.innovation / (kRecordGate * kRecordGate * record.variance);
        record.rejected = record.testRatio > 1.0;
        record.weight = record.rejected ? 1.0 / record.testRatio : 1.0;
        record.fused = true;
        m_records.add(record);
    }
    normalise();
    resampleWhenNeeded();
    return m_records;
}

MeasurementRecord RangeParticleFilter::updateFloorTag(const Eigen::Vector2d& position)
{
    MeasurementRecord record;
    record.kind = MeasurementKind::FloorTag;
    if (!m_started || !position.allFinite()) {
        record.rejected = true;
        return record;
    }
    const double radius = m_settings.floorTagRadius_m;
    record.innovation = (position - this->position()).norm();
    record.variance = covariance().trace() + 0.5 * radius * radius;
    record.testRatio = record.innovation * record.innovation / (kRecordGate * kRecordGate * record.variance);
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        const double beyond =
            (std::hypot(m_x[i] - position.x(), m_y[i] - position.y()) - radius) / kSoftEdge_m;
        m_log[i] = beyond > 0.0 ? -0.5 * beyond * beyond : 0.0;
    }
    record.fused = true;
    record.weight = 1.0;
    normalise();
    resampleWhenNeeded();
    return record;
}

void RangeParticleFilter::normalise()
{
    double most = -1e300;
    for (std::size_t i = 0; i < m_log.size(); ++i) {
        m_log[i] = std::log(m_weight[i] + 1e-300) + std::max(m_log[i], kLeastLog);
        most = std::max(most, m_log[i]);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < m_log.size(); ++i)
        sum += m_weight[i] = std::exp(m_log[i] - most);
    for (double& w : m_weight)
        w /= sum;
}

void RangeParticleFilter::resampleWhenNeeded()
{
    const std::size_t n = m_weight.size();
    double squares = 0.0;
    for (const double w : m_weight)
        squares += w * w;
    if (1.0 / squares >= 0.5 * static_cast<double>(n))
        return;
    // Systematic resampling, all columns with the same draw.
    const double offset = m_random.uniform();
    const std::vector<double>& w = m_weight;
    for (auto* column : {&m_x, &m_y, &m_vx, &m_vy}) {
        double reached = w[0];
        std::size_t source = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double level = (offset + static_cast<double>(i)) / static_cast<double>(n);
            while (reached < level && source + 1 < n)
                reached += w[++source];
            m_spare[i] = (*column)[source];
        }
        const double sd = kRangeRoughening * spreadOf(m_spare);
        for (std::size_t i = 0; i < n; ++i)
            (*column)[i] = m_spare[i] + sd * m_random.normal();
    }
    std::ranges::fill(m_weight, 1.0 / static_cast<double>(n));
}

Eigen::Vector2d RangeParticleFilter::position() const
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < m_x.size(); ++i)
        mean += m_weight[i] * Eigen::Vector2d(m_x[i], m_y[i]);
    return mean;
}

Eigen::Vector2d RangeParticleFilter::velocity() const
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < m_x.size(); ++i)
        mean += m_weight[i] * Eigen::Vector2d(m_vx[i], m_vy[i]);
    return mean;
}

Eigen::Matrix2d RangeParticleFilter::covariance() const
{
    const Eigen::Vector2d mean = position();
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        const Eigen::Vector2d away = Eigen::Vector2d(m_x[i], m_y[i]) - mean;
        sum += m_weight[i] * away * away.transpose();
    }
    return sum;
}

} // namespace agv::estimation
