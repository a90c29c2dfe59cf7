// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <vector>

namespace agv::estimation {

/// Where a known antenna stands as seen from the centre.
struct StopBearing {
    double stop = 0.0;    ///< 0-based
    double bearing = 0.0; ///< rad, centre to antenna
    double radius_m = 0.0;
};

/// Mean distance of the antennas from the centre, m.
double meanRadius(const std::vector<StopBearing>& bearings);

/// Standard deviation of a trilaterated antenna per axis, m: the scatter of the radii about their mean, at
/// least 15 mm (what the choice of interval edges costs without any noise; the study's section A.2).
double antennaScatter(const std::vector<StopBearing>& bearings);

/// Covariance of centre and heading (m, rad) built from four antennas of standard deviation `scatter` (m per
/// axis), to first order; `mountingSd` (rad) is added to the heading.
PoseCovariance classicCovariance(const std::array<Point2, 4>& antennas, double scatter, double mountingSd);

} // namespace agv::estimation
