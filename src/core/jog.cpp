// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/jog.h"

#include <algorithm>
#include <cmath>

namespace agv {
namespace {

constexpr double innerWheel = 0.4;

} // namespace

WheelSpeeds jogSpeeds(JogDirection direction, double speed_m_s)
{
    if (direction.forward == 0)
        return {-direction.left * speed_m_s, direction.left * speed_m_s};
    const double outer = direction.forward * speed_m_s;
    const double inner = outer * innerWheel;
    return {direction.left > 0 ? inner : outer, direction.left < 0 ? inner : outer};
}

WheelSpeeds slowedTo(const WheelSpeeds& speeds, double limit_m_s)
{
    if (!std::isfinite(speeds.left) || !std::isfinite(speeds.right))
        return {};
    const double fastest = std::max(std::abs(speeds.left), std::abs(speeds.right));
    if (fastest <= limit_m_s)
        return speeds;
    const double factor = limit_m_s / fastest;
    return {speeds.left * factor, speeds.right * factor};
}

} // namespace agv
