// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "estimation/uwb/anchor_range.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace agv::estimation {

/// Error of the ranges between one tag and one anchor: measured = d + offset + slope * d.
struct RangeBias {
    double offset_m = 0.0;
    double slope = 0.0;
    double sd_m = 0.05;      ///< what is left from place to place
    double noiseSd_m = 0.02; ///< from report to report at one place
    int places = 0;          ///< known places that it was learnt from

    double corrected(double range_m) const { return (range_m - offset_m) / (1.0 + slope); }
};

/// How far each part of an error is known before it is measured (sds).
struct BiasCalibrationSettings {
    double tagOffset_m = 0.30;    ///< antenna delay of a tag
    double anchorOffset_m = 0.30; ///< antenna delay of an anchor
    double pairOffset_m = 0.07;   ///< what is peculiar to the pair: surroundings, antenna patterns
    double slope = 0.02;          ///< common to all: clocks, propagation, power
    double anchorSlope = 0.01;    ///< of one anchor
    double pairSlope = 0.01;      ///< of one pair
    double place_m = 0.06;        ///< multipath, different at every place
};

/// Learns the error of every tag-anchor pair from reports taken at known places. At each place the median of
/// the errors counts, so that gross outliers and short obstructions do not. All pairs are solved together,
///     error = tag + anchor + pair + (slope + anchor slope + pair slope) d,
/// each part with a prior around zero, so that pairs measured at few places lean on their tag and their
/// anchor; places that do not fit weigh less.
class BiasCalibration {
public:
    explicit BiasCalibration(const BiasCalibrationSettings& settings = {}) : m_settings(settings) {}

    /// A range measured while the tag was `distance_m` from the anchor; `place` numbers the known places.
    /// Values that are not finite are left out.
    void add(int tag, int anchor, int place, double range_m, double distance_m);

    /// NoSolution when nothing was added.
    Result<std::map<std::pair<int, int>, RangeBias>> solve() const;

private:
    struct Sample {
        double error_m;
        double distance_m;
    };
    struct Place {
        double error_m = 0.0;
        double distance_m = 0.0;
        double spread_m = 0.0;
    };
    static Place medianPlace(const std::vector<Sample>& samples);

    BiasCalibrationSettings m_settings;
    std::map<std::pair<int, int>, std::map<int, std::vector<Sample>>> m_samples; ///< pair -> place -> samples
};

/// Calibrated errors by (tag, anchor).
using RangeBiases = std::map<std::pair<int, int>, RangeBias>;

} // namespace agv::estimation
