// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/fixed_list.h"

#include <Eigen/Core>
#include <span>

namespace agv::estimation {

/// Most anchors a solver or filter handles at once; twice what the devices support.
constexpr int kMaxAnchors = 16;

/// At an anchor the direction to it is undefined; filters count a tag as never nearer, m.
constexpr double kLeastDistance_m = 1e-6;

/// A measured distance between a tag and an anchor of known position.
struct AnchorRange {
    Eigen::Vector3d anchor = Eigen::Vector3d::Zero(); ///< plant frame, m
    double range_m = 0.0;
    double sd_m = 0.05; ///< of the range without obstruction, m, > 0
    int index = 0; ///< of the anchor in the anchor list, 0..kMaxAnchors-1; selects per-anchor filter states
};

/// The ranges of one report of one tag.
using AnchorRanges = std::span<const AnchorRange>;
using AnchorRangeList = FixedList<AnchorRange, kMaxAnchors>;

/// Height of the tag above the plant's floor as known beforehand.
struct TagHeight {
    double z_m = 0.0;
    double sd_m = 0.0; ///< 0: exact, the fix is then two-dimensional
};

} // namespace agv::estimation
