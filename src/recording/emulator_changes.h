// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/turn.h"

#include <span>
#include <vector>

namespace agv::recording {

/// Readings of each stop in order of the lines.
using StopReadings = std::vector<std::vector<std::pair<TagUid, int>>>;

/// Can the lines of a turn be changes only? They cannot when the first line of any tag has RSSI 0, or when a
/// stop has two lines of one tag.
bool canBeChangesOnly(const StopReadings& stops);

/// The stops that a log of changes describes; the rules are in emulator_turns.h.
/// The emulator goes through the tags by number. Tags of `plant` not known to be read go to unknownIfUnseen.
std::vector<TurnStop> stopsFromChanges(const StopReadings& stops, std::span<const FloorTag> plant);

} // namespace agv::recording
