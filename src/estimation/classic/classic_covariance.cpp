// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/classic_covariance.h"

#include "core/units.h"
#include "estimation/classic/circle_geometry.h"

#include <algorithm>

namespace agv::estimation {

namespace {

using PoseVector = std::array<double, 3>;

PoseVector poseOf(const std::array<Point2, 4>& antennas)
{
    const Point2 centre =
        intersectLines(antennas[0], antennas[1], antennas[2], antennas[3]).value_or(antennas[0]);
    return {centre.x, centre.y, std::atan2(antennas[0].y - centre.y, antennas[0].x - centre.x)};
}

/// Central difference of the pose by one coordinate of one antenna.
PoseVector derivative(std::array<Point2, 4> antennas, std::size_t antenna, double Point2::* axis)
{
    constexpr double h = 1e-6; // m: rounding and curvature both stay below 1e-6 of the result
    antennas[antenna].*axis += h;
    const PoseVector above = poseOf(antennas);
    antennas[antenna].*axis -= 2.0 * h;
    const PoseVector below = poseOf(antennas);
    return {(above[0] - below[0]) / (2.0 * h), (above[1] - below[1]) / (2.0 * h),
            wrapAngle(above[2] - below[2]) / (2.0 * h)};
}

} // namespace

double meanRadius(const std::vector<StopBearing>& bearings)
{
    double sum = 0.0;
    for (const StopBearing& b : bearings)
        sum += b.radius_m;
    return bearings.empty() ? 0.0 : sum / static_cast<double>(bearings.size());
}

double antennaScatter(const std::vector<StopBearing>& bearings)
{
    constexpr double leastScatter_m = 0.015;
    if (bearings.size() < 2)
        return leastScatter_m;
    const double mean = meanRadius(bearings);
    double sum = 0.0;
    for (const StopBearing& b : bearings)
        sum += (b.radius_m - mean) * (b.radius_m - mean);
    return std::max(leastScatter_m, std::sqrt(sum / static_cast<double>(bearings.size() - 1)));
}

PoseCovariance classicCovariance(const std::array<Point2, 4>& antennas, double scatter, double mountingSd)
{
    PoseCovariance covariance{};
    for (std::size_t antenna = 0; antenna < antennas.size(); ++antenna) {
        for (double Point2::* const axis : {&Point2::x, &Point2::y}) {
            const PoseVector d = derivative(antennas, antenna, axis);
            for (std::size_t row = 0; row < 3; ++row) {
                for (std::size_t column = 0; column < 3; ++column)
                    covariance[3 * row + column] += scatter * scatter * d[row] * d[column];
            }
        }
    }
    covariance[8] += mountingSd * mountingSd;
    return covariance;
}

} // namespace agv::estimation
