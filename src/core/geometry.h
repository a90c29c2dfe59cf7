// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

#include <array>
#include <cmath>

namespace agv {

/// A point of the plant frame: x east, y north, metres.
struct Point2 {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Point2&, const Point2&) = default;
};

inline Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
inline Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
inline Point2 operator*(double s, Point2 p) { return {s * p.x, s * p.y}; }
inline double distance(Point2 a, Point2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Where a vehicle stands: centre in metres, heading of its front in radians, (-pi, pi],
/// counter-clockwise from +x.
struct Pose2 {
    Point2 position;
    double heading = 0.0;
    friend bool operator==(const Pose2&, const Pose2&) = default;
};

/// A point given in the vehicle frame (x forward, y left, metres), in the plant frame.
inline Point2 fromVehicleFrame(const Pose2& pose, Point2 p)
{
    const double c = std::cos(pose.heading);
    const double s = std::sin(pose.heading);
    return {pose.position.x + c * p.x - s * p.y, pose.position.y + s * p.x + c * p.y};
}

/// Symmetric covariance of (x, y, heading): m^2, m rad, rad^2; row major.
using PoseCovariance = std::array<double, 9>;

} // namespace agv
