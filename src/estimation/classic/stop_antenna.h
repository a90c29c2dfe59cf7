// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/turn.h"

#include <optional>
#include <span>
#include <vector>

namespace agv::estimation {

/// A tag as one stop saw it.
struct TagAtStop {
    TagUid uid;
    Point2 position; ///< m
    int rssi = 0;    ///< 0..7, the most frequent of the stop's reads; the earlier one when two tie
};

/// The known tags of a stop in order of first reading; each once. Unknown tags are left out.
std::vector<TagAtStop> tagsAtStop(const TurnStop& stop, const TagMap& positions);

/// Typical distance between neighbouring tags, m: median over `some` of the distance to the nearest of `all`.
/// Zero when there is none.
double tagPitch(std::span<const TagAtStop> some, std::span<const FloorTag> all);

/// For each tag the number of others one pitch away along the grid (within a quarter of the pitch; a diagonal
/// neighbour is further off). The grid may be turned or surveyed.
std::vector<int> neighbourCounts(std::span<const TagAtStop> tags, double pitch);

/// Steps 1 and 2 of the classic solver: antenna position, m. Empty when fewer than three tags off a line are
/// usable.
std::optional<Point2> antennaFromShape(std::span<const TagAtStop> tags, double pitch, const RssiTable& table);

} // namespace agv::estimation
