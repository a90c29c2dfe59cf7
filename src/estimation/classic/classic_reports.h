// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/turn.h"
#include "estimation/turn_solver.h"

#include <optional>
#include <vector>

namespace agv::estimation {

/// Reports of a turn without a pose: tags read, known and unknown.
std::vector<StopReport> reportsWithoutPose(const TurnRecord& record, const TagMap& positions);

/// Reports of a solved turn. A stop without a trilaterated antenna (`antennas`, m) gets the point of the
/// circle where the nominal turn puts it. Tags within reach of the antenna are expected; read tags further
/// than the reach and three times `scatter` (m) are misplaced.
std::vector<StopReport> reportsAround(const TurnEstimate& estimate, const TurnRecord& record,
                                      const TurnContext& context, const TagMap& positions,
                                      const std::vector<std::optional<Point2>>& antennas, double scatter);

} // namespace agv::estimation
