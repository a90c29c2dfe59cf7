// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/joint/turn_sampler.h"

#include "estimation/joint/tempering.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace agv::estimation {

namespace {

constexpr std::array kLeadingBlur_m{0.010, 0.005, 0.0025};
constexpr double kLargestBlur_m = 0.010;
constexpr NoiseModel kTolerant{.distanceSd_m = 0.0, .offByOne = 0.4, .missed = 0.2, .outlier = 2e-2};
constexpr double kKeptShare = 0.5; ///< effective share of the population a step keeps
constexpr int kSweepsPerStep = 3;
constexpr int kSamples = 10;        ///< times the final population is looked at ...
constexpr int kSweepsPerSample = 4; ///< ... after this many sweeps each
constexpr int kMostTemperatures = 60;

std::vector<LikelihoodBank> leadingTables(const RssiTable& table, double missed, double reach_m)
{
    std::vector<LikelihoodBank> banks;
    for (const double blur : kLeadingBlur_m) {
        NoiseModel noise = kTolerant;
        noise.distanceSd_m = blur;
        noise.missed = missed;
        banks.emplace_back(table, std::array{noise}, reach_m);
    }
    return banks;
}

} // namespace

SamplerTables::SamplerTables(const RssiTable& table, double missed)
    : leading(leadingTables(table, missed, flatBeyond(table, kLargestBlur_m))),
      profiles(table, noise.models(), flatBeyond(table, kLargestBlur_m)),
      reach_m(flatBeyond(table, kLargestBlur_m))
{}

TurnSampler::TurnSampler(const TurnEvidence& evidence, const SamplerTables& tables, const MotionPrior& prior,
                         std::uint64_t seed, std::stop_token stop)
    : m_tables(tables),
      m_population(Particles(1, evidence.stops.size()), prior, tables.noise, evidence, seed),
      m_prior(prior),
      m_stop(std::move(stop)),
      m_sample(0, evidence.stops.size())
{}

bool TurnSampler::sweeps(const LikelihoodBank& bank, int count)
{
    m_population.setTarget(bank);
    for (int i = 0; i < count; ++i) {
        if (m_stop.stop_requested())
            return false;
        m_population.sweep(bank, m_sweeps++);
    }
    return true;
}

bool TurnSampler::bridge(const LikelihoodBank* from, const LikelihoodBank& to, double done)
{
    LikelihoodBank blend = to;
    const std::size_t count = m_population.particles().size();
    double power = done;
    while (power < 1.0) {
        std::vector<double> gain = m_population.totals(to);
        if (from != nullptr) {
            const std::vector<double> before = m_population.totals(*from);
            for (std::size_t i = 0; i < gain.size(); ++i)
                gain[i] -= before[i];
        }
        double raise = largestPower(gain, 1.0 - power, kKeptShare * static_cast<double>(count));
        if (++m_temperatures > kMostTemperatures) {
            m_converged = false;
            raise = 1.0 - power;
        }
        m_logEvidence += logMeanWeight(gain, raise);
        m_population.select(resample(gain, raise, count, m_population.random()));
        power = power + raise > 1.0 - 1e-6 ? 1.0 : power + raise;
        blend.setBlend(to, from, static_cast<float>(power));
        m_population.restrictTags(m_tables.reach_m);
        if (!sweeps(blend, kSweepsPerStep))
            return false;
    }
    return true;
}

bool TurnSampler::lead(std::size_t drawn, std::size_t kept, std::size_t stages)
{
    SplitMix64& random = m_population.random();
    m_population.particles() = drawFromPrior(m_prior, drawn, m_population.particles().stops(), random);
    const LikelihoodBank& first = m_tables.leading.front();
    const std::vector<double> gain = m_population.totals(first);
    const double power = largestPower(gain, 1.0, 0.4 * static_cast<double>(kept));
    m_logEvidence += logMeanWeight(gain, power);
    m_population.select(resample(gain, power, kept, random));
    m_population.restrictTags(m_tables.reach_m);
    LikelihoodBank blend = first;
    blend.setBlend(first, nullptr, static_cast<float>(power));
    if (!sweeps(blend, kSweepsPerStep) || !bridge(nullptr, first, power))
        return false;
    for (std::size_t stage = 1; stage < stages; ++stage)
        if (!bridge(&m_tables.leading[stage - 1], m_tables.leading[stage], 0.0))
            return false;
    return true;
}

void TurnSampler::resize(std::size_t count)
{
    std::vector<std::uint32_t> chosen(count);
    const std::size_t now = m_population.particles().size();
    for (std::size_t i = 0; i < count; ++i)
        chosen[i] = static_cast<std::uint32_t>(i % now);
    m_population.select(chosen);
}

bool TurnSampler::finish(std::size_t count, std::size_t firstStage)
{
    resize(count);
    if (!sweeps(m_tables.leading[firstStage - 1], kSweepsPerStep))
        return false;
    for (std::size_t stage = firstStage; stage < m_tables.leading.size(); ++stage)
        if (!bridge(&m_tables.leading[stage - 1], m_tables.leading[stage], 0.0))
            return false;
    m_population.drawProfiles();
    return bridge(&m_tables.leading.back(), m_tables.profiles, 0.0) && collect();
}

bool TurnSampler::collect()
{
    for (int i = 0; i < kSamples; ++i) {
        if (!sweeps(m_tables.profiles, kSweepsPerSample))
            return false;
        const std::vector<double> values = m_population.totals(m_tables.profiles);
        m_sample.append(m_population.particles());
        m_sampleLogLikelihoods.insert(m_sampleLogLikelihoods.end(), values.begin(), values.end());
    }
    return true;
}

} // namespace agv::estimation
