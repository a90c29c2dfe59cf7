// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fast/antenna_grid.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr double kPitch_m = 0.004;
constexpr float kPlausible = 14.0F;        ///< nats below the best cell that still count
constexpr double kLeastInformative = 0.05; ///< share of the precision a stop keeps at least

float logLikelihoodAt(const StopEvidence& stop, const LikelihoodBank& bank, float x, float y)
{
    const float* table = bank.data();
    const int last = bank.cells() - 1;
    float sum = 0.0F;
    for (const TagTerm& term : stop.terms) {
        const float dx = x - term.x;
        const float dy = y - term.y;
        const float cell = std::sqrt(dx * dx + dy * dy) * bank.cellsPerMetre() + 0.5F;
        sum += term.weight * table[term.outcome * bank.cells() + std::min(static_cast<int>(cell), last)];
    }
    return sum;
}

} // namespace

AntennaGrid::AntennaGrid(const StopEvidence& stop, const LikelihoodBank& bank, double reach_m)
{
    if (stop.tagsRead == 0)
        return;
    m_pitch = std::max(kPitch_m, reach_m / 35.0);
    const int half = static_cast<int>(std::ceil(1.05 * reach_m / m_pitch));
    float best = -1e30F;
    for (int i = -half; i <= half; ++i) {
        for (int j = -half; j <= half; ++j) {
            const auto x = static_cast<float>(stop.meanOfRead.x + i * m_pitch);
            const auto y = static_cast<float>(stop.meanOfRead.y + j * m_pitch);
            const float value = logLikelihoodAt(stop, bank, x, y);
            best = std::max(best, value);
            if (value > best - kPlausible)
                m_cells.push_back({x, y, value});
        }
    }
    std::erase_if(m_cells, [best](const Cell& cell) { return cell.logLikelihood < best - kPlausible; });
}

AntennaFix AntennaGrid::fix(const std::optional<Prediction>& prediction) const
{
    if (m_cells.empty())
        return {};
    const double precision = prediction ? 1.0 / (prediction->sd_m * prediction->sd_m) : 0.0;
    const auto logWeight = [&](const Cell& cell) {
        const std::complex<double> at(cell.x, cell.y);
        return cell.logLikelihood -
               (prediction ? 0.5 * precision * std::norm(at - prediction->position) : 0.0);
    };
    double best = -1e300;
    for (const Cell& cell : m_cells)
        best = std::max(best, logWeight(cell));
    double sum = 0.0;
    std::complex<double> first;
    double second = 0.0;
    for (const Cell& cell : m_cells) {
        const double w = std::exp(logWeight(cell) - best);
        const std::complex<double> at(cell.x, cell.y);
        sum += w;
        first += w * at;
        second += w * std::norm(at);
    }
    const std::complex<double> mean = first / sum;
    const double variance = std::max(0.0, 0.5 * (second / sum - std::norm(mean))) + m_pitch * m_pitch / 12.0;
    if (!prediction)
        return {mean, 1.0 / variance};
    // The prediction is not information of this stop: divide it out of the Gaussian (expectation
    // propagation).
    const double weight = 1.0 / variance - precision;
    if (weight < kLeastInformative / variance)
        return {mean, kLeastInformative / variance};
    return {(mean / variance - precision * prediction->position) / weight, weight};
}

} // namespace agv::estimation
