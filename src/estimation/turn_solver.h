// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/turn.h"

#include <cstdint>
#include <stop_token>

namespace agv::estimation {

/// What a solver must know besides the recorded turn.
struct TurnContext {
    std::vector<FloorTag> tags;
    RssiTable rssiTable = seedRssiTable();
    Point2 antenna{-0.100, 0.0}; ///< in the vehicle frame, m: the antenna sits on the back
    double antennaSd_m = 0.002; ///< how well `antenna` is known, per axis; its lateral part is not observable
};

TurnContext contextFor(const PlantLayout& plant, const AgvConfig& agv);

struct SolveOptions {
    SolveMethod method = SolveMethod::Auto;
    std::uint64_t seed = 1; ///< same record, context, options and seed -> bit-identical estimate
    std::stop_token stop;   ///< requested: returns soon with valid = false, status "cancelled"
};

/// Where did the robot stand and how far did it turn at each step? Never throws, never hangs: whatever the
/// input, the answer is an estimate or a status. Thread-safe (no shared state).
TurnEstimate solveTurn(const TurnRecord& record, const TurnContext& context,
                       const SolveOptions& options = {});

} // namespace agv::estimation
