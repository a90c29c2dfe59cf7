// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/position_spread.h"

#include <algorithm>
#include <array>

namespace agv::estimation {

std::optional<double> PositionSpread::r95_m() const
{
    const std::span<const Point2> positions = m_positions.values();
    if (positions.size() < leastForR95)
        return std::nullopt;
    Point2 mean;
    for (const Point2& position : positions) {
        mean.x += position.x / static_cast<double>(positions.size());
        mean.y += position.y / static_cast<double>(positions.size());
    }
    std::array<double, kept> radii{};
    std::ranges::transform(positions, radii.begin(), [&](Point2 p) { return distance(p, mean); });
    // The smallest radius with at least 95 % of them inside.
    const std::size_t outermost = (positions.size() * 95 + 99) / 100 - 1;
    const auto at = radii.begin() + static_cast<std::ptrdiff_t>(outermost);
    std::nth_element(radii.begin(), at, radii.begin() + static_cast<std::ptrdiff_t>(positions.size()));
    return *at;
}

} // namespace agv::estimation
