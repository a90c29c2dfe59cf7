// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/measurement_record.h"
#include "estimation/uwb/obstruction.h"
#include "estimation/uwb/range_fix.h"

namespace agv::estimation {

struct RobustFixSettings {
    std::optional<TagHeight> height = {};
    TagSide side = TagSide::Below;
    ObstructionModel obstruction = {}; ///< seenAtFirst: prior probability that an anchor is seen
};

struct RobustFix {
    UwbFix fix; ///< mean over the hypotheses; the covariance contains their spread
    std::array<double, kMaxAnchors> probabilitySeen{}; ///< of each range, in the order given
    MeasurementRecords records;
};

/// Fix of a tag when some anchors may be hidden: every set of at most two hidden anchors (one when only four
/// ranges are there, none with three) is a hypothesis with its own least-squares fix from the others. A
/// hidden anchor's excess is exponential. The fixes are averaged with the hypotheses' probabilities
///     P(H) ~ prior(H) exp(-cost) sqrt(det C) prod_hidden p(excess)
/// (Laplace's approximation of the evidence), which is the least-mean-square estimate; leaving out the worst
/// residual would decide where the data do not.
RobustFix robustFix(AnchorRanges ranges, const RobustFixSettings& settings = {});

} // namespace agv::estimation
