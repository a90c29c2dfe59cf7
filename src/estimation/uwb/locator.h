// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"
#include "estimation/fusion/vehicle_fusion.h"
#include "estimation/measurement_record.h"
#include "estimation/uwb/fix.h"

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace agv::estimation {

struct LocatorSettings {
    std::vector<Eigen::Vector3d> anchors; ///< by AnchorRange::index, m
    double height_m = 0.0;                ///< of the tag; ignored by the methods that solve in space
    double acceleration = 0.15;           ///< of a moving tag, m/s^2
    std::optional<Pose2> startPose =
        {}; ///< for fusion with odometry: where and how the vehicle stands at first
    /// For fusion with odometry without startPose: how the vehicle stands at first, rad; 0 without it.
    std::optional<double> startHeading = {};
    /// For fusion with odometry: the tag in the vehicle frame, m. The answer is the place of the vehicle's
    /// centre.
    Point2 mount = {};
    std::uint64_t seed = 1; ///< of particle filters
};

/// Answer of a method to one report.
struct Located {
    FixStatus status = FixStatus::TooFewRanges;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< m; means nothing unless the status is Ok
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< m^2
    std::optional<double> heading = {};                   ///< rad, of methods that know it
    MeasurementRecords records;
    bool ok() const { return status == FixStatus::Ok; }
};

/// A positioning method as `locate` and `fuse` use it: reports of one tag in, positions out. Times in s,
/// rising.
class Locator {
public:
    virtual ~Locator() = default;
    /// A report of ranges; the position at its time.
    virtual Located locate(double time_s, AnchorRanges ranges) = 0;
    /// What the wheels did during the dt_s before `time_s`. Methods without odometry ignore it.
    virtual void odometry(double time_s, const OdometryStep& step, double dt_s);
    /// A position from floor tags. Methods without floor tags ignore it.
    virtual void floorTag(double time_s, Point2 position);
};

enum class MethodInput : std::uint8_t {
    Ranges,  ///< runs on ranges: `locate`
    Fusion,  ///< uses odometry or floor tags besides: `fuse`
    Special, ///< needs other measurements (angles, fingerprints, tag reads); listed, used elsewhere
};

struct MethodInfo {
    std::string_view name; ///< of --method
    std::string_view title;
    std::string_view source; ///< equation, chapter or idea
    MethodInput input = MethodInput::Ranges;
    bool inSpace = false; ///< solves for the height too
};

/// Every method of the program; the first is the default.
std::span<const MethodInfo> allMethods();
const MethodInfo* findMethod(std::string_view name);

/// NotFound names the methods there are; BadInput: a Special one.
Result<std::unique_ptr<Locator>> makeLocator(std::string_view name, const LocatorSettings& settings);

} // namespace agv::estimation
