// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/file_problem.h"

#include <optional>
#include <string_view>
#include <vector>

namespace agv::recording {

/// What a vehicle's wheels did during the time before.
struct OdometryRow {
    double time_s = 0.0;  ///< end of the time it speaks of; it began at the row before
    double forward = 0.0; ///< m/s
    double turn = 0.0;    ///< rad/s, counter-clockwise
    friend bool operator==(const OdometryRow&, const OdometryRow&) = default;
};

struct OdometryTable {
    std::vector<OdometryRow> rows; ///< rising times
    FileProblems problems;
};

/// A table with the columns t_s and either v_left_mps, v_right_mps (speeds of the wheels, m/s) or v_mps,
/// omega_radps (of the vehicle, m/s and rad/s). Wheel speeds need the distance of the wheels, `track_m` > 0.
/// A bad row, or one that steps back in time, is a problem and never stops the others. BadInput "LINE: ..."
/// when a column or the track is missing or no row can be read.
Result<OdometryTable> readOdometryCsv(std::string_view text, std::optional<double> track_m);

} // namespace agv::recording
