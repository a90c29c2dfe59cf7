// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace agv::estimation {

/// How long anchors are seen and hidden, and how much longer a hidden anchor's range is. The result hardly
/// depends on them (study, B.3); they describe people, racks and vehicles passing, not one recording.
struct ObstructionModel {
    double meanBias_m = 0.35; ///< mean of the exponential excess of an obstructed range
    double seen_s = 6.0;      ///< mean time with line of sight
    double hidden_s = 2.0;    ///< mean time without
    double seenAtFirst = 0.7; ///< probability of line of sight before anything was measured
};

/// Line of sight of one anchor as a hidden Markov chain with two states. A range is normal around its
/// prediction when the anchor is seen, normal plus exponential when it is hidden.
class Obstruction {
public:
    Obstruction() = default;
    explicit Obstruction(const ObstructionModel& model) : m_seen(model.seenAtFirst) {}

    double probabilitySeen() const { return m_seen; }
    void predict(const ObstructionModel& model, double dt_s);
    /// Probability of line of sight given the innovation (m) and its variance with line of sight (m^2).
    double update(const ObstructionModel& model, double innovation, double variance);

private:
    double m_seen = 0.7;
};

/// log sqrt(2 pi), of the normal density.
inline constexpr double kLogRootTwoPi = 0.91893853320467274178;

/// log density of a normal plus an exponential error, sd and mean in m.
double logNormalPlusExponential(double error, double sd, double mean);

/// log of the standard normal distribution function, accurate in the lower tail too.
double logNormalCdf(double z);

} // namespace agv::estimation
