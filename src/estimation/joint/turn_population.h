// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "estimation/joint/motion_prior.h"
#include "estimation/joint/noise_profiles.h"
#include "estimation/joint/particles.h"
#include "estimation/joint/population_likelihood.h"

#include <span>
#include <vector>

namespace agv::estimation {

/// A population with its log likelihoods under one bank and the Metropolis moves that keep its
/// distribution, prior times exp(likelihood), unchanged:
///
///   * global: differential evolution (ter Braak, Statistics and Computing 16, 2006) in centre, radius,
///     step, rotation, jitter and table scale. Bearings are a_k = mean + s (k - m) + sigma_j c_k with c_k
///     fixed, so step and jitter change without rejections by the prior of the single steps;
///   * bearings of the even, then of the odd stops: given their neighbours they are independent, so each
///     is accepted or rejected for itself;
///   * step and jitter given the bearings: their conditional densities need no likelihood;
///   * noise model: another one is proposed, when the bank has several.
class TurnPopulation {
public:
    TurnPopulation(Particles particles, const MotionPrior& prior, const NoiseProfiles& profiles,
                   const TurnEvidence& evidence, std::uint64_t seed);

    Particles& particles() { return m_particles; }
    const Particles& particles() const { return m_particles; }
    const PopulationLikelihood& likelihood() const { return m_likelihood; }
    SplitMix64& random() { return m_random; }

    /// Leaves out tags out of reach of all particles.
    void restrictTags(double reach_m);

    /// Replaces the particles by the chosen ones.
    void select(std::span<const std::uint32_t> chosen);

    /// Draws noise models from their prior: at the start of the stage that compares them.
    void drawProfiles();

    /// Log likelihood of every particle, summed over the stops.
    std::vector<double> totals(const LikelihoodBank& bank) const;

    /// Sets the bank the moves work with.
    void setTarget(const LikelihoodBank& bank);
    void sweep(const LikelihoodBank& bank, int sweepIndex);

    /// Share of accepted global moves so far.
    double acceptance() const;

private:
    void moveGlobally(const LikelihoodBank& bank, bool jump);
    void proposeGlobally(std::size_t i, bool jump);
    void moveBearings(const LikelihoodBank& bank, std::size_t parity);
    void drawStep();
    void moveJitter();
    void moveProfile(const LikelihoodBank& bank);
    double logPriorOf(const Particles& p, std::size_t i) const;
    double logStepsAround(const Particles& bearings, std::size_t i, std::size_t stop, float bearing) const;
    double sumOf(const std::vector<float>& values, std::size_t i) const;
    void accept(std::size_t i);
    float symmetric(); ///< triangular, variance 1

    Particles m_particles;
    Particles m_proposal;
    Particles m_frozen;
    std::vector<float> m_logLikelihood; ///< [stop][particle] of m_particles under the target
    std::vector<float> m_proposed;      ///< ... of m_proposal
    std::vector<float> m_meanBearing;
    MotionPrior m_prior;
    const NoiseProfiles& m_profiles;
    PopulationLikelihood m_likelihood;
    SplitMix64 m_random;
    std::size_t m_globalMoves = 0;
    std::size_t m_globalAccepted = 0;
};

/// Draws from the prior, bearings included.
Particles drawFromPrior(const MotionPrior& prior, std::size_t count, std::size_t stops, SplitMix64& random);

} // namespace agv::estimation
