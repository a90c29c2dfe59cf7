// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "recording/text_lines.h"
#include "recording/turn_file.h"

#include <span>

namespace agv::recording {

/// The operator's table as CSV: one row per stop, first the tags in order of reading, then their RSSI in the
/// same order; the seed's is 8 x 14 (chapter 7.2, table 10): seven columns of tags, seven of RSSI. Cells are
/// parted by comma, semicolon or tab, may be quoted, and are empty where a stop has fewer tags. Any even
/// number of columns. Rows of titles before the first row of a table, and lines that begin with '#', are
/// passed over; an empty line ends a table and the next one begins another turn. Tags are numbers, or UIDs
/// of 16 hexadecimal digits.
///
/// The table that the window copies to the clipboard has two more columns in front, the number of the stop
/// and that of its reads; it is known by the UIDs that then stand where RSSI would begin.
///
/// In tables of seven columns of tag numbers the old program's defect is taken into account (appendix E):
/// while filling the table it compared a tag's number with the row's first RSSI as well, so a tag with that
/// number could never be recorded. Such a tag goes to TurnStop::unknownIfUnseen; it is unknown, not missed.
std::vector<RecordedTurn> readTableTurns(const std::vector<TextLine>& lines, const TurnFileOptions& options);

/// The rows as such a table without titles: seven columns of tags and seven of RSSI, or as many as the
/// fullest stop has tags; tags by their UIDs.
std::string tableText(std::span<const StopRow> rows);

/// Does the line look like a row of such a table: at least two cells, the filled ones numbers or UIDs?
bool looksLikeTableRow(std::string_view line);

} // namespace agv::recording
