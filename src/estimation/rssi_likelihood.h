// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"

#include <array>
#include <span>
#include <vector>

namespace agv::estimation {

/// What one stop says about one tag: RSSI 0..7, or that it was not read.
using TagOutcome = int;
constexpr TagOutcome kNotRead = 8;
constexpr int kOutcomes = 9;

/// How a reader departs from its RSSI table.
struct NoiseModel {
    double distanceSd_m = 0.002; ///< blur of every distance: tag position, antenna, table edges
    double offByOne = 0.3;       ///< probability that the RSSI is one too high or one too low (half each)
    double missed = 0.15;        ///< probability that a tag in range is not read
    double outlier = 2e-3;       ///< weight of a uniform outcome: stale reads, damaged tags
};

/// Probability of each outcome given the distance from antenna to tag.
using OutcomeProbabilities = std::array<double, kOutcomes>;

/// P(outcome | distance) of the reader, in double precision: the reference of the look-up tables.
///
/// The table is a step function: step i reads as r_i for distances in (e_{i+1}, e_i]. With Gaussian
/// distance noise of sd s a tag at distance d is in step i with probability
///     p_i(d) = Phi((e_i - d) / s) - Phi((e_{i+1} - d) / s)        (innermost step: lower edge -infinity)
/// so several steps with the same RSSI simply add: every branch of the ambiguous relation counts.
///     P(RSSI r) = (1 - o) (1 - m) sum_t C(r, t) sum_{i: r_i = t} p_i(d) + o / 9
///     P(not read) = (1 - o) (1 - (1 - m) sum_i p_i(d)) + o / 9
/// where C moves the RSSI one up or down with probability q / 2 each, clipped to 0..7, m is the
/// probability of a miss and o the weight of outliers. (Study, section A.3.)
class RssiLikelihood {
public:
    RssiLikelihood(RssiTable table, NoiseModel noise);

    OutcomeProbabilities probabilities(double distance_m) const;
    double logProbability(TagOutcome outcome, double distance_m) const;

private:
    RssiTable m_table;
    NoiseModel m_noise;
};

/// Probability that the true RSSI, before reading errors, is 0..7, with distance noise of the given sd.
std::array<double, 8> trueRssiProbabilities(const RssiTable& table, double distanceSd_m, double distance_m);

/// Adds misreadings, misses and outliers to `trueRssiProbabilities`.
OutcomeProbabilities withNoise(const std::array<double, 8>& trueRssi, const NoiseModel& noise);

/// Empty text when the table can be used: 1 to 256 steps, finite positive falling edges, RSSI 0..7.
const char* problemOf(const RssiTable& table);

/// A tag and its outcome at a stop.
struct TagObservation {
    Point2 tag; ///< m
    TagOutcome outcome = kNotRead;
};

/// Sum of log P(outcome | distance) over the observations, for an antenna at `antenna` (m).
double logLikelihood(const RssiLikelihood& likelihood, Point2 antenna,
                     std::span<const TagObservation> observations);

} // namespace agv::estimation
