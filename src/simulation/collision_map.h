// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"

#include <vector>

namespace agv::simulation {

/// What an AGV can run into and does not move: the edges of the plant, stations and obstacles. A field so
/// small that a robot could not turn on it is a board lying on an open floor: it has no edges.
class CollisionMap {
public:
    explicit CollisionMap(const PlantLayout& plant);

    /// Whether a disc lies within the edges, if there are any.
    bool holds(Point2 centre, double radius_m) const;

    /// Distance (m) from a disc to the nearest of them; negative when they overlap.
    double clearance(Point2 centre, double radius_m) const;

private:
    double toEdges(Point2 centre) const; ///< infinite without edges

    bool m_hasEdges = false;
    Point2 m_low; ///< south-west corner
    Point2 m_high;
    std::vector<std::vector<Point2>> m_outlines;
};

/// Corners of a station, counter-clockwise.
std::vector<Point2> outlineOf(const Station& station);

} // namespace agv::simulation
