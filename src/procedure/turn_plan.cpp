// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/turn_plan.h"

#include "procedure/dwell_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace agv::procedure {
namespace {

Duration expectedDwellOf(const TurnParameters& p)
{
    if (!p.adaptiveDwell)
        return durationFromSeconds(p.maxDwell_s);
    // Half of the stops have a tag that is met late or once only.
    const Duration typical = 2 * DwellRule::quietTime + std::chrono::milliseconds(100);
    return std::clamp(typical, durationFromSeconds(p.minDwell_s), durationFromSeconds(p.maxDwell_s));
}

} // namespace

TurnPlan::TurnPlan(const TurnParameters& p)
    : m_stopCount(p.stopsPerTurn + 1),
      m_rotation(p.rotation),
      m_stepAngle(2.0 * std::numbers::pi / p.stopsPerTurn),
      m_stepTime(durationFromSeconds(p.turnTime_s * m_stepAngle / radFromDeg(45.0))),
      m_settle(durationFromSeconds(p.settle_s)),
      m_longestDwell(durationFromSeconds(p.maxDwell_s)),
      m_expectedDwell(expectedDwellOf(p)),
      m_wheelSpeed(p.wheelSpeed_m_s)
{}

Duration TurnPlan::silenceLimit() const
{
    return ((m_stopCount - 1) / 2) * (m_stepTime + m_settle + m_longestDwell);
}

WheelSpeeds TurnPlan::wheelSpeeds(Rotation rotation) const
{
    const double speed = signOf(rotation) * m_wheelSpeed;
    return {-speed, speed};
}

DriveSegment TurnPlan::segment(int fromStop, int toStop) const
{
    const auto wholeDegrees = [this](int stop) { return std::round(stop * degFromRad(m_stepAngle)); };
    const double angle = signOf(m_rotation) * radFromDeg(wholeDegrees(toStop) - wholeDegrees(fromStop));
    return {wheelSpeeds(angle > 0.0 ? Rotation::CounterClockwise : Rotation::Clockwise), 0.0, angle};
}

} // namespace agv::procedure
