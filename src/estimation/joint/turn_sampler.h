// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/joint/turn_population.h"

#include <stop_token>
#include <vector>

namespace agv::estimation {

/// Look-up tables of the stages: blurred ones that lead the way, then the noise profiles.
struct SamplerTables {
    /// `missed`: share of the tags in reach that the turn missed, as far as the leading stages need it.
    SamplerTables(const RssiTable& table, double missed);
    NoiseProfiles noise;
    std::vector<LikelihoodBank> leading; ///< one model each, ever sharper
    LikelihoodBank profiles;
    double reach_m;
};

/// Sequential Monte Carlo (Del Moral, Doucet, Jasra, JRSS B 68, 2006) over whole turns: a population is
/// led from the prior through ever sharper likelihoods to the posterior. Each step raises the likelihood's
/// power until half of the population would carry all weight, resamples, and moves every particle.
class TurnSampler {
public:
    TurnSampler(const TurnEvidence& evidence, const SamplerTables& tables, const MotionPrior& prior,
                std::uint64_t seed, std::stop_token stop);

    /// Prior to the blurred likelihoods; false: cancelled. Afterwards logEvidence() compares directions.
    bool lead(std::size_t drawn, std::size_t kept, std::size_t stages);
    /// On to the noise profiles with `count` particles; false: cancelled.
    bool finish(std::size_t count, std::size_t firstStage);

    double logEvidence() const { return m_logEvidence; }
    bool converged() const { return m_converged; }
    /// The answer: the population at several moments of the last sweeps, which are nearly independent.
    const Particles& sample() const { return m_sample; }
    const NoiseProfiles& profiles() const { return m_tables.noise; }
    /// Log likelihood of each particle of the sample.
    const std::vector<double>& sampleLogLikelihoods() const { return m_sampleLogLikelihoods; }

private:
    bool bridge(const LikelihoodBank* from, const LikelihoodBank& to, double done);
    bool sweeps(const LikelihoodBank& bank, int count);
    bool collect();
    void resize(std::size_t count);

    const SamplerTables& m_tables;
    TurnPopulation m_population;
    MotionPrior m_prior;
    std::stop_token m_stop;
    Particles m_sample;
    std::vector<double> m_sampleLogLikelihoods;
    double m_logEvidence = 0.0;
    int m_temperatures = 0;
    int m_sweeps = 0;
    bool m_converged = true;
};

} // namespace agv::estimation
