// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/uncertainty.h"

#include <algorithm>
#include <cmath>

namespace agv::model {

Ellipse95 ellipse95(const PoseCovariance& covariance)
{
    return ellipse95(PositionCovariance{covariance[0], covariance[1], covariance[4]});
}

Ellipse95 ellipse95(const PositionCovariance& covariance)
{
    const auto [xx, xy, yy] = covariance;
    const double mean = 0.5 * (xx + yy);
    const double spread = std::hypot(0.5 * (xx - yy), xy);
    const double scale = chiSquare95TwoDof;
    return {std::sqrt(std::max(0.0, mean + spread) * scale), std::sqrt(std::max(0.0, mean - spread) * scale),
            0.5 * std::atan2(2.0 * xy, xx - yy)};
}

} // namespace agv::model
