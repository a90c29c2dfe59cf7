// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/joint/particles.h"
#include "estimation/likelihood_bank.h"
#include "estimation/turn_evidence.h"

namespace agv::estimation {

/// Log likelihood of whole populations: for every particle and stop the sum of weight * log P(outcome |
/// distance) over the tags near the stop. All arithmetic runs over particles in the innermost loop.
class PopulationLikelihood {
public:
    explicit PopulationLikelihood(const TurnEvidence& evidence);

    /// Drops tags no particle's antenna comes near: distances beyond `reach_m` of the population's
    /// bounding box are flat in every model, so the sums stay the same.
    void restrictTo(const Particles& particles, double reach_m);

    /// out[stop * N + i] for stops first, first + stride, ...
    void evaluate(const Particles& particles, const LikelihoodBank& bank, std::size_t first,
                  std::size_t stride, float* out) const;

private:
    const TurnEvidence& m_evidence;
    std::vector<std::vector<TagTerm>> m_terms; ///< per stop
};

} // namespace agv::estimation
