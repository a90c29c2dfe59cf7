// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/calibration_run.h"
#include "core/result.h"

#include <filesystem>
#include <vector>

namespace agv::app {

/// Makes the folder when it is missing and checks that files can be written there. Io, Permission.
Result<void> prepareFolder(const std::filesystem::path& folder);

/// Writes into `folder`: result.csv and result.json (recording/turn_results.h), agvN-capture.txt of each AGV
/// (recording/capture_turns.h) and its agvN-table.csv (recording/table_turns.h), and truth.json when the AGVs
/// are simulated. An error names the file.
Result<void> writeCalibration(const std::filesystem::path& folder,
                              const std::vector<CalibrationOutcome>& outcomes, SolveMethod method);

/// How far a result is from the truth.
struct PoseError {
    double position_m = 0.0;
    double heading = 0.0; ///< rad, (-pi, pi]
};
PoseError errorOf(const TurnEstimate& estimate, const TruePose& truth);

/// "truth 1,203 mm, 871 mm, 91.2 degrees; error 2.2 mm, 0.8 degrees"
std::string truthText(const CalibrationOutcome& outcome);

} // namespace agv::app
