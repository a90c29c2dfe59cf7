// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "estimation/fusion/range_model.h"

namespace agv::estimation {

struct VehicleFusionSettings {
    RangeModelSettings model;
    int anchors = 4;             ///< range biases kept as states; their indices start at 0
    double scaleSd = 0.05;       ///< of the odometry's unknown scale (wheel diameter), relative
    double turnScaleSd = 0.05;   ///< of its unknown turn scale (track width, wheel difference), relative
    double distanceNoise = 0.03; ///< sd of a step over its length
    double turnNoise = 0.03;     ///< sd of a turn over its size
    double placeWalk = 1e-4;     ///< m per square root of a second
    double headingWalk = 3e-4;   ///< rad per square root of a second
    double scaleWalk = 3e-4;     ///< per square root of a second
    double headingSd = 0.05236;  ///< rad, at a start by position only
    double startSd_m = 0.15;     ///< at a start by position only
};

/// What the wheels did since the last step, in the vehicle's frame.
struct OdometryStep {
    double forward_m = 0.0;
    double left_m = 0.0; ///< vehicles on two wheels: 0
    double turn = 0.0;   ///< rad, counter-clockwise
};

/// From the ways of the two wheels; `track_m` > 0 is their distance.
OdometryStep odometryFromWheels(double left_m, double right_m, double track_m);

/// Tight fusion of wheel odometry, UWB ranges and floor tags: the default for a vehicle. State (x, y,
/// heading, scale, turn scale of the odometry, one slowly changing bias per anchor); the heading carries the
/// offset between what the odometry believes and what is true. Started by the pose of the initialisation
/// turn.
class VehicleFusion {
public:
    explicit VehicleFusion(const VehicleFusionSettings& settings = {});

    /// From the initialisation turn.
    void start(const Pose2& pose, const PoseCovariance& covariance);
    /// From a position and a heading that is known roughly (settings: startSd_m, headingSd).
    void start(const Pose2& pose);
    bool started() const { return m_started; }

    void predict(const OdometryStep& odometry, double dt_s);
    /// Ranges of one report of a tag at `tag` (vehicle frame, m), taken `age_s` before the time of the state.
    const MeasurementRecords& update(AnchorRanges ranges, Point2 tag = {}, double age_s = 0.0);
    /// Position of an antenna at `antenna` (vehicle frame, m) from floor tags. sd_m 0: of the settings.
    MeasurementRecord updateFloorTag(const Eigen::Vector2d& position, Point2 antenna = {}, double sd_m = 0.0);

    Pose2 pose() const;
    PoseCovariance covariance() const;
    double scale() const { return 1.0 + m_state.mean(3); }
    double turnScale() const { return 1.0 + m_state.mean(4); }
    double bias_m(int anchor) const;
    const MeasurementRecords& records() const { return m_records; }
    const RangeModel& model() const { return m_model; }
    const GaussianState& state() const { return m_state; }

private:
    Placement placement(Point2 offset, double age_s) const;
    int firstBias() const { return m_state.size() > 5 ? 5 : -1; }
    void reset();

    VehicleFusionSettings m_settings;
    RangeModel m_model;
    GaussianState m_state;
    MeasurementRecords m_records;
    Eigen::Vector2d m_velocity = Eigen::Vector2d::Zero(); ///< of the last step, plant frame, m/s
    bool m_started = false;
};

} // namespace agv::estimation
