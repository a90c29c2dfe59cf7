// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/locate.h"
#include "app/locate_run.h"
#include "app/uwb_calibration.h"
#include "app/uwb_files.h"
#include "recording/truth_table.h"

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::app {

/// What all inputs have in common.
struct LocateSetup {
    std::vector<std::string_view> methods;
    std::optional<AnchorSet> anchors; ///< nothing: those of each log
    std::optional<recording::TruthTable> truth;
    std::optional<UwbCalibration> calibration;
    std::optional<VehicleData> vehicle; ///< of fuse
    bool someBad = false;               ///< a line of these files could not be used
};

/// Why the arguments cannot be carried out; nothing when they can.
std::optional<std::string> whyUsageIsWrong(const LocateArguments& arguments);

/// Reads the files of the options. Errors name file and line; single bad lines are named on `err`.
/// @pre whyUsageIsWrong() is empty
Result<LocateSetup> readSetup(const LocateArguments& arguments, std::ostream& err);

/// The methods as a table: name, command, title, source.
std::string methodTable();

} // namespace agv::app
