// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anchor_geometry.h"

#include <cmath>

namespace agv {

std::optional<double> horizontalDilution(const std::vector<UwbAnchor>& anchors, Point2 place, double height_m)
{
    constexpr double nearest_m = 1e-6; // right at the anchor there is no direction
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const UwbAnchor& anchor : anchors) {
        const Point2 offset = place - Point2{anchor.x, anchor.y};
        const double range = std::hypot(offset.x, offset.y, height_m - anchor.z);
        if (!(range > nearest_m))
            continue;
        const Point2 direction = (1.0 / range) * offset;
        xx += direction.x * direction.x;
        xy += direction.x * direction.y;
        yy += direction.y * direction.y;
    }
    const double determinant = xx * yy - xy * xy;
    const double variance = (xx + yy) / determinant;
    if (!(determinant > 0.0) || !(variance <= worstDilution * worstDilution))
        return std::nullopt;
    return std::sqrt(variance);
}

} // namespace agv
