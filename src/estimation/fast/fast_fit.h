// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/fast/circle_fit.h"
#include "estimation/turn_evidence.h"

#include <stop_token>
#include <vector>

namespace agv::estimation {

/// The quick answer for one direction of rotation.
struct FastFit {
    CircleFit circle;
    std::vector<AntennaFix> fixes; ///< per stop
    double score = -1e300;         ///< log likelihood at the fit plus log prior: compares the directions
};

/// Both directions, best first. Invalid circles when fewer than two stops have reads.
///
/// Model: z_k = c + u exp(i k s) + e_k with the antenna positions z_k known through their grid posteriors.
/// The posteriors have several modes, so the fit is repeated with its own prediction of z_k as prior of
/// each stop, which is divided out again afterwards (expectation propagation, two rounds).
struct FastFits {
    FastFit best;
    FastFit other;
};
FastFits fitFast(const TurnEvidence& evidence, const RssiTable& table, std::stop_token stop);

} // namespace agv::estimation
