// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/file_problem.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// Where a tag truly was.
struct TruePlace {
    int line = 0;                 ///< of the file, 1-based
    std::optional<double> time_s; ///< nothing: always
    std::optional<int> tag;       ///< nothing: any
    double x_m = 0.0;             ///< plant frame
    double y_m = 0.0;
    std::optional<double> z_m;        ///< height above the floor
    std::vector<std::string> columns; ///< TruthTable::otherColumns.size() fields, as written
};

/// Places known from surveying or motion capture.
struct TruthTable {
    std::vector<std::string> otherColumns; ///< such as point or run
    std::vector<TruePlace> places;         ///< in the order of the file
    FileProblems problems;

    std::optional<std::size_t> otherColumn(std::string_view name) const;
};

/// A table with the columns x_m, y_m and, if it has them, z_m, t_s, tag; or, for several tags in one row,
/// tag0_x, tag0_y, tag0_z, tag1_x, ... in metres. body_z_m is the height of tags that have none of their own.
/// All other columns are kept. A height may be left out. A bad row is a problem and never stops the others;
/// an empty place is passed over. BadInput "LINE: ..." when there is no place at all.
Result<TruthTable> readTruthCsv(std::string_view text);

} // namespace agv::recording
