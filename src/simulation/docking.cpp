// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/docking.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace agv::simulation {
namespace {

constexpr double sight_m = 1.2;
constexpr double gap_m = 0.005;
constexpr double speed_m_s = 0.10;
constexpr double runIn_m = 0.25; ///< length of the straight stretch before the dock
constexpr double lookAhead_m = 0.12;

Point2 inFrameOf(const Pose2& frame, Point2 p)
{
    const Point2 d = p - frame.position;
    const double c = std::cos(frame.heading);
    const double s = std::sin(frame.heading);
    return {c * d.x + s * d.y, -s * d.x + c * d.y};
}

} // namespace

Pose2 dockPose(const Station& station, double robotRadius_m)
{
    const double out = 0.5 * station.depth_m + robotRadius_m + gap_m;
    return {fromVehicleFrame(station.pose, {0.0, out}),
            wrapAngle(station.pose.heading - std::numbers::pi / 2.0)};
}

std::optional<Pose2> dockInSight(const PlantLayout& plant, const Pose2& robot, double robotRadius_m,
                                 bool charging)
{
    std::optional<Pose2> nearest;
    double nearestDistance = sight_m;
    for (const Station& station : plant.stations) {
        if ((station.kind == StationKind::Charging) != charging)
            continue;
        const Pose2 dock = dockPose(station, robotRadius_m);
        const double away = distance(dock.position, robot.position);
        if (away <= nearestDistance) {
            nearest = dock;
            nearestDistance = away;
        }
    }
    return nearest;
}

bool isDocked(const Pose2& robot, const Pose2& dock)
{
    return distance(robot.position, dock.position) <= 0.015 &&
           std::abs(wrapAngle(robot.heading - dock.heading)) <= radFromDeg(8.0);
}

WheelSpeeds towardsDock(const Pose2& robot, const Pose2& dock, double track_m)
{
    const Point2 at = inFrameOf(dock, robot.position);
    const double heading = wrapAngle(robot.heading - dock.heading);
    const bool onAxis = std::abs(at.y) < 0.03 + 0.1 * std::max(0.0, -at.x);
    Point2 aim{std::min(0.0, at.x) + lookAhead_m, 0.0};
    if (at.x > -runIn_m && !onAxis)
        aim = {-1.2 * runIn_m, 0.0}; // too close to the dock and beside it: back to the start of the run-in
    const double bearing = wrapAngle(std::atan2(aim.y - at.y, aim.x - at.x) - heading);
    if (std::abs(bearing) > radFromDeg(20.0)) {
        const double turn = std::copysign(0.6 * speed_m_s, bearing);
        return {-turn, turn};
    }
    const double slow = std::clamp(std::abs(at.x) / 0.10, 0.3, 1.0) * speed_m_s;
    const double difference =
        std::clamp(2.0 * bearing / lookAhead_m * slow * 0.5 * track_m, -0.5 * slow, 0.5 * slow);
    return {slow - difference, slow + difference};
}

} // namespace agv::simulation
