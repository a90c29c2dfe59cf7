// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"

#include <string_view>
#include <vector>

namespace agv::app {

/// The seed's test field: 3 x 3 tags at 100 mm with the UIDs of table 13, tag 1 at the origin.
std::vector<FloorTag> seedTestField();

/// Tags of "COLUMNSxROWS" (each 1 to 1000) at `pitch` (m) from the origin, numbered column by column. "3x3"
/// has the UIDs of the seed's test field, any other artificial ones. BadInput for anything else.
Result<std::vector<FloorTag>> parseField(std::string_view text, double pitch);

} // namespace agv::app
