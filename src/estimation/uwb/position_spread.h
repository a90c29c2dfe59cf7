// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "estimation/recent_values.h"

#include <optional>

namespace agv::estimation {

/// How far the last positions of a tag lie apart: repeatability of a tag that stands, not accuracy.
class PositionSpread {
public:
    static constexpr std::size_t kept = 200;
    static constexpr std::size_t leastForR95 = 20;

    void add(Point2 position) { m_positions.add(position); } ///< m
    void clear() { m_positions.clear(); }
    /// Radius about the mean of the positions that holds 95 % of them, m; nothing while there are too few.
    std::optional<double> r95_m() const;

private:
    RecentValues<Point2, kept> m_positions;
};

} // namespace agv::estimation
