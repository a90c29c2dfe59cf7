// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// Anchors as a table with the columns anchor, x_m, y_m, z_m in any order and, if wanted, label and shown (1
/// or 0); other columns are ignored. Without a label an anchor is A0, A1, ... BadInput "LINE: ..." says what
/// is wrong; an id used twice names both lines.
Result<std::vector<UwbAnchor>> readAnchorCsv(std::string_view text);

/// The table; readAnchorCsv reads back exactly these anchors, but for labels that begin like a formula.
std::string writeAnchorCsv(const std::vector<UwbAnchor>& anchors);

} // namespace agv::recording
