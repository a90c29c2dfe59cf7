// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/joint/population_likelihood.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr std::size_t kBlock = 64;     ///< particles per pass: the working set stays in the L1 cache
constexpr float kMoveMargin_m = 0.02F; ///< how far a proposal may leave the population's bounding box

using Block = std::array<float, kBlock>;

/// Sine and cosine to 1e-6 for |angle| < 1e4 rad, in a form the compiler vectorises: reduction to
/// [-pi/4, pi/4] by quarter turns, Taylor polynomials, selection by quadrant.
inline void sineCosine(float angle, float& sine, float& cosine)
{
    const float quarters = angle * 0.636619772F;
    const int quadrant = static_cast<int>(quarters + (quarters >= 0.0F ? 0.5F : -0.5F));
    const auto q = static_cast<float>(quadrant);
    const float r = (angle - q * 1.57079637F) + q * 4.37113883e-8F;
    const float r2 = r * r;
    const float s = r * (1.0F + r2 * (-1.6666667e-1F + r2 * (8.3333333e-3F - r2 * 1.9841270e-4F)));
    const float c = 1.0F + r2 * (-0.5F + r2 * (4.1666667e-2F + r2 * (-1.3888889e-3F + r2 * 2.4801587e-5F)));
    const bool swap = (quadrant & 1) != 0;
    const float first = swap ? c : s;
    const float second = swap ? s : c;
    sine = (quadrant & 2) != 0 ? -first : first;
    cosine = ((quadrant + 1) & 2) != 0 ? -second : second;
}

struct AntennaBlock {
    Block x;
    Block y;
    Block cellsPerMetre; ///< table cells per metre of true distance
    std::array<int, kBlock> model;
};

void placeAntennas(const Particles& p, std::size_t stop, std::size_t from, std::size_t count,
                   AntennaBlock& out)
{
    const float* bearing = p.bearingsAt(stop) + from;
    const float drifted = p.drifted(stop);
    for (std::size_t i = 0; i < count; ++i) {
        float sine = 0.0F;
        float cosine = 0.0F;
        sineCosine(bearing[i], sine, cosine);
        out.x[i] = p.x[from + i] + drifted * p.driftX[from + i] + p.radius[from + i] * cosine;
        out.y[i] = p.y[from + i] + drifted * p.driftY[from + i] + p.radius[from + i] * sine;
    }
}

void addTerm(const TagTerm& term, const AntennaBlock& antenna, std::size_t count, const float* outcomeTable,
             int lastCell, Block& sums)
{
    std::array<int, kBlock> cell;
    const auto last = static_cast<float>(lastCell);
    for (std::size_t i = 0; i < count; ++i) {
        const float dx = antenna.x[i] - term.x;
        const float dy = antenna.y[i] - term.y;
        const float place = std::sqrt(dx * dx + dy * dy) * antenna.cellsPerMetre[i] + 0.5F;
        cell[i] = static_cast<int>(place < last ? place : last) + antenna.model[i];
    }
    for (std::size_t i = 0; i < count; ++i)
        sums[i] += term.weight * outcomeTable[cell[i]];
}

/// exp(-u) for |u| <= 0.5 to 1e-6.
inline float expMinus(float u)
{
    return 1.0F - u * (1.0F - u * (0.5F - u * (0.16666667F - u * (0.041666667F - u * 0.0083333333F))));
}

} // namespace

PopulationLikelihood::PopulationLikelihood(const TurnEvidence& evidence) : m_evidence(evidence)
{
    for (const StopEvidence& stop : evidence.stops)
        m_terms.push_back(stop.terms);
}

void PopulationLikelihood::restrictTo(const Particles& particles, double reach_m)
{
    const auto reach = static_cast<float>(reach_m) + kMoveMargin_m;
    for (std::size_t k = 0; k < m_terms.size(); ++k) {
        const float drifted = particles.drifted(k);
        float minX = 1e9F, maxX = -1e9F, minY = 1e9F, maxY = -1e9F;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            float sine = 0.0F, cosine = 0.0F;
            sineCosine(particles.bearingOf(k, i), sine, cosine);
            const float x = particles.x[i] + drifted * particles.driftX[i] + particles.radius[i] * cosine;
            const float y = particles.y[i] + drifted * particles.driftY[i] + particles.radius[i] * sine;
            minX = std::min(minX, x);
            maxX = std::max(maxX, x);
            minY = std::min(minY, y);
            maxY = std::max(maxY, y);
        }
        m_terms[k].clear();
        for (const TagTerm& term : m_evidence.stops[k].terms) {
            const float dx = std::max({minX - term.x, 0.0F, term.x - maxX});
            const float dy = std::max({minY - term.y, 0.0F, term.y - maxY});
            if (term.outcome != kNotRead || dx * dx + dy * dy <= reach * reach)
                m_terms[k].push_back(term);
        }
    }
}

void PopulationLikelihood::evaluate(const Particles& particles, const LikelihoodBank& bank, std::size_t first,
                                    std::size_t stride, float* out) const
{
    const std::size_t n = particles.size();
    const int cells = bank.cells();
    AntennaBlock antenna;
    for (std::size_t from = 0; from < n; from += kBlock) {
        const std::size_t count = std::min(kBlock, n - from);
        for (std::size_t i = 0; i < count; ++i) {
            antenna.cellsPerMetre[i] = bank.cellsPerMetre() * expMinus(particles.logScale[from + i]);
            antenna.model[i] = bank.models() > 1 ? particles.profile[from + i] * bank.modelStride() : 0;
        }
        for (std::size_t k = first; k < m_terms.size(); k += stride) {
            placeAntennas(particles, k, from, count, antenna);
            Block sums{};
            for (const TagTerm& term : m_terms[k])
                addTerm(term, antenna, count, bank.data() + std::ptrdiff_t{term.outcome} * cells, cells - 1,
                        sums);
            std::copy_n(sums.begin(), count, out + k * n + from);
        }
    }
}

} // namespace agv::estimation
