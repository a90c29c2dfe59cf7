// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/range_table.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace agv::app {

/// Ranges of one tag that belong to one moment.
struct UwbReport {
    double time_s = 0.0;
    int tag = 0;                   ///< -1: a moment of floor tags, without ranges
    std::size_t track = 0;         ///< reports that one filter takes, one after the other
    std::vector<std::size_t> rows; ///< of the table, one per anchor; empty only without a tag
};

/// The reports of a file in its order.
struct ReportList {
    std::vector<UwbReport> reports;
    std::vector<std::size_t> groupColumns; ///< of RangeTable::extraColumns: a new value is a new track
    std::size_t tracks = 0;

    /// The values of the group columns, which name what the report belongs to; empty without such columns.
    std::string groupOf(const recording::RangeTable& table, const UwbReport& report) const;
};

/// Puts ranges together: those of a tag with the same sequence number or, without one, the same time, and
/// each anchor once. The time of a report is the median of its ranges' times.
///
/// Columns named in `keys` and columns called point, run or session always group. Others do when all ranges
/// of a report have one value and it lasts for several reports: a number that counts reports, or says
/// something of a single range, does not. Where time steps back by more than a second a new track begins.
ReportList groupReports(const recording::RangeTable& table, std::span<const std::string> keys);

/// True when the anchors answer one or two at a time, so that a report alone gives no position.
bool comesInTurns(const ReportList& list);

/// Reports of all anchors out of such ones: a round ends before an anchor that it has already. Its time is
/// that of its last range.
ReportList roundsOf(const recording::RangeTable& table, const ReportList& list);

} // namespace agv::app
