// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/jog.h"

#include <string>

namespace agv::session {

/// What stands behind "Stopped: " or "It does not drive: "; plain English, without a full stop.
std::string sentenceOf(JogReason reason);

/// "dock", "undock", "dock to charge"
std::string nameOf(DockOrder order);

/// A press that ended as presses should needs no word.
bool isOrdinary(JogReason reason);

} // namespace agv::session
