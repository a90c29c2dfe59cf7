// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/robot_status.h"

#include <optional>

namespace agv::simulation {

/// Where a docked robot stands: in front of the station's +y side (the open one of the example plants),
/// facing the station, 5 mm clear of it.
Pose2 dockPose(const Station& station, double robotRadius_m);

/// The dock of the wanted kind that is nearest to the robot and within sight (1.2 m); charging docks or all
/// others.
std::optional<Pose2> dockInSight(const PlantLayout& plant, const Pose2& robot, double robotRadius_m,
                                 bool charging);

/// Within 15 mm and 8 degrees of the dock's pose.
bool isDocked(const Pose2& robot, const Pose2& dock);

/// Wheel speeds that bring the robot nearer to the dock: turn on the spot until the next point lies ahead,
/// then drive to it; the points lie on the dock's axis, so the last stretch is straight.
WheelSpeeds towardsDock(const Pose2& robot, const Pose2& dock, double track_m);

} // namespace agv::simulation
