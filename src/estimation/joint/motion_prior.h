// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "estimation/turn_evidence.h"

#include <array>

namespace agv::estimation {

/// What is known of robot, turn and table before the reads; all densities up to a constant.
///
///   centre           flat in a box around the tags read: a robot that read these tags is not elsewhere
///   R                around the configured radius: a narrow Gaussian (measured) or a wide Student t with
///                    4 degrees of freedom (as mounted)
///   s, log sigma_j   mean step and log sd of single steps, three kinds of robots: adjusted (turns what was
///                    commanded, always the same), steady (always the same, but wheel slip and battery
///                    voltage scale it) and shaky (neither)
///   drift            of the centre from the first to the last stop: Student t around 0; wheels slip
///   log kappa        scale of the RSSI table: half narrow (a measured table), half wide (another antenna)
struct MotionPrior {
    static constexpr std::size_t kKinds = 3;
    /// A kind of robot in the form the inner loops need.
    struct KindOfMotion {
        double logWeight = 0.0; ///< log(prior / (sd of step * sd of log jitter))
        double perStepSd = 0.0; ///< 1 / sd of the step, 1/rad
        double logJitter = 0.0; ///< median
        double perJitterSd = 0.0;
    };
    double radius_m = 0.1;
    double radiusScale_m = 0.0012;
    double step = 0.0; ///< rad, signed
    std::array<KindOfMotion, kKinds> kinds{};
    double driftScale_m = 0.001;
    double searchHalf_m = 0.12;

    double logCentre(double x, double y) const;
    double logRadius(double radius) const;
    double logMotion(double stepAngle, double logJitter) const;
    double logDrift(double x, double y) const;
    static double logTableScale(double logScale);

    struct Motion {
        double step = 0.0; ///< rad
        double logJitter = 0.0;
    };
    Motion drawMotion(SplitMix64& random) const;
    /// The mean step given `count` steps that average to `mean` and vary by exp(logJitter): from its exact
    /// conditional distribution.
    double drawStepGiven(double mean, std::size_t count, double logJitter, SplitMix64& random) const;
    double drawRadius(SplitMix64& random) const;
    double drawDrift(SplitMix64& random) const; ///< one axis
    static double drawLogTableScale(SplitMix64& random);
};

/// direction: +1 counter-clockwise, -1 clockwise.
MotionPrior motionPriorFor(const TurnEvidence& evidence, double antennaSd_m, double direction);

} // namespace agv::estimation
