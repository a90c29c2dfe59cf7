// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace agv::estimation {

/// The RSSI-distance relation is not monotonic: up to three distances belong to one RSSI (seed, table 8).
/// The values are those of the published program (0 max, 1 middle, 2 min).
enum class RssiBranch : std::uint8_t { Far = 0, Middle = 1, Near = 2 };

/// The distance the seed takes for an RSSI on a branch: the upper edge of the step, m. An RSSI with fewer
/// steps repeats its last one. Empty when the table has no such RSSI.
std::optional<double> branchDistance(const RssiTable& table, int rssi, RssiBranch branch);

/// Chooses a branch for each tag of one stop from the shape of the pattern the tags form (seed, chapter
/// 7.2.3, table 12, appendix K): its number of tags and of each tag's neighbours on the grid (left, right,
/// above, below). Patterns of more than seven tags are treated like seven. Both spans have one entry a tag.
std::vector<RssiBranch> chooseBranches(std::span<const int> neighbours, std::span<const int> rssi);

} // namespace agv::estimation
