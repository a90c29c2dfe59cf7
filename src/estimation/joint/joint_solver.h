// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/turn_solution.h"

#include <optional>

namespace agv::estimation {

/// The answer of `auto`: joint Bayesian estimate of a whole turn.
///
/// State     centre (x, y), radius R, mean step s, bearings a_0..a_{K-1}, sd of single steps sigma_j,
///           scale kappa of the RSSI table, noise profile m
/// Motion    a_k - a_{k-1} ~ N(s, sigma_j^2), a_0 uniform; priors in motion_prior.h
/// Reads     P(outcome of tag t at stop k) = P_m(outcome | |c + R e(a_k) - t| / kappa), rssi_likelihood.h,
///           for every tag in reach, read or not
/// Answer    posterior means over everything else, noise profiles included: what the reads do not decide
///           widens the uncertainty instead of being chosen
///
/// Both directions of rotation are led through the blurred likelihoods; their evidence decides, with the
/// commanded direction as prior. Nothing: cancelled.
std::optional<TurnSolution> solveJoint(const TurnEvidence& evidence, const TurnRecord& record,
                                       const TurnContext& context, const SolveOptions& options);

} // namespace agv::estimation
