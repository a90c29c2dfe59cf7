// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/text_lines.h"
#include "recording/turn_file.h"

namespace agv::recording {

/// A raw capture: the lines of the reader as received, and marks that say where the robot stood.
/// CaptureWriter writes it; a file made by hand needs the "# stop" lines only.
///
///     # agv-capture 1
///     # turn step_deg=45 turn_time_ms=1125 rotation=ccw kind=timed at_ms=0
///     # stop 1 at_ms=200
///     @212.5 SCAN:+UID=E00401503A5BDAE4,+RSSI=3/2
///     # moving at_ms=1500
///     # stop 2 at_ms=2700
///     # end at_ms=30000
///
///  * "# turn" begins a turn; its parameters, all optional, are those of JSON lines. So does a "# stop"
///    outside a turn, and one with a number that is not higher than the stop before.
///  * "# stop N" (1-based; without N the next one): reads from here on count for this stop. A stop that is
///  left
///    out has no reads.
///  * "# retake N": the reads of stop N are thrown away, the following ones take their place.
///  * "# moving": reads from here on are kept as movingReads of the stop before and not used.
///  * "# end": the turn is complete. "# aborted": the turn is none.
///  * "@ms" before a line: when its first byte arrived, milliseconds since the beginning of the capture.
///  * Lines that are no complete read (incomplete reads, OK, noise) and other "#" lines are passed over.
std::vector<RecordedTurn> readCaptureTurns(const std::vector<TextLine>& lines,
                                           const TurnFileOptions& options);

/// Is the line a "# turn" or "# stop" mark?
bool isCaptureMark(std::string_view line);

} // namespace agv::recording
