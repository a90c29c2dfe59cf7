// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/file_problem.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// What a reader of floor tags said at one time.
struct FloorReadRow {
    int line = 0; ///< of the file, 1-based
    double time_s = 0.0;
    std::vector<std::string> uids; ///< of the tags read, as written; hexadecimal, whole or the last digits
    std::optional<double> x_m;     ///< a position that is already computed
    std::optional<double> y_m;
};

struct FloorReadTable {
    std::vector<FloorReadRow> rows; ///< rising times
    FileProblems problems;
};

/// A table with the column t_s and either x_m, y_m (positions from floor tags) or uid (one tag a row; rows of
/// the same time belong together) or uid1, uid2, ... (all tags of a reading). Rows without a tag or a
/// position are passed over; a bad row, or one that steps back in time, is a problem and never stops the
/// others. BadInput "LINE: ..." when a column is missing or no row can be read.
Result<FloorReadTable> readFloorReadCsv(std::string_view text);

/// A table of the places of floor tags: uid (or uid_tail) and x_mm, y_mm or x_m, y_m.
struct TagPlace {
    std::string uid; ///< as written, in capitals
    double x_m = 0.0;
    double y_m = 0.0;
};
struct TagPlaceTable {
    std::vector<TagPlace> tags;
    FileProblems problems;
};
Result<TagPlaceTable> readTagPlaceCsv(std::string_view text);

} // namespace agv::recording
