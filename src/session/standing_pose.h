// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/turn.h"

namespace agv::session {

/// The estimate with `pose` where the robot stands now: `steps` steps of the turn after stop 0. A solver says
/// where the last stop was, but after a retake the robot stands at another one.
TurnEstimate standingAt(TurnEstimate estimate, int steps);

/// Covariance of the estimate's `pose`: that of `startPose` with the heading's deviation of now.
PoseCovariance covarianceOfPose(const TurnEstimate& estimate);

} // namespace agv::session
