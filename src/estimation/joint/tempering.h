// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"

#include <cstdint>
#include <span>
#include <vector>

namespace agv::estimation {

/// Effective sample size (sum w)^2 / sum w^2 of the weights exp(power * logWeights).
double effectiveSize(std::span<const double> logWeights, double power);

/// Largest power in (0, limit] that keeps the effective size at `target` or above.
double largestPower(std::span<const double> logWeights, double limit, double target);

/// Log of the mean weight exp(power * logWeights): the step's share of the log evidence.
double logMeanWeight(std::span<const double> logWeights, double power);

/// Systematic resampling: `count` indices, each in proportion to exp(power * logWeights).
std::vector<std::uint32_t> resample(std::span<const double> logWeights, double power, std::size_t count,
                                    SplitMix64& random);

} // namespace agv::estimation
