// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/turn_progress.h"

#include <algorithm>

namespace agv::procedure {
namespace {

Duration plannedWork(const TurnPlan& plan)
{
    return plan.stopCount() * (plan.settleTime() + plan.expectedDwell()) +
           (plan.stopCount() - 1) * plan.stepTime() + TurnPlan::expectedSolve();
}

/// Planned work that remains when the current phase has lasted as long as it has.
Duration workLeft(const TurnPlan& plan, const TurnPosition& position)
{
    const Duration way = plan.stepTime() + plan.settleTime();
    const auto rest = [&](Duration planned) {
        return std::max(planned - position.inPhase, Duration::zero());
    };
    if (position.phase == TurnPhase::Solving)
        return rest(TurnPlan::expectedSolve());
    // While a stop is read again only the way to it and its own dwell are left.
    const int stopsAfter = position.retaking ? 0 : plan.stopCount() - 1 - position.stop;
    const Duration after = stopsAfter * (way + plan.expectedDwell()) + TurnPlan::expectedSolve();
    switch (position.phase) {
    case TurnPhase::Reading:
        return after + rest(plan.expectedDwell());
    case TurnPhase::Settling:
        return after + plan.expectedDwell() + position.stepsToGo * way + rest(plan.settleTime());
    default:
        return after + plan.expectedDwell() + (position.stepsToGo - 1) * way + plan.settleTime() +
               rest(plan.stepTime());
    }
}

} // namespace

TurnProgress progressOf(const TurnPlan& plan, const TurnPosition& position)
{
    const Duration work = plannedWork(plan);
    const Duration left = std::clamp(workLeft(plan, position), Duration::zero(), work);
    return {secondsFrom(work - left) / secondsFrom(work), left};
}

} // namespace agv::procedure
