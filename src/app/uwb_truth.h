// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/range_table.h"
#include "recording/truth_table.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace agv::app {

/// Bytes; a longer file of true places is refused.
inline constexpr std::size_t largestTruthFile = std::size_t{64} << 20U;

/// Where a tag truly was at some time.
struct TrueAt {
    double x_m = 0.0;
    double y_m = 0.0;
    std::optional<double> z_m;
    const recording::TruePlace* row = nullptr; ///< the one it is of, or the earlier of two
};

/// The truth of the rows of a range table: found by the columns that both have, the tag and the time; between
/// two times it lies on the straight line.
class TruthIndex {
public:
    /// `truth` must outlive it. BadInput "LINE: ..." when two rows without a time speak of the same, which
    /// is so when the table lacks a column (such as point) that tells them apart.
    static Result<TruthIndex> make(const recording::TruthTable& truth, const recording::RangeTable& table);

    /// The truth for a row of the table; nothing when it is not known at that time.
    std::optional<TrueAt> at(const recording::RangeTable& table, std::size_t row, double time_s) const;
    /// The truth for a read of floor tags, which has neither a UWB tag nor columns: that of the only tag.
    std::optional<TrueAt> at(double time_s) const;

private:
    using Places = std::vector<const recording::TruePlace*>;
    static std::optional<TrueAt> between(const Places& places, double time_s);
    const Places* placesOf(const recording::RangeTable& table, std::size_t row) const;

    std::vector<std::size_t> m_extraColumns; ///< of the range table, those that the truth has, too
    std::map<std::pair<std::string, std::optional<int>>, Places> m_places;
};

} // namespace agv::app
