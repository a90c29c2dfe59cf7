// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace agv::app {

/// Why no window can be shown here, as the middle of a sentence; empty when one can. Qt ends the program when
/// its display is not there, so a child process tries it first. The platform that QT_QPA_PLATFORM names
/// ("offscreen", "minimal") needs no display. Takes ten seconds when a display accepts but never answers.
/// @pre the process has one thread and no application object
std::optional<std::string> displayTrouble();

} // namespace agv::app
