// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/joint/joint_solver.h"

#include "estimation/joint/posterior_summary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr std::size_t kDrawn = 6000;      ///< prior samples per direction
constexpr std::size_t kScouts = 400;      ///< particles that decide the direction
constexpr std::size_t kParticles = 1000;  ///< particles of the answer
constexpr std::size_t kLeadingStages = 2; ///< blurred likelihoods run before the direction is decided
constexpr double kDecided = 12.0;         ///< log odds beyond which the other direction is dropped

double preference(const TurnRecord& record, Rotation rotation)
{
    return record.rotation && *record.rotation == rotation ? kRotationPriorLogOdds : 0.0;
}

struct Candidate {
    Rotation rotation;
    TurnSampler sampler;
    double logPosterior = 0.0;
};

Candidate candidateFor(Rotation rotation, const TurnEvidence& evidence, const SamplerTables& tables,
                       const TurnContext& context, const SolveOptions& options)
{
    const MotionPrior prior = motionPriorFor(evidence, context.antennaSd_m, signOf(rotation));
    const std::uint64_t seed =
        SplitMix64(options.seed * 2 + (rotation == Rotation::Clockwise ? 1 : 0)).next();
    return {rotation, TurnSampler(evidence, tables, prior, seed, options.stop)};
}

} // namespace

std::optional<TurnSolution> solveJoint(const TurnEvidence& evidence, const TurnRecord& record,
                                       const TurnContext& context, const SolveOptions& options)
{
    const SamplerTables tables(context.rssiTable, std::clamp(evidence.missed, 0.15, 0.9));
    std::array candidates{
        candidateFor(Rotation::CounterClockwise, evidence, tables, context, options),
        candidateFor(Rotation::Clockwise, evidence, tables, context, options),
    };
    for (Candidate& candidate : candidates) {
        if (!candidate.sampler.lead(kDrawn, kScouts, kLeadingStages))
            return std::nullopt;
        candidate.logPosterior = candidate.sampler.logEvidence() + preference(record, candidate.rotation);
    }
    const bool decided = std::abs(candidates[0].logPosterior - candidates[1].logPosterior) > kDecided;
    std::size_t best = candidates[1].logPosterior > candidates[0].logPosterior ? 1 : 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (decided && i != best)
            continue;
        if (!candidates[i].sampler.finish(kParticles, kLeadingStages))
            return std::nullopt;
        if (!decided)
            candidates[i].logPosterior =
                candidates[i].sampler.logEvidence() + preference(record, candidates[i].rotation);
    }
    best = candidates[1].logPosterior > candidates[0].logPosterior ? 1 : 0;
    TurnSolution solution = summarise(candidates[best].sampler);
    solution.rotation = candidates[best].rotation;
    solution.rotationLogOdds = candidates[best].logPosterior - candidates[1 - best].logPosterior;
    return solution;
}

} // namespace agv::estimation
