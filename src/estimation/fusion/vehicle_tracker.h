// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/robot_status.h"
#include "core/tag_read.h"
#include "core/tracked_pose.h"
#include "estimation/fusion/floor_filter.h"

#include <array>
#include <string>

namespace agv::estimation {

/// Where one AGV is, from the pose that its initialisation turn found on: the wheel speeds it was commanded,
/// the floor tags it reads and the ranges of the UWB tags it carries, fused by a FloorFilter. Times never
/// fall. Nothing allocates per message.
///
/// What is measured again and again at one place has its errors in common: of a floor tag the first reads of
/// each centimetre of the way count (see kReadCorrelation), of ranges what is new by time or way. An AGV that
/// stands is not moved, so its pose gets neither better nor worse with time.
class VehicleTracker {
public:
    /// The plant's floor tags and RSSI table; the AGV's antenna and track.
    VehicleTracker(const PlantLayout& plant, const AgvConfig& agv, std::uint64_t seed = 1);

    /// From the initialisation turn: nothing is doubted any more.
    void start(const Pose2& pose, const PoseCovariance& covariance, Time now);
    bool started() const { return m_filter.started(); }

    /// What the wheels are told from now on.
    void wheels(const WheelSpeeds& speeds, Time now);
    void read(const TagRead& read);
    /// Ranges of one report of a UWB tag at `mount` (vehicle frame, m), corrected, measured at `time`; what
    /// is older than the last step counts for that.
    void ranges(AnchorRanges ranges, Point2 mount, double height_m, Time time);
    /// Somebody knows better; until the next start. `why`: plain English, with the remedy.
    void doubt(const std::string& why);

    /// As of now; may be called as often as anybody looks.
    TrackedPose pose(Time now);

private:
    struct CountedRead {
        TagUid uid;
        int reads = 0;
    };

    void advance(Time now, Duration shortest);
    Pose2 poseAhead(Time now) const;
    bool isNews(TagUid uid);
    void judge(bool isPlausible);

    TagMap m_tags;
    double m_track_m;
    FloorFilter m_filter;
    WheelSpeeds m_commanded;
    WheelSpeeds m_speeds;         ///< that the wheels have reached by m_time
    Time m_time;                  ///< of the filter's state
    double m_way_m = 0.0;         ///< of the faster wheel, since the start
    double m_heardAt_m = 0.0;     ///< m_way_m at the last measurement that fitted
    double m_countedFrom_m = 0.0; ///< m_way_m where the counting of reads began anew
    FixedList<CountedRead, 32> m_counted;
    double m_rangesAt_m = 0.0; ///< m_way_m at the last ranges
    Time m_rangesTime;
    double m_plausible = 1.0;
    double m_fitting = 1.0;
    std::string m_doubt;
};

} // namespace agv::estimation
