// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/rssi_likelihood.h"

#include <span>
#include <vector>

namespace agv::estimation {

/// log P(outcome | distance) of several noise models as look-up tables in single precision.
///
/// Layout: [model][outcome][cell], cell = round(distance / pitch), clamped to the last cell. The entry of
/// "not read" is relative to a tag far away, so tags out of reach contribute exactly nothing and may be
/// left out of every sum.
class LikelihoodBank {
public:
    /// Tables up to `reach_m`, beyond which all models are flat; the table must be usable (problemOf).
    LikelihoodBank(const RssiTable& table, std::span<const NoiseModel> models, double reach_m);

    int models() const { return m_models; }
    int cells() const { return m_cells; }
    int modelStride() const { return kOutcomes * m_cells; }
    float cellsPerMetre() const { return 1.0F / m_pitch; }
    double reach_m() const { return static_cast<double>(m_pitch) * (m_cells - 1); }
    const float* data() const { return m_data.data(); }

    float at(int model, TagOutcome outcome, double distance_m) const;

    /// this = weight * target + (1 - weight) * from; `from` may have one model, used for all of them.
    void setBlend(const LikelihoodBank& target, const LikelihoodBank* from, float weight);

private:
    int m_models = 0;
    int m_cells = 0;
    float m_pitch = 0.0F;
    std::vector<float> m_data;
};

/// Distance beyond which no model of the given distance noise can tell distances apart.
double flatBeyond(const RssiTable& table, double largestDistanceSd_m);

} // namespace agv::estimation
