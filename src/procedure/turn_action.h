// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/robot_status.h"
#include "core/snapshot.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace agv::procedure {

// What a procedure wants done. The caller carries the actions out in order.

/// Robot command directDrive.
struct DriveWheels {
    WheelSpeeds speeds; ///< m/s
};

/// Robot command addSegments.
struct DriveSegments {
    std::uint32_t firstNumber = 0;
    std::vector<DriveSegment> segments;
};

/// Robot command interrupt: ends a running segment.
struct InterruptRobot {};

/// Call the fast solver on record().
struct SolvePreview {
    int stopsDone = 0;
};

/// Call the chosen solver on record(), then solved().
struct SolveResult {};

/// For the event log.
struct Report {
    EventLevel level = EventLevel::Info;
    std::string text; ///< plain English
};

using TurnAction =
    std::variant<DriveWheels, DriveSegments, InterruptRobot, SolvePreview, SolveResult, Report>;
using TurnActions = std::vector<TurnAction>;

} // namespace agv::procedure
