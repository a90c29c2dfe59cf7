// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/rssi_likelihood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace agv::estimation {

namespace {

constexpr double kSmallestSd_m = 1e-6; ///< below a micrometre the step function is exact anyway
constexpr std::size_t kMaxSteps = 256;

double normalCdf(double z) { return 0.5 * std::erfc(-z * (1.0 / std::numbers::sqrt2)); }

} // namespace

std::array<double, 8> trueRssiProbabilities(const RssiTable& table, double distanceSd_m, double distance_m)
{
    std::array<double, 8> sums{};
    const double sd = std::max(distanceSd_m, kSmallestSd_m);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double below = normalCdf((table[i].upperEdge - distance_m) / sd);
        const double nextBelow =
            i + 1 < table.size() ? normalCdf((table[i + 1].upperEdge - distance_m) / sd) : 0.0;
        sums[static_cast<std::size_t>(table[i].rssi)] += below - nextBelow;
    }
    return sums;
}

OutcomeProbabilities withNoise(const std::array<double, 8>& trueRssi, const NoiseModel& noise)
{
    OutcomeProbabilities result{};
    double inRange = 0.0;
    for (std::size_t t = 0; t < 8; ++t) {
        inRange += trueRssi[t];
        result[t] += (1.0 - noise.offByOne) * trueRssi[t];
        result[t > 0 ? t - 1 : 0] += 0.5 * noise.offByOne * trueRssi[t];
        result[t < 7 ? t + 1 : 7] += 0.5 * noise.offByOne * trueRssi[t];
    }
    const double read = 1.0 - noise.missed;
    for (std::size_t r = 0; r < 8; ++r)
        result[r] *= read;
    result[kNotRead] = 1.0 - read * inRange;
    for (double& p : result)
        p = (1.0 - noise.outlier) * p + noise.outlier / kOutcomes;
    return result;
}

RssiLikelihood::RssiLikelihood(RssiTable table, NoiseModel noise) : m_table(std::move(table)), m_noise(noise)
{}

OutcomeProbabilities RssiLikelihood::probabilities(double distance_m) const
{
    return withNoise(trueRssiProbabilities(m_table, m_noise.distanceSd_m, distance_m), m_noise);
}

double RssiLikelihood::logProbability(TagOutcome outcome, double distance_m) const
{
    return std::log(probabilities(distance_m)[static_cast<std::size_t>(outcome)]);
}

const char* problemOf(const RssiTable& table)
{
    if (table.empty() || table.size() > kMaxSteps)
        return "rssi_table_size";
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (!std::isfinite(table[i].upperEdge) || table[i].upperEdge <= 0.0 || table[i].upperEdge > 10.0)
            return "rssi_table_edge";
        if (i > 0 && table[i].upperEdge > table[i - 1].upperEdge)
            return "rssi_table_order";
        if (table[i].rssi < 0 || table[i].rssi > 7)
            return "rssi_table_rssi";
    }
    return "";
}

double logLikelihood(const RssiLikelihood& likelihood, Point2 antenna,
                     std::span<const TagObservation> observations)
{
    double sum = 0.0;
    for (const TagObservation& observation : observations)
        sum += likelihood.logProbability(observation.outcome, distance(antenna, observation.tag));
    return sum;
}

} // namespace agv::estimation
