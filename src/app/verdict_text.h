// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "core/turn.h"

#include <optional>
#include <string>

namespace agv::app {

/// The verdict of a turn as sentences: where the AGV stands and how surely (95 %), what to mind, which
/// sleeptime to take. `label`: "AGV 1".
std::string verdictText(const std::string& label, const TurnSnapshot& turn);

/// Half axis of the 95 % ellipse of a pose, m, and 1.96 standard deviations of its heading, rad.
struct Uncertainty {
    double position_m = 0.0;
    double heading = 0.0;
};
Uncertainty uncertaintyOf(const TurnEstimate& estimate);

/// "1,204": whole number with commas between the thousands.
std::string thousands(double value);

} // namespace agv::app
