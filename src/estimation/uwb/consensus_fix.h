// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/obstruction.h"
#include "estimation/uwb/range_fix.h"

#include <array>

namespace agv::estimation {

struct ConsensusFix {
    UwbFix fix;
    std::array<double, kMaxAnchors> probabilitySeen{}; ///< of each range, in the order given
};

/// Fix that most ranges agree on when many of them are wrong, as after a mixed-up exchange: the fix of every
/// three ranges is a candidate, the one with the highest likelihood sum log(s N(e) + (1 - s) EMG(e) +
/// outlier) wins and is improved with all ranges weighted by their probability of being seen. Ten times the
/// work of a robust fix; used when that one finds no explanation.
ConsensusFix consensusFix(AnchorRanges ranges, const RangeFixSettings& settings,
                          const ObstructionModel& model, double outlier);

} // namespace agv::estimation
