// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"

namespace agv::gui {

/// What the last turn of an AGV found, while the AGV still stands there or turns; else null.
const TurnEstimate* shownEstimate(const AgvSnapshot& agv);

} // namespace agv::gui
