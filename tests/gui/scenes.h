// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/snapshot.h"

#include <memory>

/// Plants and snapshots written by hand, for tests and pictures of the window.
namespace agv::scenes {

/// 3 m x 4 m, 1,271 floor tags, four stations, four docks, four AGVs.
PlantLayout wholePlant();

PlantSnapshot idle();     ///< nothing open yet
PlantSnapshot linksUp();  ///< everything connected, no position known
PlantSnapshot turning();  ///< AGV 1 at stop 4 of 9, with a preview
PlantSnapshot finished(); ///< AGV 1 found, the others known from before
PlantSnapshot ambiguous();
PlantSnapshot linkLost(); ///< AGV 1 lost while turning

/// A clean result: 1,204 mm, 873 mm, 92.3 degrees; steps of 43.1 degrees at 1,125 ms.
std::shared_ptr<TurnEstimate> goodEstimate();

} // namespace agv::scenes
