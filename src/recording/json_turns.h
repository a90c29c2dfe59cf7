// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/text_lines.h"
#include "recording/turn_file.h"

namespace agv::recording {

/// JSON lines: one object per line and turn. Keys, all but `rows` optional; any other key is ignored:
///
///     rows          stops in order, each a list of reads [tag, rssi] or [tag, rssi, time_ms]; tag is a
///     number
///                   of the plant file or a string with the 16 digits of a UID; rssi 0..7
///     unknown       for each stop a list of tags whose absence means nothing
///     step_deg      nominal step, 1 <= step_deg <= 180
///     turn_time_ms  sleeptime, > 0; null: unknown
///     rotation      "ccw" or "cw", as commanded
///     kind          "timed" or "measured"
std::vector<RecordedTurn> readJsonTurns(const std::vector<TextLine>& lines, const TurnFileOptions& options);

/// A turn as such a line, without its end; tags as UIDs, times in ms since the first read. Reads that arrived
/// while turning are left out.
std::string toJsonLine(const TurnRecord& record);

} // namespace agv::recording
