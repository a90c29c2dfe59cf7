// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/collision_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace agv::simulation {
namespace {

double distanceToSegment(Point2 p, Point2 a, Point2 b)
{
    const Point2 along = b - a;
    const double length2 = along.x * along.x + along.y * along.y;
    if (length2 == 0.0)
        return distance(p, a);
    const Point2 toP = p - a;
    const double t = std::clamp((toP.x * along.x + toP.y * along.y) / length2, 0.0, 1.0);
    return distance(p, a + t * along);
}

bool isInside(Point2 p, const std::vector<Point2>& outline)
{
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Point2 a = outline[i];
        const Point2 b = outline[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

/// Negative inside.
double distanceToOutline(Point2 p, const std::vector<Point2>& outline)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
        nearest = std::min(nearest, distanceToSegment(p, outline[j], outline[i]));
    return isInside(p, outline) ? -nearest : nearest;
}

} // namespace

std::vector<Point2> outlineOf(const Station& station)
{
    const double x = 0.5 * station.width_m;
    const double y = 0.5 * station.depth_m;
    return {fromVehicleFrame(station.pose, {-x, -y}), fromVehicleFrame(station.pose, {x, -y}),
            fromVehicleFrame(station.pose, {x, y}), fromVehicleFrame(station.pose, {-x, y})};
}

CollisionMap::CollisionMap(const PlantLayout& plant)
    : m_low(plant.origin),
      m_high(plant.origin + Point2{plant.width_m, plant.height_m})
{
    double widest = 0.0;
    for (const AgvConfig& agv : plant.agvs)
        widest = std::max(widest, 2.0 * agv.radius_m);
    m_hasEdges = std::min(plant.width_m, plant.height_m) > 2.0 * widest;
    for (const Station& station : plant.stations)
        m_outlines.push_back(outlineOf(station));
    for (const Obstacle& obstacle : plant.obstacles)
        if (obstacle.outline.size() >= 3)
            m_outlines.push_back(obstacle.outline);
}

double CollisionMap::toEdges(Point2 centre) const
{
    return m_hasEdges
               ? std::min({centre.x - m_low.x, centre.y - m_low.y, m_high.x - centre.x, m_high.y - centre.y})
               : std::numeric_limits<double>::infinity();
}

bool CollisionMap::holds(Point2 centre, double radius_m) const { return toEdges(centre) >= radius_m; }

double CollisionMap::clearance(Point2 centre, double radius_m) const
{
    double nearest = toEdges(centre);
    for (const auto& outline : m_outlines)
        nearest = std::min(nearest, distanceToOutline(centre, outline));
    return nearest - radius_m;
}

} // namespace agv::simulation
