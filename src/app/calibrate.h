// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line.h"

namespace agv::app {

/// Initialisation turns over the links, without a window: progress on standard error, a verdict per AGV on
/// standard output, results and captures in a folder. Needs an application object. Returns the exit status:
/// 0 every turn gave a pose, 1 one did not, 2 what was asked for does not suit the plant (nothing was done),
/// 130 or 143 ended by a signal, the robots stopped.
int runCalibrate(const CalibrateArguments& arguments);

} // namespace agv::app
