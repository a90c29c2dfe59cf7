// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/fixed_list.h"

#include <cstdint>

namespace agv::estimation {

enum class MeasurementKind : std::uint8_t { Range, FloorTag, Odometry };

/// For the records only: a measurement beyond this many sds is called rejected.
inline constexpr double kRecordGate = 3.0;

/// What a filter made of one measurement; the only source of error plots, residual tables and warnings.
struct MeasurementRecord {
    MeasurementKind kind = MeasurementKind::Range;
    int source = 0; ///< range: index of the anchor; floor tag: 0
    double innovation =
        0.0;                ///< measured minus predicted, m (two-dimensional fixes: length of the difference)
    double variance = 0.0;  ///< what the filter expected of innovation^2, m^2
    double testRatio = 0.0; ///< innovation^2 / (gate^2 variance); above 1: outside the gate
    double weight = 0.0;    ///< share of the full gain it was given, 0..1
    bool rejected = false;  ///< outside the gate or held for blocked; it moved the state little or not at all
    bool fused = false;     ///< it moved the state; false together with rejected: left out altogether
};

/// Records of one report: at most one per anchor, tag on board and floor tag.
using MeasurementRecords = FixedList<MeasurementRecord, 64>;

} // namespace agv::estimation
