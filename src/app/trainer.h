// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace agv::app {

/// What `agv-console trainer` was asked for.
struct TrainerArguments {
    std::string socketPath; ///< --control
    std::string command;    ///< the words behind the options; empty: one command a line on standard input
};

/// Sends commands to a running simulated plant that was started with --control, and prints its answers, one
/// JSON line each. Returns the exit status: 0, or 1 when a command was refused or the plant cannot be
/// reached.
int runTrainer(const TrainerArguments& arguments);

} // namespace agv::app
