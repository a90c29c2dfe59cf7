// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "procedure/turn_plan.h"

namespace agv::procedure {

/// How far a turn has come.
struct TurnPosition {
    TurnPhase phase = TurnPhase::Idle;
    int stop = 0;      ///< 0-based stop that is being approached or read
    int stepsToGo = 0; ///< steps still to drive to it, the running one included
    bool retaking = false;
    Duration inPhase{}; ///< time since the phase began
};

struct TurnProgress {
    double share = 0.0; ///< 0..1 of the planned time
    Duration timeLeft{};
};

/// Counts every phase with its planned length, so that the bar of a turn never runs backwards however long a
/// phase really takes.
TurnProgress progressOf(const TurnPlan& plan, const TurnPosition& position);

} // namespace agv::procedure
