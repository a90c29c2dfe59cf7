// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace agv {

/// Surveyed floor tags as a table: a header with the columns uid, x_mm, y_mm and, if wanted, number, in any
/// order, then one tag per line. Fields are separated by commas, or by semicolons as spreadsheets of
/// countries with a decimal comma write them; then numbers may have a decimal comma. Without a number a
/// tag gets its place in the table. BadInput names "name:line:", what is wrong and what to do; a UID used
/// twice names both lines.
Result<std::vector<FloorTag>> readTagCsv(std::string_view text, std::string_view name);

/// The table with commas and decimal points; readTagCsv() reads back exactly these tags.
std::string writeTagCsv(const std::vector<FloorTag>& tags);

} // namespace agv
