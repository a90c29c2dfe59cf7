// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/units.h"
#include "core/uwb_unit.h"

#include <cstdint>
#include <vector>

namespace agv::simulation {

/// How the bytes of the port arrive.
enum class UwbFraming : std::uint8_t {
    UsbTransfers, ///< of at most 64 bytes: a line of 65 comes as 64 + 1
    UartBursts,   ///< 16 bytes at 115200 baud
    WholeLines,
};

/// Errors of the ranges. Means and rates are what recordings of such kits show: noise of a few cm, a constant
/// bias of each pair of 0 to 0.25 m, NLOS that makes ranges 0.1 to 0.9 m longer for seconds.
struct UwbRangeModel {
    double noiseSd_m = 0.03;     ///< of each range
    double bias_m = 0.0;         ///< of all ranges
    double pairBiasSd_m = 0.04;  ///< of each pair tag-anchor, drawn once
    double missRate = 0.005;     ///< share of ranges that are not measured
    double lostRate = 0.002;     ///< share of exchanges that are lost whole: a gap in RSEQ
    double nlosPerMinute = 0.5;  ///< bursts of each pair
    double nlosDuration_s = 2.0; ///< mean, exponential
    double nlosLeast_m = 0.3;    ///< extra length of a burst, uniform
    double nlosMost_m = 0.9;     ///< the same
    double reach_m = 60.0;       ///< ranges beyond are not measured
};

struct UwbKitSettings {
    std::uint64_t seed = 1;
    UwbDialect dialect = UwbDialect::Trek; ///< Unknown counts as Trek
    bool fastMode = true;                  ///< 6.81 Mb/s and 10 Hz a tag, else 110 kb/s and 3.57 Hz
    UwbFraming framing = UwbFraming::UsbTransfers;
    bool anchorRanges = true; ///< ma lines, TREK with three anchors or more
    UwbRangeModel model;
    /// Ranges are reported by id: those with ids 0 to 3, and up to 7 in the dialects that have eight.
    std::vector<UwbAnchor> anchors;
};

/// The same kit without any error, for tests that check ranges exactly.
UwbKitSettings idealUwbKitSettings(std::vector<UwbAnchor> anchors);

/// Four or eight anchors at the corners, and the middles of the sides, of the plant's rectangle, in two
/// heights so that z can be told; for plants whose file has none. count: 4 or 8.
std::vector<UwbAnchor> defaultUwbAnchors(const PlantLayout& plant, int count);

} // namespace agv::simulation
