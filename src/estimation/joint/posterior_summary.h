// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/joint/turn_sampler.h"
#include "estimation/turn_solution.h"

namespace agv::estimation {

/// Posterior means, covariance, modes and the most probable noise profile of a finished sampler. Rotation
/// and its evidence are left to the caller.
TurnSolution summarise(const TurnSampler& sampler);

} // namespace agv::estimation
