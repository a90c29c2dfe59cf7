// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/joint/tempering.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr int kBisections = 24;

double largest(std::span<const double> values) { return *std::max_element(values.begin(), values.end()); }

} // namespace

double effectiveSize(std::span<const double> logWeights, double power)
{
    const double top = largest(logWeights);
    double sum = 0.0;
    double squares = 0.0;
    for (const double value : logWeights) {
        const double w = std::exp(power * (value - top));
        sum += w;
        squares += w * w;
    }
    return sum * sum / squares;
}

double largestPower(std::span<const double> logWeights, double limit, double target)
{
    if (effectiveSize(logWeights, limit) >= target)
        return limit;
    double low = 0.0;
    double high = limit;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (low + high);
        (effectiveSize(logWeights, middle) < target ? high : low) = middle;
    }
    return low;
}

double logMeanWeight(std::span<const double> logWeights, double power)
{
    const double top = largest(logWeights);
    double sum = 0.0;
    for (const double value : logWeights)
        sum += std::exp(power * (value - top));
    return power * top + std::log(sum / static_cast<double>(logWeights.size()));
}

std::vector<std::uint32_t> resample(std::span<const double> logWeights, double power, std::size_t count,
                                    SplitMix64& random)
{
    const double top = largest(logWeights);
    std::vector<double> cumulated(logWeights.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < logWeights.size(); ++i) {
        sum += std::exp(power * (logWeights[i] - top));
        cumulated[i] = sum;
    }
    std::vector<std::uint32_t> chosen(count);
    const double offset = random.uniform();
    std::size_t j = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = (offset + static_cast<double>(i)) / static_cast<double>(count) * sum;
        while (j + 1 < cumulated.size() && cumulated[j] < at)
            ++j;
        chosen[i] = static_cast<std::uint32_t>(j);
    }
    return chosen;
}

} // namespace agv::estimation
