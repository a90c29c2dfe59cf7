// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/rssi_likelihood.h"

#include <span>
#include <string>
#include <vector>

namespace agv::estimation {

/// The readers compared by evidence, from an undisturbed one to one with a wrong table. Distance noise and
/// read failures are separate properties of a reader, so the family is the grid of both.
class NoiseProfiles {
public:
    NoiseProfiles();

    int count() const { return static_cast<int>(m_models.size()); }
    std::span<const NoiseModel> models() const { return m_models; }
    const NoiseModel& model(int profile) const { return m_models[static_cast<std::size_t>(profile)]; }
    double logPrior(int profile) const { return m_logPriors[static_cast<std::size_t>(profile)]; }
    std::string name(int profile) const; ///< "fine, few misses"

    /// A profile drawn from the prior; `share` in [0, 1).
    int drawn(double share) const;
    /// A profile next to `profile`, or -1 beyond the edge of the grid; each way with the same probability
    /// back and forth. `choice` in [0, 4).
    int neighbour(int profile, int choice) const;

private:
    std::vector<NoiseModel> m_models;
    std::vector<double> m_logPriors;
    std::vector<double> m_cumulated;
};

} // namespace agv::estimation
