// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line.h"

namespace agv::app {

/// Whether the window could be shown: 0, or 1 with the reason in one line on standard error.
/// @pre there is no application object
int runHasDisplay();

/// The operator's window on a plant. Makes the application object. Returns the exit status: 0 closed by the
/// operator, 1 it could not start
/// (no display, no plant), 130 or 143 ended by a signal, the robots stopped.
int runWindow(const WindowArguments& arguments, int& argc, char** argv);

} // namespace agv::app
