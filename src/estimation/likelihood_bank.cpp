// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/likelihood_bank.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace agv::estimation {

namespace {

constexpr double kFinestPitch_m = 0.0002; ///< a fifth of a millimetre: below any distance noise
constexpr int kMostCells = 1500;
constexpr double kFlatSds = 4.5; ///< standard deviations beyond the outermost edge

int cellsFor(double reach_m)
{
    return std::clamp(static_cast<int>(std::ceil(reach_m / kFinestPitch_m)) + 1, 2, kMostCells);
}

using RssiColumn = std::vector<std::array<double, 8>>;

RssiColumn columnOf(const RssiTable& table, double distanceSd_m, int cells, double pitch_m)
{
    RssiColumn column(static_cast<std::size_t>(cells));
    for (int i = 0; i < cells; ++i)
        column[static_cast<std::size_t>(i)] = trueRssiProbabilities(table, distanceSd_m, i * pitch_m);
    return column;
}

void fillModel(const RssiColumn& column, const NoiseModel& noise, float* out)
{
    const auto cells = column.size();
    const double far = std::log(withNoise({}, noise)[kNotRead]);
    for (std::size_t i = 0; i < cells; ++i) {
        const OutcomeProbabilities p = withNoise(column[i], noise);
        for (std::size_t outcome = 0; outcome < kOutcomes; ++outcome)
            out[outcome * cells + i] =
                static_cast<float>(std::log(p[outcome]) - (outcome == kNotRead ? far : 0.0));
    }
}

} // namespace

double flatBeyond(const RssiTable& table, double largestDistanceSd_m)
{
    return table.front().upperEdge + kFlatSds * largestDistanceSd_m;
}

LikelihoodBank::LikelihoodBank(const RssiTable& table, std::span<const NoiseModel> models, double reach_m)
    : m_models(static_cast<int>(models.size())),
      m_cells(cellsFor(reach_m)),
      m_pitch(static_cast<float>(reach_m / (m_cells - 1))),
      m_data(models.size() * kOutcomes * static_cast<std::size_t>(m_cells))
{
    std::map<double, RssiColumn> columns; // models often differ in nothing but misreadings and misses
    for (std::size_t m = 0; m < models.size(); ++m) {
        const double sd = models[m].distanceSd_m;
        auto found = columns.find(sd);
        if (found == columns.end())
            found = columns.emplace(sd, columnOf(table, sd, m_cells, static_cast<double>(m_pitch))).first;
        fillModel(found->second, models[m], m_data.data() + m * static_cast<std::size_t>(modelStride()));
    }
}

float LikelihoodBank::at(int model, TagOutcome outcome, double distance_m) const
{
    const double cell = std::min(distance_m / static_cast<double>(m_pitch) + 0.5, m_cells - 1.0);
    const int index = (model * kOutcomes + outcome) * m_cells + static_cast<int>(cell);
    return m_data[static_cast<std::size_t>(index)];
}

void LikelihoodBank::setBlend(const LikelihoodBank& target, const LikelihoodBank* from, float weight)
{
    const auto stride = static_cast<std::size_t>(target.modelStride());
    for (std::size_t m = 0; m < static_cast<std::size_t>(target.m_models); ++m) {
        float* out = m_data.data() + m * stride;
        const float* to = target.m_data.data() + m * stride;
        if (from == nullptr) {
            for (std::size_t i = 0; i < stride; ++i)
                out[i] = weight * to[i];
            continue;
        }
        const float* old = from->m_data.data() + (from->m_models > 1 ? m * stride : 0);
        for (std::size_t i = 0; i < stride; ++i)
            out[i] = weight * to[i] + (1.0F - weight) * old[i];
    }
}

} // namespace agv::estimation
