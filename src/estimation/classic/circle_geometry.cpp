// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/circle_geometry.h"

#include <algorithm>

namespace agv::estimation {

namespace {

double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }

/// Sine of the angle below which two directions count as one; far below any surveyed geometry, far above
/// rounding.
constexpr double parallelSine = 1e-9;

} // namespace

const char* toText(CircleGeometryError error)
{
    switch (error) {
    case CircleGeometryError::CoincidentCentres:
        return "two circles share their centre";
    case CircleGeometryError::CollinearCentres:
        return "the centres of the circles lie on one line";
    case CircleGeometryError::ParallelLines:
        return "the lines do not meet";
    }
    return "unknown";
}

std::expected<Point2, CircleGeometryError> trilaterate(const std::array<Circle, 3>& circles)
{
    const auto& [first, second, third] = circles;
    const Point2 along = second.centre - first.centre;
    const Point2 ax = third.centre - first.centre; // equation 4
    const double d = std::hypot(along.x, along.y); // equation 2
    if (!(d > 0.0))
        return std::unexpected(CircleGeometryError::CoincidentCentres);
    if (!(std::abs(cross(along, ax)) > parallelSine * d * std::hypot(ax.x, ax.y)))
        return std::unexpected(CircleGeometryError::CollinearCentres);

    const Point2 ex = (1.0 / d) * along;                   // equation 3
    const double i = dot(ex, ax);                          // equation 5
    const Point2 ay = ax - i * ex;                         // equation 6
    const Point2 ey = (1.0 / std::hypot(ay.x, ay.y)) * ay; // equation 7
    const double j = dot(ey, ax);                          // equation 8
    const double r1 = first.radius * first.radius;
    const double r2 = second.radius * second.radius;
    const double r3 = third.radius * third.radius;
    const double x = (r1 - r2 + d * d) / (2.0 * d);                       // equation 9
    const double y = (r1 - r3 + i * i + j * j) / (2.0 * j) - i * (x / j); // equation 10
    return first.centre + x * ex + y * ey;
}

std::expected<Point2, CircleGeometryError> intersectLines(Point2 a1, Point2 a2, Point2 b1, Point2 b2)
{
    const Point2 a = a2 - a1;
    const Point2 b = b2 - b1;
    const double denominator = cross(a, b);
    if (!(std::abs(denominator) > parallelSine * std::hypot(a.x, a.y) * std::hypot(b.x, b.y)))
        return std::unexpected(CircleGeometryError::ParallelLines);
    // Equations 16 and 17 taken relative to a1, where they lose no digits to large coordinates.
    return a1 + (cross(b1 - a1, b) / denominator) * a;
}

double flatness(Point2 a, Point2 b, Point2 c)
{
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    return longest > 0.0 ? std::abs(cross(b - a, c - a)) / (longest * longest) : 0.0;
}

} // namespace agv::estimation
