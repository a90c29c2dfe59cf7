// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/fast/fast_fit.h"
#include "estimation/turn_solution.h"

#include <optional>

namespace agv::estimation {

/// The closed-form answer for the live preview: some milliseconds, no random numbers. Nothing when fewer
/// than two stops have reads.
std::optional<TurnSolution> solveFast(const TurnEvidence& evidence, const TurnRecord& record,
                                      const RssiTable& table, std::stop_token stop);

} // namespace agv::estimation
