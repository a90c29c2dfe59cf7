// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/turn.h"

#include <span>
#include <string>

namespace agv::recording {

/// What came of one recorded turn.
struct TurnResult {
    std::string id;        ///< "file:turn", turn from 1
    TurnEstimate estimate; ///< with a status even when there is no pose
    std::string problem;   ///< why the turn could not be read, plain English; empty: it could
};

/// Result of a turn that could not be read: status "bad_input".
TurnResult unreadableTurn(std::string id, SolveMethod method, std::string problem);

/// The header of the CSV table below, with CR LF.
std::string csvHeader();

/// One row of CSV (RFC 4180, UTF-8, CR LF, '.' as decimal point):
///
///     id, status              status: "ok", a solver's reason, or "bad_input"
///     x_mm, y_mm              centre of the robot at stop 0, plant frame
///     heading_deg             of the front at stop 0, (-180, 180], counter-clockwise from +x
///     sd_x_mm .. cov_yy_mm2   uncertainty of those
///     direction               "ccw" or "cw"
///     step_deg, step_sd_deg   mean angle of a step, positive
///     sleeptime_ms            suggested for steps of the nominal angle, and its sd; empty: no suggestion
///     flags                   words parted by ';', see TurnFlag
///     method, elapsed_ms      solver and its computing time
///     x_now_mm, y_now_mm      centre of the robot at the last stop: where it stands after the turn
///     heading_now_deg, sd     of the front at the last stop
///     radius_mm               antenna to centre
///     profile                 noise profile chosen
///     alt_x_mm .. alt_log_odds  second explanation and the log of how much less likely it is
///     problem                 why the turn could not be read
///
/// Fields without a value are empty. Text that a spreadsheet would take for a formula gets an apostrophe.
std::string csvRow(const TurnResult& result);

/// One object of JSON lines, with LF: the same keys and values (numbers, flags as a list, null without a
/// value), the covariance with heading, and `stops`: for each stop antenna, bearing, and the UIDs of the tags
/// seen, expected, missed, unknown and misplaced.
std::string jsonLine(const TurnResult& result);

} // namespace agv::recording
