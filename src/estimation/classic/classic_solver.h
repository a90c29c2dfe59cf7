// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/turn_solver.h"

namespace agv::estimation {

/// The seed's algorithm (chapter 7.2), repaired: for comparison, and as a method that can be followed by
/// hand.
///
///  1. At each stop the shape of the pattern of tags decides which branch of the RSSI relation holds for
///     each tag (chooseBranches); neighbours come from the real tag positions.
///  2. The three tags with most neighbours that are not on a line give the antenna by trilateration.
///  3. The first two pairs of stops half a turn apart whose lines meet give the centre (equations 16, 17).
///  4. The direction from the centre to the first of these antennas gives the heading; the steps before it
///     are taken off in the direction of rotation that the antennas show.
///
/// Any number of stops and tags, any step that divides half a turn. Doubles throughout. Always ends.
///
/// Status: "ok"; "no_reads": nothing was read; "bad_step": half a turn is no whole number of nominal steps;
/// "no_solution": fewer than two pairs of stops with three usable tags each; "parallel": the lines through
/// all pairs are parallel. `valid` is true for "ok" only.
///
/// The covariance is that of the construction (derivatives of centre and heading by the four antennas) at the
/// scatter the antennas show about their circle, but no less than the 15 mm of the clean simulation.
/// The algorithm does not measure the step: `step` is the nominal one with the study's prior uncertainty, and
/// there is no suggestion for the sleeptime. No evidence, no alternative pose. `elapsed_s` is filled in.
TurnEstimate solveClassic(const TurnRecord& record, const TurnContext& context);

} // namespace agv::estimation
