// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/fast/circle_fit.h"
#include "estimation/likelihood_bank.h"
#include "estimation/turn_evidence.h"

#include <optional>
#include <vector>

namespace agv::estimation {

/// Posterior of the antenna position at one stop on a square grid around the tags read there: all
/// branches of the RSSI relation and the tags not read, from model 0 of the bank.
class AntennaGrid {
public:
    AntennaGrid(const StopEvidence& stop, const LikelihoodBank& bank, double reach_m);

    /// A prediction of the antenna position to combine with: Gaussian, sd per axis in m.
    struct Prediction {
        std::complex<double> position;
        double sd_m = 0.0;
    };

    /// Mean and variance of the posterior, with the prediction if there is one.
    AntennaFix fix(const std::optional<Prediction>& prediction) const;

private:
    struct Cell {
        float x, y, logLikelihood;
    };
    std::vector<Cell> m_cells; ///< the plausible ones only
    double m_pitch = 0.0;
};

} // namespace agv::estimation
