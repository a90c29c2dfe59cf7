// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace agv::recording {

/// A text as a CSV field (RFC 4180): quoted when it has to be. Text that begins like a formula (= + - @, tab,
/// CR) gets an apostrophe in front, so that a spreadsheet shows it and does not compute it.
std::string csvField(std::string_view text);

/// Fields, already escaped, as a row with CR LF.
std::string csvLine(std::span<const std::string> fields);

} // namespace agv::recording
