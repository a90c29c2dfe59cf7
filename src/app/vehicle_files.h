// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/locate.h"
#include "app/locate_run.h"
#include "core/result.h"

#include <iosfwd>

namespace agv::app {

/// What `fuse` reads besides the ranges: the files of --odometry and --rfid, and how the vehicle stands at
/// first. Errors name file and line; single bad lines are named on `err` and make `someBad` true.
Result<VehicleData> readVehicleData(const LocateArguments& arguments, std::ostream& err, bool& someBad);

} // namespace agv::app
