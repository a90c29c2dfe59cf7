// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/start_poses.h"

#include "simulation/collision_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace agv::simulation {
namespace {

constexpr double margin_m = 0.02;
constexpr int tries = 20'000;
constexpr int directions = 8;
constexpr std::ptrdiff_t tagsWanted = 2;

struct Box {
    Point2 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    Point2 high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
};

Box boxOf(const std::vector<FloorTag>& tags)
{
    Box box;
    for (const FloorTag& tag : tags) {
        box.low = {std::min(box.low.x, tag.position.x), std::min(box.low.y, tag.position.y)};
        box.high = {std::max(box.high.x, tag.position.x), std::max(box.high.y, tag.position.y)};
    }
    return box;
}

bool canBeCalibrated(const PlantLayout& plant, const AgvConfig& agv, Point2 centre)
{
    const double range = plant.rssiTable.empty() ? 0.0 : plant.rssiTable.front().upperEdge;
    for (int i = 0; i < directions; ++i) {
        const Point2 antenna =
            fromVehicleFrame({centre, 2.0 * std::numbers::pi * i / directions}, agv.antenna);
        const auto inRange = std::ranges::count_if(
            plant.floorTags, [&](const FloorTag& tag) { return distance(tag.position, antenna) <= range; });
        if (inRange < tagsWanted)
            return false;
    }
    return true;
}

} // namespace

Result<std::vector<Pose2>> randomStartPoses(const PlantLayout& plant, SplitMix64& random)
{
    const CollisionMap map(plant);
    const Box box = boxOf(plant.floorTags);
    std::vector<Pose2> poses;
    const auto isFree = [&](const AgvConfig& agv, Point2 centre) {
        if (map.clearance(centre, agv.radius_m) < margin_m)
            return false;
        for (std::size_t i = 0; i < poses.size(); ++i)
            if (distance(poses[i].position, centre) < agv.radius_m + plant.agvs[i].radius_m + margin_m)
                return false;
        return canBeCalibrated(plant, agv, centre);
    };
    for (const AgvConfig& agv : plant.agvs) {
        bool found = false;
        for (int i = 0; i < tries && !found && !plant.floorTags.empty(); ++i) {
            const Point2 centre{random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y)};
            found = isFree(agv, centre);
            if (found)
                poses.push_back({centre, wrapAngle(random.uniform(0.0, 2.0 * std::numbers::pi))});
        }
        if (!found)
            return failure(ErrorCode::NotFound, "no room for AGV " + std::to_string(agv.id.number) +
                                                    " on the tagged floor of '" + plant.name +
                                                    "'; give it fewer AGVs or obstacles, or more floor tags");
    }
    return poses;
}

} // namespace agv::simulation
