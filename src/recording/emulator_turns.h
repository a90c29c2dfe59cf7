// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/text_lines.h"
#include "recording/turn_file.h"

namespace agv::recording {

/// Files of the seed's emulator (appendix A). One line per reading: the angle turned since the first stop in
/// degrees, the tag and its RSSI, filtered or as the reader sends them:
///
///     45   29  4
///     45 SCAN:+UID=29+RSSI=4<\r>
///     45 SCAN:+UID=000000000000001D,+RSSI=4/3<\r>
///
/// Tags are decimal numbers, or 16 hexadecimal digits: a number or a UID. "OK", incomplete reads
/// ("SCAN:-UID=") and empty lines are passed over. Angles never fall within a turn; a smaller angle begins
/// the next one. The step is the smallest difference of angles in the turn; every angle must be a multiple
/// of it. A stop without readings leaves no line and is filled in. The direction of rotation is left open:
/// the emulator turns counter-clockwise, but other writers of the format may not.
///
/// **All readings or changes only** (the emulator's mode 1 and 2) is told from the lines of each turn. With
/// changes only, a reading holds until the next line of its tag, and a tag that leaves the range, or falls to
/// RSSI 0, gets a line too. So RSSI 0 is never the first line of a tag; where it is, all readings are listed.
/// With changes only:
///  * a tag without a known reading may have been read with RSSI 0, which is never logged at first: it goes
///    to TurnStop::unknownIfUnseen, as all unseen tags of the plant do;
///  * the emulator has a defect: for a tag that leaves the range it should write 0, but writes the RSSI of
///  the
///    last tag in range before it. A line that repeats the tag's own RSSI, which is no change, can only be
///    that: the tag has left. A line of an already read tag that repeats the RSSI of the last tag in range
///    with a lower number (at the first tag: of the last one at the stop before) may be that: the tag becomes
///    unknown until its next line. Every other line is a reading.
std::vector<RecordedTurn> readEmulatorTurns(const std::vector<TextLine>& lines,
                                            const TurnFileOptions& options);

/// Does the line begin like one of an emulator file: an angle and a reading?
bool looksLikeEmulatorLine(std::string_view line);

} // namespace agv::recording
