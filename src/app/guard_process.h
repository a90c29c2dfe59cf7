// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace agv::app {

/// The watchdog process: holds a second descriptor of every robot's connection and says "interrupt, zero
/// speed" on all of them, zero five times, when the console dies (the channel on standard input ends) or does
/// not run for a second. It ends with the console, however that ended. Needs no application object.
/// Returns the exit status.
int runGuard();

} // namespace agv::app
