// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fast/circle_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace agv::estimation {

namespace {

using Complex = std::complex<double>;

constexpr int kScanSteps = 120; ///< each side

/// Sums of the normal equations  W c + b u = p,  conj(b) c + W u = q  for one step angle.
struct NormalSums {
    double weight = 0.0;
    Complex turn;     ///< b
    Complex position; ///< p
    Complex turned;   ///< q
};

NormalSums sumsFor(std::span<const AntennaFix> fixes, double step)
{
    NormalSums sums;
    for (std::size_t k = 0; k < fixes.size(); ++k) {
        const Complex e = std::polar(1.0, static_cast<double>(k) * step);
        sums.weight += fixes[k].weight;
        sums.turn += fixes[k].weight * e;
        sums.position += fixes[k].weight * fixes[k].position;
        sums.turned += fixes[k].weight * std::conj(e) * fixes[k].position;
    }
    return sums;
}

/// Profile solution for one step: arm direction from the free fit, arm length drawn to the radius with
/// the prior's weight, then the centre again.
CircleFit fitFor(std::span<const AntennaFix> fixes, const CirclePrior& prior, double step)
{
    CircleFit fit;
    const NormalSums s = sumsFor(fixes, step);
    const double stiffness = s.weight - std::norm(s.turn) / s.weight; // of u, after eliminating c
    const Complex free = s.turned - std::conj(s.turn) * s.position / s.weight;
    if (!(stiffness > 1e-9 * s.weight) || std::abs(free) <= 0.0)
        return fit;
    const double priorWeight = 1.0 / (prior.radiusSd_m * prior.radiusSd_m);
    const double length = (std::abs(free) + priorWeight * prior.radius_m) / (stiffness + priorWeight);
    fit.arm = std::polar(length, std::arg(free));
    fit.centre = (s.position - s.turn * fit.arm) / s.weight;
    fit.step = step;
    for (std::size_t k = 0; k < fixes.size(); ++k)
        fit.cost += fixes[k].weight * std::norm(fixes[k].position - fit.centre -
                                                fit.arm * std::polar(1.0, static_cast<double>(k) * step));
    fit.cost += priorWeight * (length - prior.radius_m) * (length - prior.radius_m);
    const double offStep = (step - prior.step) / prior.stepSd;
    fit.cost += offStep * offStep;
    fit.valid = true;
    return fit;
}

/// Gauss-Newton covariance of (cx, cy, bearing, radius, step).
void addUncertainty(std::span<const AntennaFix> fixes, const CirclePrior& prior, CircleFit& fit)
{
    using Matrix5 = Eigen::Matrix<double, 5, 5>;
    Matrix5 information = Matrix5::Zero();
    information(3, 3) += 1.0 / (prior.radiusSd_m * prior.radiusSd_m);
    information(4, 4) += 1.0 / (prior.stepSd * prior.stepSd);
    const double radius = std::abs(fit.arm);
    const double bearing = std::arg(fit.arm);
    for (std::size_t k = 0; k < fixes.size(); ++k) {
        const double a = bearing + static_cast<double>(k) * fit.step;
        Eigen::Matrix<double, 2, 5> jacobian;
        jacobian << 1, 0, -radius * std::sin(a), std::cos(a), -radius * std::sin(a) * static_cast<double>(k),
            0, 1, radius * std::cos(a), std::sin(a), radius * std::cos(a) * static_cast<double>(k);
        information += fixes[k].weight * jacobian.transpose() * jacobian;
    }
    const Matrix5 covariance = information.ldlt().solve(Matrix5::Identity());
    fit.centreSd_m = std::sqrt(std::max(0.0, 0.5 * (covariance(0, 0) + covariance(1, 1))));
    fit.bearingSd = std::sqrt(std::max(0.0, covariance(2, 2)));
    fit.stepSd = std::sqrt(std::max(0.0, covariance(4, 4)));
}

/// Vertex of the parabola through three equally spaced costs, in units of the spacing, within +-1/2.
double vertexOffset(double before, double at, double after)
{
    const double curvature = before - 2.0 * at + after;
    return curvature > 0.0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0.0;
}

} // namespace

CircleFit fitCircle(std::span<const AntennaFix> fixes, const CirclePrior& prior)
{
    const auto used =
        std::count_if(fixes.begin(), fixes.end(), [](const AntennaFix& fix) { return fix.weight > 0.0; });
    if (used < 2)
        return {};
    const double spacing = prior.scanHalf / kScanSteps;
    CircleFit best;
    for (int i = -kScanSteps; i <= kScanSteps; ++i) {
        const CircleFit fit = fitFor(fixes, prior, prior.step + i * spacing);
        if (fit.valid && (!best.valid || fit.cost < best.cost))
            best = fit;
    }
    if (!best.valid)
        return best;
    const CircleFit before = fitFor(fixes, prior, best.step - spacing);
    const CircleFit after = fitFor(fixes, prior, best.step + spacing);
    if (before.valid && after.valid) {
        const double offset = vertexOffset(before.cost, best.cost, after.cost);
        const CircleFit refined = fitFor(fixes, prior, best.step + offset * spacing);
        if (refined.valid && refined.cost < best.cost)
            best = refined;
    }
    addUncertainty(fixes, prior, best);
    return best;
}

} // namespace agv::estimation
