// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "estimation/fusion/range_model.h"
#include "estimation/uwb/fix.h"

#include <span>

namespace agv::estimation {

/// Ranges of one tag that is mounted on a body at a known place.
struct BodyTagRanges {
    Point2 mount; ///< body frame, m
    int tag = 0;  ///< 0..kMaxBodyTags-1, selects line-of-sight states
    AnchorRanges ranges;
};
constexpr int kMaxBodyTags = 4;

struct BodyTrackerSettings {
    /// What calibration leaves of an anchor's error changes with the place, so in seconds while driving.
    RangeModelSettings model{.biasSd_m = 0.06, .biasTime_s = 3.0, .commonBiasSd_m = 0.0, .obstruction = {}};
    int anchors = 8;           ///< anchors whose errors are states, for each tag; their indices start at 0
    double acceleration = 0.2; ///< sd of the white acceleration, m/s^2
    double turnAcceleration = 0.3; ///< sd of the white angular acceleration, rad/s^2
    /// sd of the speed across the heading of a body on wheels, m/s; 0: it moves in any direction.
    double sideSlip = 0.05;
    double startSd_m = 0.2;
    double startHeadingSd = 0.5; ///< rad
};

/// Pose of one body from the ranges of all tags at once, without iteration between them: best x, y and
/// heading by weighted least squares, started at every 45 degrees. Two tags or more.
struct BodyFix {
    FixStatus status = FixStatus::TooFewRanges;
    Pose2 pose;
    PoseCovariance covariance{};
    double chiSquared = 0.0;
    bool ok() const { return status == FixStatus::Ok; }
};
BodyFix bodyFix(std::span<const BodyTagRanges> tags, double height_m);

/// Track of a body with several tags and no odometry: state (x, y, heading, vx, vy, turn rate), white
/// accelerations. The heading comes from the tags' different places on the body, so a standing vehicle has
/// one too.
class BodyTracker {
public:
    explicit BodyTracker(const BodyTrackerSettings& settings = {});

    void start(const Pose2& pose);
    /// Starts at a body fix; false when there is none.
    bool start(std::span<const BodyTagRanges> tags);
    bool started() const { return m_started; }
    void predict(double dt_s);
    const MeasurementRecords& update(std::span<const BodyTagRanges> tags);

    Pose2 pose() const;
    PoseCovariance covariance() const;
    /// Where a point of the body (body frame, m) is.
    Point2 placeOf(Point2 mount) const { return fromVehicleFrame(pose(), mount); }

private:
    void keepToHeading();
    int biasStates() const;
    int firstBias(int tag) const;

    BodyTrackerSettings m_settings;
    std::array<RangeModel, kMaxBodyTags>
        m_models; ///< one per tag: an anchor hidden from one may be seen by another
    GaussianState m_state;
    MeasurementRecords m_records;
    bool m_started = false;
};

} // namespace agv::estimation
