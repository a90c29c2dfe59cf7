// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/joint/motion_prior.h"

#include "estimation/log_sum_exp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace agv::estimation {

namespace {

constexpr double kRadiusFreedom = 4.0;
constexpr double kMeasuredRadius = 0.25; ///< sd of a measured radius, relative to the scale of a mounted one
constexpr double kBoxMargin = 1.3;       ///< beyond the box that is drawn from
constexpr double kNarrowScale = 0.003;   ///< relative error of a table measured with this antenna
constexpr double kWideScale = 0.05;      ///< ... and of one measured with another
constexpr double kLargestLogScale = 0.4;
constexpr double kDriftFreedom = 4.0;
constexpr double kDrift_m = 0.0012; ///< scale of the drift in a whole turn, per axis
constexpr double kImpossible = -1e9;

struct RobotKind {
    double prior;
    double stepSd;     ///< relative
    double jitter_deg; ///< median of the sd of single steps
    double jitterLogSd;
};
constexpr std::array<RobotKind, MotionPrior::kKinds> kRobots{{
    {0.25, 0.003, 0.10, 0.5}, // adjusted
    {0.15, 0.14, 0.10, 0.5},  // steady
    {0.6, 0.14, 1.0, 0.6},    // shaky
}};
constexpr std::size_t kKinds = MotionPrior::kKinds;

double gaussian(double z) { return -0.5 * z * z; }

double logGaussian(double off, double sd) { return gaussian(off / sd) - std::log(sd); }

double logJitterMedian(const RobotKind& robot) { return std::log(radFromDeg(robot.jitter_deg)); }

/// Index drawn in proportion to the weights; the last one if all are zero.
std::size_t drawn(const std::array<double, kKinds>& weights, SplitMix64& random)
{
    double left = random.uniform() * (weights[0] + weights[1] + weights[2]);
    std::size_t i = 0;
    while (i + 1 < kKinds && (left -= weights[i]) >= 0.0)
        ++i;
    return i;
}

} // namespace

double MotionPrior::logCentre(double x, double y) const
{
    const double half = kBoxMargin * searchHalf_m;
    return std::abs(x) <= half && std::abs(y) <= half ? 0.0 : kImpossible;
}

double MotionPrior::logRadius(double radius) const
{
    if (radius < 0.3 * radius_m || radius > 2.0 * radius_m)
        return kImpossible;
    constexpr double kLogStudentAtZero = -0.98083; // log density of t with 4 degrees of freedom
    constexpr double kLogGaussianAtZero = -0.91894;
    const double z = (radius - radius_m) / radiusScale_m;
    const double mounted =
        kLogStudentAtZero - 0.5 * (kRadiusFreedom + 1.0) * std::log1p(z * z / kRadiusFreedom);
    return logSumExp(mounted, kLogGaussianAtZero + logGaussian(z, kMeasuredRadius));
}

double MotionPrior::logMotion(double stepAngle, double logJitter) const
{
    if (stepAngle * step <= 0.0)
        return kImpossible;
    double density = 0.0;
    for (const KindOfMotion& kind : kinds) {
        const double zStep = (stepAngle - step) * kind.perStepSd;
        const double zJitter = (logJitter - kind.logJitter) * kind.perJitterSd;
        density += std::exp(kind.logWeight - 0.5 * (zStep * zStep + zJitter * zJitter));
    }
    return density > 0.0 ? std::log(density) : kImpossible;
}

double MotionPrior::logDrift(double x, double y) const
{
    const double z2 = (x * x + y * y) / (driftScale_m * driftScale_m);
    return -0.5 * (kDriftFreedom + 2.0) * std::log1p(z2 / kDriftFreedom);
}

double MotionPrior::logTableScale(double logScale)
{
    if (std::abs(logScale) > kLargestLogScale)
        return kImpossible;
    return logSumExp(logGaussian(logScale, kNarrowScale), logGaussian(logScale, kWideScale));
}

MotionPrior::Motion MotionPrior::drawMotion(SplitMix64& random) const
{
    std::array<double, kKinds> weights{};
    std::ranges::transform(kRobots, weights.begin(), &RobotKind::prior);
    const RobotKind& robot = kRobots[drawn(weights, random)];
    return {step * (1.0 + robot.stepSd * std::clamp(random.normal(), -3.0, 3.0)),
            logJitterMedian(robot) + robot.jitterLogSd * random.normal()};
}

double MotionPrior::drawStepGiven(double mean, std::size_t count, double logJitter, SplitMix64& random) const
{
    // Given the kind of robot all is Gaussian; the kinds are weighted with how well they predict the mean.
    const double variance = std::exp(2.0 * logJitter) / static_cast<double>(count);
    std::array<double, kKinds> weights{};
    for (std::size_t i = 0; i < kKinds; ++i) {
        const KindOfMotion& kind = kinds[i];
        const double narrowing = 1.0 / (1.0 + variance * kind.perStepSd * kind.perStepSd);
        const double zStep = (mean - step) * kind.perStepSd;
        const double zJitter = (logJitter - kind.logJitter) * kind.perJitterSd;
        weights[i] = std::sqrt(narrowing) *
                     std::exp(kind.logWeight - 0.5 * (zStep * zStep * narrowing + zJitter * zJitter));
    }
    const double priorPrecision = std::pow(kinds[drawn(weights, random)].perStepSd, 2);
    const double total = priorPrecision + 1.0 / variance;
    return (step * priorPrecision + mean / variance) / total + random.normal() / std::sqrt(total);
}

double MotionPrior::drawDrift(SplitMix64& random) const { return driftScale_m * random.normal(); }

double MotionPrior::drawRadius(SplitMix64& random) const
{
    const double scale = random.uniform() < 0.5 ? kMeasuredRadius : 1.0;
    return radius_m + scale * radiusScale_m * random.normal();
}

double MotionPrior::drawLogTableScale(SplitMix64& random)
{
    const double sd = random.uniform() < 0.5 ? kNarrowScale : kWideScale;
    return std::clamp(sd * random.normal(), -kLargestLogScale, kLargestLogScale);
}

MotionPrior motionPriorFor(const TurnEvidence& evidence, double antennaSd_m, double direction)
{
    MotionPrior prior;
    prior.radius_m = evidence.radius_m;
    prior.radiusScale_m = std::clamp(0.8 * antennaSd_m, 0.0002, 0.2 * evidence.radius_m);
    prior.step = direction * evidence.nominalStep;
    for (std::size_t i = 0; i < kRobots.size(); ++i) {
        const RobotKind& robot = kRobots[i];
        const double sd = robot.stepSd * evidence.nominalStep;
        prior.kinds[i] = {std::log(robot.prior / (sd * robot.jitterLogSd)), 1.0 / sd, logJitterMedian(robot),
                          1.0 / robot.jitterLogSd};
    }
    const double turned = evidence.nominalStep * static_cast<double>(evidence.stops.size());
    prior.driftScale_m = kDrift_m * std::sqrt(turned / (2.0 * std::numbers::pi));
    prior.searchHalf_m = evidence.searchHalf_m;
    return prior;
}

} // namespace agv::estimation
