// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/random.h"

#include <vector>

namespace agv::simulation {

/// A random pose for each AGV of the plant, clear of edges, stations, obstacles and the other AGVs, where the
/// antenna has at least two tags in range all around an initialisation turn. NotFound: there is no room for
/// an AGV.
Result<std::vector<Pose2>> randomStartPoses(const PlantLayout& plant, SplitMix64& random);

} // namespace agv::simulation
