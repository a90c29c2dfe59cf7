// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fast/fast_fit.h"

#include "estimation/fast/antenna_grid.h"

#include <array>
#include <cmath>

namespace agv::estimation {

namespace {

/// Tolerant: the grid is coarse and the reader's true noise unknown.
constexpr NoiseModel kNoise{.distanceSd_m = 0.003, .offByOne = 0.3, .missed = 0.15, .outlier = 1e-2};
constexpr double kRadiusSd_m = 0.003;
constexpr double kStepSd = 0.15;  ///< relative
constexpr double kStepScan = 0.3; ///< relative
constexpr std::array kPredictionSd_m{0.015, 0.008};

std::complex<double> predicted(const CircleFit& circle, std::size_t stop)
{
    return circle.centre + circle.arm * std::polar(1.0, static_cast<double>(stop) * circle.step);
}

double logLikelihoodOf(const CircleFit& circle, const TurnEvidence& evidence, const LikelihoodBank& bank)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < evidence.stops.size(); ++k) {
        const std::complex<double> antenna = predicted(circle, k);
        for (const TagTerm& term : evidence.stops[k].terms)
            sum += static_cast<double>(
                term.weight *
                bank.at(0, term.outcome, std::hypot(antenna.real() - term.x, antenna.imag() - term.y)));
    }
    return sum;
}

CirclePrior priorFor(const TurnEvidence& evidence, double direction)
{
    return {.radius_m = evidence.radius_m,
            .radiusSd_m = kRadiusSd_m,
            .step = direction * evidence.nominalStep,
            .stepSd = kStepSd * evidence.nominalStep,
            .scanHalf = kStepScan * evidence.nominalStep};
}

FastFit fitDirection(const TurnEvidence& evidence, const std::vector<AntennaGrid>& grids,
                     const LikelihoodBank& bank, double direction)
{
    const CirclePrior prior = priorFor(evidence, direction);
    FastFit result;
    for (const AntennaGrid& grid : grids)
        result.fixes.push_back(grid.fix({}));
    result.circle = fitCircle(result.fixes, prior);
    for (const double sd_m : kPredictionSd_m) {
        if (!result.circle.valid)
            return result;
        for (std::size_t k = 0; k < grids.size(); ++k)
            result.fixes[k] = grids[k].fix(AntennaGrid::Prediction{predicted(result.circle, k), sd_m});
        result.circle = fitCircle(result.fixes, prior);
    }
    if (!result.circle.valid)
        return result;
    const double offStep = (result.circle.step - prior.step) / prior.stepSd;
    result.score = logLikelihoodOf(result.circle, evidence, bank) - 0.5 * offStep * offStep;
    return result;
}

} // namespace

FastFits fitFast(const TurnEvidence& evidence, const RssiTable& table, std::stop_token stop)
{
    const LikelihoodBank bank(table, std::array{kNoise}, flatBeyond(table, kNoise.distanceSd_m));
    std::vector<AntennaGrid> grids;
    for (const StopEvidence& stopEvidence : evidence.stops) {
        if (stop.stop_requested())
            return {};
        grids.emplace_back(stopEvidence, bank, table.front().upperEdge);
    }
    FastFit left = fitDirection(evidence, grids, bank, 1.0);
    FastFit right = fitDirection(evidence, grids, bank, -1.0);
    if (right.score > left.score)
        return {std::move(right), std::move(left)};
    return {std::move(left), std::move(right)};
}

} // namespace agv::estimation
