// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/range_measurement.h"
#include "core/result.h"
#include "recording/file_problem.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// Ranges of a file, in its order, with what else the file says of each.
struct RangeTable {
    std::vector<RangeMeasurement> ranges;
    std::vector<std::string> extraColumns; ///< such as point or run
    std::vector<std::string> extras;       ///< extraColumns.size() for each range, as written in the file
    std::size_t notMeasured = 0;           ///< rows without a range: empty, nan, zero or negative
    FileProblems problems;

    /// @pre range < ranges.size(), column < extraColumns.size()
    std::string_view extra(std::size_t range, std::size_t column) const
    {
        return extras[range * extraColumns.size() + column];
    }
    std::optional<std::size_t> extraColumn(std::string_view name) const;
};

/// A table with the columns t_s, tag, anchor, range_m in any order and, if it has them, seq, kind
/// (tag-anchor, anchor-anchor) and period_s. All others are carried through. A bad row is a problem and never
/// stops the others. BadInput when a column is missing or no row can be read.
Result<RangeTable> readRangeCsv(std::string_view text);

/// Is the text's header one of a range table?
bool looksLikeRangeCsv(std::string_view text);

/// The table, every number with all its digits; readRangeCsv reads back the same. seq, kind and period_s are
/// written when a range has them.
std::string writeRangeCsv(const RangeTable& table);

} // namespace agv::recording
