// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fast/fast_solver.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr double kModelError = 1.5; ///< the grid's Gaussians understate the sd by about this factor

double preference(const TurnRecord& record, double step)
{
    if (!record.rotation)
        return 0.0;
    return (step > 0.0) == (*record.rotation == Rotation::CounterClockwise) ? kRotationPriorLogOdds : 0.0;
}

SolutionMode modeOf(const FastFit& fit, double logOdds)
{
    return {{fit.circle.centre.real(), fit.circle.centre.imag()}, std::arg(fit.circle.arm), logOdds};
}

TurnSolution solutionOf(const CircleFit& circle, std::size_t stops)
{
    TurnSolution s;
    s.centre = {circle.centre.real(), circle.centre.imag()};
    s.radius_m = std::abs(circle.arm);
    const double centreSd = kModelError * circle.centreSd_m;
    const double bearingSd = kModelError * circle.bearingSd;
    s.covariance = {centreSd * centreSd, 0, 0, 0, centreSd * centreSd, 0, 0, 0, bearingSd * bearingSd};
    s.rotation = circle.step > 0.0 ? Rotation::CounterClockwise : Rotation::Clockwise;
    s.step = std::abs(circle.step);
    s.stepSd = kModelError * circle.stepSd;
    for (std::size_t k = 0; k < stops; ++k) {
        s.bearings.push_back(std::arg(circle.arm) + static_cast<double>(k) * circle.step);
        s.antennaSd_m.push_back(std::hypot(centreSd, 0.5 * bearingSd * s.radius_m));
    }
    s.lastBearingSd = bearingSd;
    return s;
}

} // namespace

std::optional<TurnSolution> solveFast(const TurnEvidence& evidence, const TurnRecord& record,
                                      const RssiTable& table, std::stop_token stop)
{
    FastFits fits = fitFast(evidence, table, stop);
    if (!fits.best.circle.valid)
        return std::nullopt;
    double logOdds = fits.best.score - fits.other.score;
    if (fits.other.circle.valid) {
        logOdds += preference(record, fits.best.circle.step) - preference(record, fits.other.circle.step);
        if (logOdds < 0.0) {
            std::swap(fits.best, fits.other);
            logOdds = -logOdds;
        }
    }
    TurnSolution solution = solutionOf(fits.best.circle, evidence.stops.size());
    solution.rotationLogOdds = std::min(logOdds, 1e3);
    solution.noise = {.distanceSd_m = 0.004, .offByOne = 0.4, .missed = 0.2, .outlier = 1e-2};
    solution.profile = "fast";
    solution.logEvidence = fits.best.score;
    if (fits.other.circle.valid)
        solution.alternative = modeOf(fits.other, logOdds);
    return solution;
}

} // namespace agv::estimation
