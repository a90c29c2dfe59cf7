// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"
#include "recording/range_table.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// A position that the existing program computed, for comparison.
struct LoggedFix {
    double time_s = 0.0; ///< as RangeMeasurement::time_s
    int tag = 0;
    int sequence = 0; ///< RSEQ of the exchange it is of
    std::array<double, 3> position_m{};
    friend bool operator==(const LoggedFix&, const LoggedFix&) = default;
};

/// What a log of the program DecaRangeRTLS holds.
struct DecaRangeLog {
    /// RR and RA records; extra columns nranges and corrected_m (empty for RA). range_m is the range without
    /// the program's correction table, corrected_m with it.
    RangeTable table;
    std::vector<LoggedFix> fixes;   ///< LE records
    std::vector<UwbAnchor> anchors; ///< AP records, the last one of each anchor, rising ids
    std::size_t stepsBack = 0;      ///< exchanges more than 1 s before the one before: joined recordings
    std::size_t otherRecords = 0;   ///< NL, RM, RS, TS and kinds not known
    std::size_t otherLines = 0;     ///< lines without a record, such as the binary version
};

/// Reads a log. Records begin with "T:hhmmsszzz:", the first one of a line with any digits; several may stand
/// in one line, and bytes of any value between them.
///
/// Times are the time of day in s since midnight, going on behind it; the date is not known. The rows of one
/// exchange (tag, RSEQ, nranges) may carry different or impossible times: all get the median of the possible
/// ones, or the time of the exchange before. No report period is taken off, it is not known.
/// A bad record is a problem and never stops the others. BadInput when there is no record at all.
Result<DecaRangeLog> readDecaRangeLog(std::string_view text);

bool looksLikeDecaRangeLog(std::string_view text);

} // namespace agv::recording
