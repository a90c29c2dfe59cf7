// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/planar_ekf.h"

#include "estimation/uwb/linear_toa.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace agv::estimation {

namespace {

constexpr double kPlanarGate = 3.0;

} // namespace

void PlanarEkf::start(const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance)
{
    m_position = position;
    m_covariance = covariance;
    m_started = true;
}

bool PlanarEkf::start(AnchorRanges ranges)
{
    const UwbFix fix = linearToa2d(ranges, TagHeight{m_settings.height_m, 0.0});
    if (!fix.ok())
        return false;
    start(fix.position.head<2>(), m_settings.startSd_m * m_settings.startSd_m * Eigen::Matrix2d::Identity());
    return true;
}

void PlanarEkf::predict(double dt_s)
{
    if (m_started && dt_s > 0.0 && std::isfinite(dt_s))
        m_covariance.diagonal().array() += m_settings.walkSd_m * m_settings.walkSd_m * dt_s;
}

const MeasurementRecords& PlanarEkf::update(AnchorRanges ranges)
{
    m_records.clear();
    if (!m_started)
        return m_records;
    // Independent ranges linearised at the same state: the batch gain of 3.15 in information form.
    Eigen::Matrix2d information = m_covariance.inverse();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const AnchorRange& range : ranges) {
        MeasurementRecord record;
        record.source = range.index;
        if (!std::isfinite(range.range_m) || !(range.sd_m > 0.0) || !range.anchor.allFinite()) {
            record.rejected = true;
            m_records.add(record);
            continue;
        }
        const Eigen::Vector3d away(m_position.x() - range.anchor.x(), m_position.y() - range.anchor.y(),
                                   m_settings.height_m - range.anchor.z());
        const double d = std::max(away.norm(), kLeastDistance_m);
        const Eigen::Vector2d f = away.head<2>() / d;
        const double noise = range.sd_m * range.sd_m;
        record.innovation = range.range_m - d;
        record.variance = f.dot(m_covariance * f) + noise;
        record.testRatio =
            record.innovation * record.innovation / (kPlanarGate * kPlanarGate * record.variance);
        record.weight = 1.0;
        record.fused = true;
        m_records.add(record);
        information += f * f.transpose() / noise;
        right += f * record.innovation / noise;
    }
    m_covariance = information.inverse();
    m_position += m_covariance * right;
    return m_records;
}

} // namespace agv::estimation
