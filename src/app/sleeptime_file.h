// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ids.h"
#include "core/result.h"

#include <filesystem>

namespace agv::app {

/// Writes the sleeptime (s) of an AGV, and the wheel speed (m/s) it belongs to, into a plant file. The file
/// is read anew first, so that what somebody else changed since the start stays, as does every key this
/// version does not know. Returns the sleeptime that stood there. The errors of PlantDocument::fromFile() and
/// writePlantFile(), or NotFound when the file no longer has that AGV; then the file is as it was.
Result<double> writeSleeptime(const std::filesystem::path& path, RobotId robot, double turnTime_s,
                              double turnSpeed_m_s);

} // namespace agv::app
