// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fusion/vehicle_tracker.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {
namespace {

constexpr Duration kLongestStep = std::chrono::milliseconds(40);
/// The wheels do not take up a new speed at once; assumed, no data sheet says it.
constexpr double kAcceleration_m_s2 = 0.8;
constexpr double kRampError = 0.8; ///< sd, of the way that a ramp takes away
constexpr Duration kRampStep = std::chrono::milliseconds(20);
/// Every step adds noise and costs time; what is nearer counts for the step before.
constexpr Duration kShortestStep = std::chrono::milliseconds(10);
constexpr int kTrackerParticles = 1200; ///< 3000 are hardly better, and a plant has several AGVs
/// Commanded speeds are worse than measured ones: slip, a weak battery.
constexpr double kCommandScaleSd = 0.10;
constexpr int kReadsThatCount = 2; ///< of a tag at one place: 1 / kReadCorrelation
constexpr double kPlaceOfReads_m = 0.01;
/// Errors of ranges change within this time of driving, or this way.
constexpr double kRangeNewsEvery_m = 0.5;
constexpr double kRangeNewsEvery_s = 60.0;
constexpr double kPredictedAfter_m = 0.25;
constexpr double kForgetReads = 0.05;
constexpr double kForgetRanges = 0.02; ///< of a report; 10 a second
/// A UWB tag is this far from where the pose has it: no obstruction makes ranges shorter, but two of three
/// longer ones are common.
constexpr double kFarOff_m = 0.6;

FloorFilterSettings settingsFor(const AgvConfig& agv, std::uint64_t seed)
{
    return {.particles = kTrackerParticles,
            .track_m = agv.track_m,
            .antenna = agv.antenna,
            .wheelScaleSd = kCommandScaleSd,
            .seed = seed};
}

double fasterOf(const WheelSpeeds& speeds) { return std::max(std::abs(speeds.left), std::abs(speeds.right)); }

/// What a wheel goes farther, or less, than thought while it takes up another speed.
double rampSlip_m(double change_m_s)
{
    return kRampError * change_m_s * change_m_s / (2.0 * kAcceleration_m_s2);
}

double approached(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

std::string inMm(double metres) { return std::to_string(std::lround(mmFromMetres(metres))) + " mm"; }

} // namespace

VehicleTracker::VehicleTracker(const PlantLayout& plant, const AgvConfig& agv, std::uint64_t seed)
    : m_tags(tagMapOf(plant)),
      m_track_m(agv.track_m),
      m_filter(m_tags, plant.rssiTable, settingsFor(agv, seed))
{}

void VehicleTracker::start(const Pose2& pose, const PoseCovariance& covariance, Time now)
{
    m_filter.start(pose, covariance);
    m_time = now;
    m_way_m = m_heardAt_m = m_countedFrom_m = m_rangesAt_m = 0.0;
    m_rangesTime = now;
    m_counted.clear();
    m_plausible = m_fitting = 1.0;
    m_doubt.clear();
}

void VehicleTracker::doubt(const std::string& why)
{
    if (started())
        m_doubt = why;
}

void VehicleTracker::wheels(const WheelSpeeds& speeds, Time now)
{
    if (speeds == m_commanded)
        return;
    advance(now, Duration::zero());
    m_filter.slip(rampSlip_m(speeds.left - m_speeds.left), rampSlip_m(speeds.right - m_speeds.right));
    m_commanded = speeds;
}

/// What is left of the time is shorter than `shortest`.
void VehicleTracker::advance(Time now, Duration shortest)
{
    if (!started())
        return;
    while (now - m_time >= std::max(shortest, Duration(1))) {
        if (m_speeds == WheelSpeeds{} && m_commanded == WheelSpeeds{}) {
            m_time = now;
            return;
        }
        const bool isRamp = m_speeds != m_commanded;
        const Duration step = std::min<Duration>(isRamp ? kRampStep : kLongestStep, now - m_time);
        const double most_m_s = kAcceleration_m_s2 * secondsFrom(step);
        const WheelSpeeds before = m_speeds;
        m_speeds = {approached(before.left, m_commanded.left, most_m_s),
                    approached(before.right, m_commanded.right, most_m_s)};
        const WheelSpeeds mean{0.5 * (before.left + m_speeds.left), 0.5 * (before.right + m_speeds.right)};
        m_filter.predict(mean.left, mean.right, secondsFrom(step));
        m_way_m += fasterOf(mean) * secondsFrom(step);
        m_time += step;
    }
}

/// The mean carried on from the last step; its covariance hardly changes meanwhile.
Pose2 VehicleTracker::poseAhead(Time now) const
{
    Pose2 pose = m_filter.pose();
    const double rest_s = std::max(0.0, secondsFrom(now - m_time));
    const double turn = (m_speeds.right - m_speeds.left) / m_track_m * rest_s;
    const double way_m = 0.5 * (m_speeds.left + m_speeds.right) * rest_s;
    const double along = pose.heading + 0.5 * turn;
    pose.position = pose.position + way_m * Point2{std::cos(along), std::sin(along)};
    pose.heading = wrapAngle(pose.heading + turn);
    return pose;
}

/// Whether another read of the tag at this place says something that the ones before have not.
bool VehicleTracker::isNews(TagUid uid)
{
    if (m_way_m - m_countedFrom_m > kPlaceOfReads_m) {
        m_counted.clear();
        m_countedFrom_m = m_way_m;
    }
    auto* const known = std::ranges::find(m_counted, uid, &CountedRead::uid);
    if (known == m_counted.end())
        return m_counted.add({uid, 1});
    return ++known->reads <= kReadsThatCount;
}

void VehicleTracker::read(const TagRead& read)
{
    const auto tag = m_tags.find(read.uid);
    if (!started() || tag == m_tags.end())
        return;
    advance(read.time, kShortestStep);
    const bool isPlausible = m_filter.testRatio(tag->second) <= 1.0;
    judge(isPlausible);
    if (isPlausible)
        m_heardAt_m = m_way_m;
    if (isNews(read.uid)) {
        const FloorRead one{read.uid, read.rssi};
        m_filter.update({&one, 1});
    }
}

void VehicleTracker::judge(bool isPlausible)
{
    m_plausible += kForgetReads * ((isPlausible ? 1.0 : 0.0) - m_plausible);
    if (m_plausible < 0.5 && m_doubt.empty())
        m_doubt = "The floor tags it reads lie elsewhere: it was moved or slipped; calibrate it again";
}

void VehicleTracker::ranges(AnchorRanges ranges, Point2 mount, double height_m, Time time)
{
    if (!started() || ranges.empty())
        return;
    advance(time, kShortestStep);
    const double way_m = m_way_m - m_rangesAt_m;
    const double share =
        std::min(1.0, way_m / kRangeNewsEvery_m + secondsFrom(m_time - m_rangesTime) / kRangeNewsEvery_s);
    m_rangesAt_m = m_way_m;
    m_rangesTime = m_time;
    const MeasurementRecords& records = m_filter.update(ranges, mount, height_m, share);
    const auto farOff = std::ranges::count_if(
        records, [](const MeasurementRecord& record) { return std::abs(record.innovation) > kFarOff_m; });
    const bool fits = 2 * farOff <= std::ssize(records);
    if (fits && records.size() >= 3)
        m_heardAt_m = m_way_m;
    m_fitting += kForgetRanges * ((fits ? 1.0 : 0.0) - m_fitting);
    if (m_fitting < 0.5 && m_doubt.empty())
        m_doubt = "Its UWB tag is elsewhere: it was moved; calibrate it again";
}

TrackedPose VehicleTracker::pose(Time now)
{
    TrackedPose tracked;
    if (!started())
        return tracked;
    advance(now, kLongestStep);
    tracked.pose = poseAhead(now);
    tracked.covariance = m_filter.covariance();
    tracked.note = m_doubt;
    if (!m_doubt.empty()) {
        tracked.health = PoseHealth::Doubted;
    } else if (const double unheard_m = m_way_m - m_heardAt_m; unheard_m > kPredictedAfter_m) {
        tracked.health = PoseHealth::Predicted;
        tracked.note = "Nothing measured for the last " + inMm(unheard_m) +
                       " of its way: the pose is what the commanded speeds make of it";
    } else {
        tracked.health = PoseHealth::Tracked;
    }
    return tracked;
}

} // namespace agv::estimation
