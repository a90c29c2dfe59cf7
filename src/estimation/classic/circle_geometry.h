// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstdint>
#include <expected>

namespace agv::estimation {

/// Why three circles or two lines have no single common point.
enum class CircleGeometryError : std::uint8_t {
    CoincidentCentres, ///< the first two circles share their centre: no direction to measure along
    CollinearCentres,  ///< all centres on one line: the point and its mirror image fit equally well
    ParallelLines,     ///< the two lines never meet, or one of them is a point
};

const char* toText(CircleGeometryError error);

struct Circle {
    Point2 centre;
    double radius = 0.0; ///< >= 0, in the unit of `centre`
};

/// The common point of three circles in the plane (seed, chapter 4.2, equations 2 to 10): along the line of
/// the first two centres by equation 9, across it by equation 10. When the circles do not meet in one point
/// the result is the common point of their three radical lines. Any one unit of length.
///
/// CoincidentCentres or CollinearCentres where the published program divides by zero.
std::expected<Point2, CircleGeometryError> trilaterate(const std::array<Circle, 3>& circles);

/// Where the line a1-a2 meets the line b1-b2 (seed, chapter 7.2.4, equations 16 and 17). The antenna
/// positions half a turn apart span lines through the centre of rotation. Any one unit of length.
///
/// ParallelLines when the denominator of both equations vanishes.
std::expected<Point2, CircleGeometryError> intersectLines(Point2 a1, Point2 a2, Point2 b1, Point2 b2);

/// Height of the triangle over its longest side, divided by that side: 0 for collinear or equal points,
/// 0.5 for a right isosceles triangle, 0.87 for an equilateral one.
double flatness(Point2 a, Point2 b, Point2 c);

} // namespace agv::estimation
