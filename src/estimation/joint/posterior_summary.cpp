// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/joint/posterior_summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace agv::estimation {

namespace {

/// Poses further apart than these are different answers, not the spread of one.
constexpr double kModeDistance_m = 0.025;
constexpr double kModeAngle = radFromDeg(18.0);
constexpr double kSplitGapSds = 0.6; ///< study, section A.3

struct CircularMean {
    double sine = 0.0;
    double cosine = 0.0;
    void add(double angle)
    {
        sine += std::sin(angle);
        cosine += std::cos(angle);
    }
    double angle() const { return std::atan2(sine, cosine); }
};

using Members = std::vector<std::size_t>;

/// Groups of particles around the most likely ones, largest first.
std::vector<Members> modesOf(const Particles& p, const std::vector<double>& logLikelihoods)
{
    std::vector<std::size_t> byLikelihood(p.size());
    std::iota(byLikelihood.begin(), byLikelihood.end(), 0);
    std::sort(byLikelihood.begin(), byLikelihood.end(), [&](std::size_t a, std::size_t b) {
        return logLikelihoods[a] != logLikelihoods[b] ? logLikelihoods[a] > logLikelihoods[b] : a < b;
    });
    std::vector<Members> modes;
    for (const std::size_t i : byLikelihood) {
        const auto near = [&](const Members& mode) {
            const std::size_t leader = mode.front();
            return std::hypot(p.x[i] - p.x[leader], p.y[i] - p.y[leader]) < kModeDistance_m &&
                   std::abs(wrapAngle(static_cast<double>(p.bearingOf(0, i) - p.bearingOf(0, leader)))) <
                       kModeAngle;
        };
        const auto mode = std::ranges::find_if(modes, near);
        if (mode != modes.end())
            mode->push_back(i);
        else
            modes.push_back({i});
    }
    std::ranges::sort(modes, [](const Members& a, const Members& b) {
        return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
    });
    return modes;
}

double meanOf(const std::vector<float>& values, const Members& members)
{
    double sum = 0.0;
    for (const std::size_t i : members)
        sum += static_cast<double>(values[i]);
    return sum / static_cast<double>(members.size());
}

Point2 startCentre(const Particles& p, const Members& members)
{
    const auto drifted = static_cast<double>(p.drifted(0));
    return {meanOf(p.x, members) + drifted * meanOf(p.driftX, members),
            meanOf(p.y, members) + drifted * meanOf(p.driftY, members)};
}

double meanBearing(const Particles& p, std::size_t stop, const Members& members)
{
    CircularMean mean;
    for (const std::size_t i : members)
        mean.add(static_cast<double>(p.bearingOf(stop, i)));
    return mean.angle();
}

/// Of the unknown walk of the centre the line from the first to the last stop is estimated. What a Brownian
/// walk with the same mean squared slope does besides displaces each end by 1/9 of that square.
constexpr double kWalkBesidesLine = 1.0 / 9.0;

/// The walk's share in the variance of either end, per axis, m^2.
double walkVariance(const Particles& p)
{
    double squares = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i)
        squares += static_cast<double>(p.driftX[i] * p.driftX[i] + p.driftY[i] * p.driftY[i]);
    return kWalkBesidesLine * 0.5 * squares / static_cast<double>(p.size());
}

/// Mean squared distance of the centre at a stop from `mean`.
double centreSpread(const Particles& p, Point2 mean, float drifted)
{
    double squares = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = static_cast<double>(p.x[i] + drifted * p.driftX[i]) - mean.x;
        const double y = static_cast<double>(p.y[i] + drifted * p.driftY[i]) - mean.y;
        squares += x * x + y * y;
    }
    return squares / static_cast<double>(p.size());
}

/// Makes the covariance of the pose at stop 0 large enough for the pose at the last stop; scaling rows and
/// columns keeps the correlations.
void coverLastCentre(double lastSpread, PoseCovariance& c)
{
    const double scale = std::sqrt(std::max(1.0, lastSpread / std::max(c[0] + c[4], 1e-12)));
    for (const std::size_t index : {0U, 1U, 3U, 4U})
        c[index] *= scale * scale;
    for (const std::size_t index : {2U, 5U, 6U, 7U})
        c[index] *= scale;
}

/// Second moments of all particles about the mean of the main mode.
void addSpread(const Particles& p, TurnSolution& s)
{
    const double n = static_cast<double>(p.size());
    const float drifted = p.drifted(0);
    PoseCovariance& c = s.covariance;
    double last = 0.0;
    double step = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const std::array<double, 3> off{
            static_cast<double>(p.x[i] + drifted * p.driftX[i]) - s.centre.x,
            static_cast<double>(p.y[i] + drifted * p.driftY[i]) - s.centre.y,
            wrapAngle(static_cast<double>(p.bearingOf(0, i)) - s.bearings.front())};
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                c[3 * row + column] += off[row] * off[column] / n;
        const double offLast =
            wrapAngle(static_cast<double>(p.bearingOf(p.stops() - 1, i)) - s.bearings.back());
        last += offLast * offLast / n;
        const double offStep = std::abs(static_cast<double>(p.step[i])) - s.step;
        step += offStep * offStep / n;
    }
    coverLastCentre(centreSpread(p, s.centre + s.drift, p.drifted(p.stops() - 1)), c);
    const double walk = walkVariance(p);
    c[0] += walk;
    c[4] += walk;
    s.lastBearingSd = std::sqrt(last);
    s.stepSd = std::sqrt(step);
}

void addAntennas(const Particles& p, TurnSolution& s)
{
    const double n = static_cast<double>(p.size());
    for (std::size_t k = 0; k < p.stops(); ++k) {
        const Point2 mean = s.antennaAt(k);
        const float drifted = p.drifted(k);
        double squares = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto bearing = static_cast<double>(p.bearingOf(k, i));
            const auto radius = static_cast<double>(p.radius[i]);
            const auto x = static_cast<double>(p.x[i] + drifted * p.driftX[i]);
            const auto y = static_cast<double>(p.y[i] + drifted * p.driftY[i]);
            const double dx = x + radius * std::cos(bearing) - mean.x;
            const double dy = y + radius * std::sin(bearing) - mean.y;
            squares += dx * dx + dy * dy;
        }
        s.antennaSd_m.push_back(std::sqrt(0.5 * squares / n));
    }
}

/// Largest gap between neighbouring values in the central 94 %, in standard deviations.
double largestGap(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const double n = static_cast<double>(values.size());
    double sum = 0.0;
    double squares = 0.0;
    for (const double v : values) {
        sum += v;
        squares += v * v;
    }
    const double sd = std::sqrt(std::max(1e-18, squares / n - sum * sum / (n * n)));
    double gap = 0.0;
    for (auto i = static_cast<std::size_t>(0.03 * n); i + 1 < static_cast<std::size_t>(0.97 * n); ++i)
        gap = std::max(gap, values[i + 1] - values[i]);
    return gap / sd;
}

bool isSplit(const Particles& p, double bearing)
{
    std::vector<double> bearings(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
        bearings[i] = wrapAngle(static_cast<double>(p.bearingOf(0, i)) - bearing);
    return largestGap({p.x.begin(), p.x.end()}) > kSplitGapSds ||
           largestGap({p.y.begin(), p.y.end()}) > kSplitGapSds || largestGap(bearings) > kSplitGapSds;
}

int mostFrequentProfile(const Particles& p, int profiles)
{
    std::vector<int> counts(static_cast<std::size_t>(profiles));
    for (const int profile : p.profile)
        ++counts[static_cast<std::size_t>(profile)];
    return static_cast<int>(std::ranges::max_element(counts) - counts.begin());
}

/// Root mean square of the steps' departures from their mean.
double unevennessOf(const std::vector<double>& bearings, double step)
{
    if (bearings.size() < 2)
        return 0.0;
    double squares = 0.0;
    for (std::size_t k = 1; k < bearings.size(); ++k) {
        const double off = wrapAngle(bearings[k] - bearings[k - 1] - step);
        squares += off * off;
    }
    return std::sqrt(squares / static_cast<double>(bearings.size() - 1));
}

} // namespace

TurnSolution summarise(const TurnSampler& sampler)
{
    const Particles& p = sampler.sample();
    const std::vector<Members> modes = modesOf(p, sampler.sampleLogLikelihoods());
    const Members& main = modes.front();
    TurnSolution s;
    s.centre = startCentre(p, main);
    s.drift = {meanOf(p.driftX, main), meanOf(p.driftY, main)};
    s.radius_m = meanOf(p.radius, main);
    const double signedStep = meanOf(p.step, main);
    s.step = std::abs(signedStep);
    s.tableScale = std::exp(meanOf(p.logScale, main));
    for (std::size_t k = 0; k < p.stops(); ++k)
        s.bearings.push_back(meanBearing(p, k, main));
    addSpread(p, s);
    addAntennas(p, s);
    s.unevenness = unevennessOf(s.bearings, signedStep);
    const int profile = mostFrequentProfile(p, sampler.profiles().count());
    s.noise = sampler.profiles().model(profile);
    s.profile = sampler.profiles().name(profile);
    s.logEvidence = sampler.logEvidence();
    s.converged = sampler.converged();
    s.split = isSplit(p, s.bearings.front());
    if (modes.size() > 1)
        s.alternative =
            SolutionMode{startCentre(p, modes[1]), meanBearing(p, 0, modes[1]),
                         std::log(static_cast<double>(main.size()) / static_cast<double>(modes[1].size()))};
    return s;
}

} // namespace agv::estimation
