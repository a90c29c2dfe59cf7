// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/joint/turn_population.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace agv::estimation {

namespace {

constexpr float kTwoPi = 2.0F * std::numbers::pi_v<float>;
constexpr float kCentreStir_m = 5e-5F; ///< keeps a population of equal particles moving
constexpr float kAngleStir = 5e-4F;
constexpr float kLogScaleStir = 2e-4F;
constexpr float kLogJitterStir = 0.15F;
constexpr double kKeepsDifference = 0.75; ///< probability that a coordinate takes part in a global move
constexpr double kMoveDimensions = 7.0;
constexpr double kAnyProfile = 0.3; ///< share of proposals that jump to any profile, not to a neighbour

/// In [0, n).
std::uint32_t indexBelow(SplitMix64& random, std::size_t n)
{
    return static_cast<std::uint32_t>(((random.next() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
}

float wrapped(float angle) { return angle - kTwoPi * std::round(angle / kTwoPi); }

} // namespace

Particles drawFromPrior(const MotionPrior& prior, std::size_t count, std::size_t stops, SplitMix64& random)
{
    Particles p(count, stops);
    for (std::size_t i = 0; i < count; ++i) {
        p.x[i] = static_cast<float>(random.uniform(-prior.searchHalf_m, prior.searchHalf_m));
        p.y[i] = static_cast<float>(random.uniform(-prior.searchHalf_m, prior.searchHalf_m));
        p.driftX[i] = static_cast<float>(prior.drawDrift(random));
        p.driftY[i] = static_cast<float>(prior.drawDrift(random));
        p.radius[i] = static_cast<float>(prior.drawRadius(random));
        const auto [step, logJitter] = prior.drawMotion(random);
        p.step[i] = static_cast<float>(step);
        p.logJitter[i] = static_cast<float>(logJitter);
        p.logScale[i] = static_cast<float>(MotionPrior::drawLogTableScale(random));
        double bearing = random.uniform(-std::numbers::pi, std::numbers::pi);
        const double jitter = std::exp(logJitter);
        for (std::size_t k = 0; k < stops; ++k) {
            p.bearingOf(k, i) = static_cast<float>(bearing);
            bearing += step + jitter * random.normal();
        }
    }
    return p;
}

TurnPopulation::TurnPopulation(Particles particles, const MotionPrior& prior, const NoiseProfiles& profiles,
                               const TurnEvidence& evidence, std::uint64_t seed)
    : m_particles(std::move(particles)),
      m_proposal(m_particles),
      m_frozen(m_particles),
      m_logLikelihood(m_particles.bearing.size()),
      m_proposed(m_particles.bearing.size()),
      m_meanBearing(m_particles.size()),
      m_prior(prior),
      m_profiles(profiles),
      m_likelihood(evidence),
      m_random(seed)
{}

void TurnPopulation::restrictTags(double reach_m)
{
    const float largest = *std::max_element(m_particles.logScale.begin(), m_particles.logScale.end());
    m_likelihood.restrictTo(m_particles, reach_m * std::exp(static_cast<double>(largest) + 0.02));
}

void TurnPopulation::select(std::span<const std::uint32_t> chosen)
{
    Particles next(chosen.size(), m_particles.stops());
    for (std::size_t i = 0; i < chosen.size(); ++i)
        next.take(i, m_particles, chosen[i]);
    m_particles = std::move(next);
    m_logLikelihood.resize(m_particles.bearing.size());
    m_proposed.resize(m_particles.bearing.size());
    m_meanBearing.resize(chosen.size());
    m_proposal = m_particles;
}

void TurnPopulation::drawProfiles()
{
    // Stratified: every model gets its share of the population.
    for (std::size_t i = 0; i < m_particles.size(); ++i)
        m_particles.profile[i] =
            m_profiles.drawn((static_cast<double>(i) + 0.5) / static_cast<double>(m_particles.size()));
    // Neighbours in the population are often copies of each other; the models must not follow them.
    for (std::size_t i = m_particles.size() - 1; i > 0; --i)
        std::swap(m_particles.profile[i], m_particles.profile[indexBelow(m_random, i + 1)]);
}

std::vector<double> TurnPopulation::totals(const LikelihoodBank& bank) const
{
    std::vector<float> values(m_particles.bearing.size());
    m_likelihood.evaluate(m_particles, bank, 0, 1, values.data());
    std::vector<double> sums(m_particles.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] = sumOf(values, i);
    return sums;
}

double TurnPopulation::sumOf(const std::vector<float>& values, std::size_t i) const
{
    double sum = 0.0;
    for (std::size_t k = 0; k < m_particles.stops(); ++k)
        sum += static_cast<double>(values[k * m_particles.size() + i]);
    return sum;
}

void TurnPopulation::setTarget(const LikelihoodBank& bank)
{
    m_likelihood.evaluate(m_particles, bank, 0, 1, m_logLikelihood.data());
}

float TurnPopulation::symmetric()
{
    return static_cast<float>((m_random.uniform() + m_random.uniform() - 1.0) * std::sqrt(6.0));
}

double TurnPopulation::logPriorOf(const Particles& p, std::size_t i) const
{
    return m_prior.logCentre(static_cast<double>(p.x[i]), static_cast<double>(p.y[i])) +
           m_prior.logDrift(static_cast<double>(p.driftX[i]), static_cast<double>(p.driftY[i])) +
           m_prior.logRadius(static_cast<double>(p.radius[i])) +
           m_prior.logMotion(static_cast<double>(p.step[i]), static_cast<double>(p.logJitter[i])) +
           MotionPrior::logTableScale(static_cast<double>(p.logScale[i]));
}

void TurnPopulation::accept(std::size_t i)
{
    m_particles.take(i, m_proposal, i);
    for (std::size_t k = 0; k < m_particles.stops(); ++k)
        m_logLikelihood[k * m_particles.size() + i] = m_proposed[k * m_particles.size() + i];
}

void TurnPopulation::proposeGlobally(std::size_t i, bool jump)
{
    const std::size_t a = indexBelow(m_random, m_frozen.size());
    const std::size_t b = indexBelow(m_random, m_frozen.size());
    const double gamma = jump ? 1.0
                              : 2.38 / std::sqrt(2.0 * kMoveDimensions) *
                                    std::exp(0.5 * static_cast<double>(symmetric()) - 0.3);
    const auto part = [&](float difference) {
        return m_random.uniform() < kKeepsDifference ? static_cast<float>(gamma) * difference : 0.0F;
    };
    Particles& q = m_proposal;
    q.x[i] = m_particles.x[i] + part(m_frozen.x[a] - m_frozen.x[b]) + kCentreStir_m * symmetric();
    q.y[i] = m_particles.y[i] + part(m_frozen.y[a] - m_frozen.y[b]) + kCentreStir_m * symmetric();
    q.driftX[i] =
        m_particles.driftX[i] + part(m_frozen.driftX[a] - m_frozen.driftX[b]) + kCentreStir_m * symmetric();
    q.driftY[i] =
        m_particles.driftY[i] + part(m_frozen.driftY[a] - m_frozen.driftY[b]) + kCentreStir_m * symmetric();
    q.radius[i] = m_particles.radius[i] + part(m_frozen.radius[a] - m_frozen.radius[b]);
    const float stepChange = part(m_frozen.step[a] - m_frozen.step[b]);
    q.step[i] = m_particles.step[i] + stepChange;
    q.logScale[i] = m_particles.logScale[i] + part(m_frozen.logScale[a] - m_frozen.logScale[b]) +
                    kLogScaleStir * symmetric();
    q.logJitter[i] = m_particles.logJitter[i] + part(m_frozen.logJitter[a] - m_frozen.logJitter[b]) +
                     kLogJitterStir * symmetric();
    q.profile[i] = m_particles.profile[i];

    const float turn = part(wrapped(m_meanBearing[a] - m_meanBearing[b])) + kAngleStir * symmetric();
    const std::size_t stops = m_particles.stops();
    const float middle = 0.5F * static_cast<float>(stops - 1);
    float mean = 0.0F;
    for (std::size_t k = 0; k < stops; ++k)
        mean += m_particles.bearingOf(k, i) / static_cast<float>(stops);
    const float stretch = std::exp(q.logJitter[i] - m_particles.logJitter[i]);
    for (std::size_t k = 0; k < stops; ++k) {
        const float line = static_cast<float>(k) - middle;
        const float rest = m_particles.bearingOf(k, i) - mean - m_particles.step[i] * line;
        q.bearingOf(k, i) = mean + turn + q.step[i] * line + stretch * rest;
    }
}

void TurnPopulation::moveGlobally(const LikelihoodBank& bank, bool jump)
{
    const std::size_t n = m_particles.size();
    m_frozen = m_particles;
    for (std::size_t i = 0; i < n; ++i) {
        float mean = 0.0F;
        for (std::size_t k = 0; k < m_particles.stops(); ++k)
            mean += m_particles.bearingOf(k, i) / static_cast<float>(m_particles.stops());
        m_meanBearing[i] = mean;
    }
    for (std::size_t i = 0; i < n; ++i)
        proposeGlobally(i, jump);
    m_likelihood.evaluate(m_proposal, bank, 0, 1, m_proposed.data());
    m_globalMoves += n;
    for (std::size_t i = 0; i < n; ++i) {
        const double ratio = sumOf(m_proposed, i) - sumOf(m_logLikelihood, i) + logPriorOf(m_proposal, i) -
                             logPriorOf(m_particles, i);
        if (std::log(m_random.uniform() + 1e-300) < ratio) {
            accept(i);
            ++m_globalAccepted;
        }
    }
}

/// Log prior of the one or two steps next to a stop, if its bearing were `bearing`.
double TurnPopulation::logStepsAround(const Particles& p, std::size_t i, std::size_t stop,
                                      float bearing) const
{
    const double precision = std::exp(-2.0 * static_cast<double>(p.logJitter[i]));
    double sum = 0.0;
    if (stop > 0) {
        const double off = static_cast<double>(bearing - p.bearingOf(stop - 1, i) - p.step[i]);
        sum -= 0.5 * precision * off * off;
    }
    if (stop + 1 < p.stops()) {
        const double off = static_cast<double>(p.bearingOf(stop + 1, i) - bearing - p.step[i]);
        sum -= 0.5 * precision * off * off;
    }
    return sum;
}

void TurnPopulation::moveBearings(const LikelihoodBank& bank, std::size_t parity)
{
    const std::size_t n = m_particles.size();
    m_proposal = m_particles;
    for (std::size_t i = 0; i < n; ++i) {
        const auto spread = static_cast<float>(
            std::exp(static_cast<double>(m_particles.logJitter[i]) + m_random.uniform(-1.5, 0.7)));
        for (std::size_t k = parity; k < m_particles.stops(); k += 2)
            m_proposal.bearingOf(k, i) += spread * symmetric();
    }
    m_likelihood.evaluate(m_proposal, bank, parity, 2, m_proposed.data());
    for (std::size_t k = parity; k < m_particles.stops(); k += 2) {
        for (std::size_t i = 0; i < n; ++i) {
            const double ratio = static_cast<double>(m_proposed[k * n + i] - m_logLikelihood[k * n + i]) +
                                 logStepsAround(m_particles, i, k, m_proposal.bearingOf(k, i)) -
                                 logStepsAround(m_particles, i, k, m_particles.bearingOf(k, i));
            if (std::log(m_random.uniform() + 1e-300) < ratio) {
                m_particles.bearingOf(k, i) = m_proposal.bearingOf(k, i);
                m_logLikelihood[k * n + i] = m_proposed[k * n + i];
            }
        }
    }
}

void TurnPopulation::drawStep()
{
    const std::size_t stops = m_particles.stops();
    if (stops < 2)
        return;
    for (std::size_t i = 0; i < m_particles.size(); ++i) {
        const auto turned =
            static_cast<double>(m_particles.bearingOf(stops - 1, i) - m_particles.bearingOf(0, i));
        const double drawn = m_prior.drawStepGiven(turned / static_cast<double>(stops - 1), stops - 1,
                                                   static_cast<double>(m_particles.logJitter[i]), m_random);
        if (drawn * m_prior.step > 0.0)
            m_particles.step[i] = static_cast<float>(drawn);
    }
}

void TurnPopulation::moveJitter()
{
    const std::size_t stops = m_particles.stops();
    for (std::size_t i = 0; i < m_particles.size(); ++i) {
        double squares = 0.0;
        for (std::size_t k = 1; k < stops; ++k) {
            const auto off = static_cast<double>(m_particles.bearingOf(k, i) -
                                                 m_particles.bearingOf(k - 1, i) - m_particles.step[i]);
            squares += off * off;
        }
        const auto logDensity = [&](double logSd) {
            return m_prior.logMotion(static_cast<double>(m_particles.step[i]), logSd) -
                   static_cast<double>(stops - 1) * logSd - 0.5 * squares * std::exp(-2.0 * logSd);
        };
        const auto now = static_cast<double>(m_particles.logJitter[i]);
        const double proposed = now + 0.6 * static_cast<double>(symmetric());
        if (std::log(m_random.uniform() + 1e-300) < logDensity(proposed) - logDensity(now))
            m_particles.logJitter[i] = static_cast<float>(proposed);
    }
}

void TurnPopulation::moveProfile(const LikelihoodBank& bank)
{
    if (bank.models() < 2)
        return;
    m_proposal = m_particles;
    for (std::size_t i = 0; i < m_particles.size(); ++i) {
        const int choice = static_cast<int>(indexBelow(m_random, 4));
        const int next =
            m_random.uniform() < kAnyProfile
                ? static_cast<int>(indexBelow(m_random, static_cast<std::size_t>(m_profiles.count())))
                : m_profiles.neighbour(m_particles.profile[i], choice);
        m_proposal.profile[i] = next < 0 ? m_particles.profile[i] : next;
    }
    m_likelihood.evaluate(m_proposal, bank, 0, 1, m_proposed.data());
    for (std::size_t i = 0; i < m_particles.size(); ++i) {
        const double ratio = sumOf(m_proposed, i) - sumOf(m_logLikelihood, i) +
                             m_profiles.logPrior(m_proposal.profile[i]) -
                             m_profiles.logPrior(m_particles.profile[i]);
        if (std::log(m_random.uniform() + 1e-300) < ratio)
            accept(i);
    }
}

void TurnPopulation::sweep(const LikelihoodBank& bank, int sweepIndex)
{
    moveGlobally(bank, sweepIndex % 4 == 3);
    for (std::size_t parity = 0; parity < 2; ++parity)
        moveBearings(bank, parity);
    drawStep();
    moveJitter();
    moveProfile(bank);
}

double TurnPopulation::acceptance() const
{
    return m_globalMoves == 0 ? 0.0
                              : static_cast<double>(m_globalAccepted) / static_cast<double>(m_globalMoves);
}

} // namespace agv::estimation
