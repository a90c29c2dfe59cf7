// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/obstruction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace agv::estimation {

namespace {

/// A range far outside both models decides nothing; this keeps 0/0 away (study, ref_filters).
constexpr double kFloor = 1e-12;
constexpr double kLeast = 0.01;

} // namespace

double logNormalCdf(double z)
{
    if (z > -30.0)
        return std::log(0.5 * std::erfc(-z / std::numbers::sqrt2));
    // Asymptotic series of the tail; at -30 the first term left out is below 1e-9 of the sum of 1.
    const double i = 1.0 / (z * z);
    const double series = 1.0 - i * (1.0 - 3.0 * i * (1.0 - 5.0 * i * (1.0 - 7.0 * i)));
    return -0.5 * z * z - kLogRootTwoPi - std::log(-z) + std::log(series);
}

double logNormalPlusExponential(double error, double sd, double mean)
{
    const double rate = 1.0 / mean;
    return std::log(rate) + rate * (0.5 * rate * sd * sd - error) + logNormalCdf(error / sd - rate * sd);
}

void Obstruction::predict(const ObstructionModel& model, double dt_s)
{
    const double hide = 1.0 - std::exp(-dt_s / model.seen_s);
    const double show = 1.0 - std::exp(-dt_s / model.hidden_s);
    m_seen = m_seen * (1.0 - hide) + (1.0 - m_seen) * show;
}

double Obstruction::update(const ObstructionModel& model, double innovation, double variance)
{
    const double sd = std::sqrt(variance);
    const double seen = -0.5 * innovation * innovation / variance - std::log(sd) - kLogRootTwoPi;
    const double hidden = logNormalPlusExponential(innovation, sd, model.meanBias_m);
    const double most = std::max(seen, hidden);
    const double a = m_seen * std::exp(seen - most);
    const double b = (1.0 - m_seen) * std::exp(hidden - most) + kFloor;
    const double p = a / (a + b);
    m_seen = std::clamp(p, kLeast, 1.0 - kLeast);
    return p;
}

} // namespace agv::estimation
