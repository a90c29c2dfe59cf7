// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "estimation/fusion/range_model.h"

namespace agv::estimation {

struct PositionFusionSettings {
    RangeModelSettings model;
    int anchors = 4;            ///< range biases kept as states; their indices start at 0
    double acceleration = 0.05; ///< sd of the white acceleration, m/s^2
    double startSd_m = 0.15;
    double startSpeedSd = 0.03; ///< m/s
};

/// Tight fusion of UWB ranges and floor tags without odometry: state (x, y, vx, vy, one slowly changing bias
/// per anchor), white acceleration. Every single range counts, so two anchors help where no fix is possible.
class PositionFusion {
public:
    explicit PositionFusion(const PositionFusionSettings& settings = {});

    void start(const Eigen::Vector2d& position);
    bool started() const { return m_started; }
    void predict(double dt_s);
    /// Ranges of one report, taken `age_s` before the time of the state.
    const MeasurementRecords& update(AnchorRanges ranges, double age_s = 0.0);
    /// Position of the vehicle from floor tags.
    MeasurementRecord updateFloorTag(const Eigen::Vector2d& position, double sd_m = 0.0);

    Eigen::Vector2d position() const { return m_state.mean.head<2>(); }
    Eigen::Vector2d velocity() const { return m_state.mean.segment<2>(2); }
    Eigen::Matrix2d covariance() const { return m_state.p.topLeftCorner<2, 2>(); }
    double bias_m(int anchor) const;
    const MeasurementRecords& records() const { return m_records; }
    const RangeModel& model() const { return m_model; }

private:
    Placement placement(double age_s) const;
    int firstBias() const { return m_state.size() > 4 ? 4 : -1; }

    PositionFusionSettings m_settings;
    RangeModel m_model;
    GaussianState m_state;
    MeasurementRecords m_records;
    bool m_started = false;
};

} // namespace agv::estimation
