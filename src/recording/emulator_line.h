// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/tag_numbers.h"

#include <expected>
#include <optional>
#include <string>
#include <string_view>

namespace agv::recording {

/// One reading of an emulator file; the formats are in emulator_turns.h.
struct EmulatorReading {
    int line = 0;           ///< 1-based
    double angle_deg = 0.0; ///< turned since the first stop, >= 0
    TagUid tag;
    int rssi = 0; ///< 0..7
};

/// A reading, nothing (a line to pass over), or why the line is wrong.
std::expected<std::optional<EmulatorReading>, std::string> parseEmulatorLine(std::string_view line,
                                                                             const TagNumbers& numbers);

/// Without the literal "<\r>" and blanks at the end, as the old programs left them.
std::string_view withoutLiteralReturn(std::string_view line);

} // namespace agv::recording
