// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/fix.h"

namespace agv::estimation {

struct TwoStepSettings {
    /// Adds this to every coordinate measured from the anchors' centre, so that none is near zero, where the
    /// square roots of the second step fail; 0: the plant's own origin, as published. m
    double originShift_m = 10.0;
};

struct TwoStepToa {
    UwbFix fix;
    Eigen::Vector4d first = Eigen::Vector4d::Zero();  ///< z_a with the measured ranges in B (5.28)
    Eigen::Vector4d second = Eigen::Vector4d::Zero(); ///< z_a with B from the first z_a
    Eigen::Vector3d squares =
        Eigen::Vector3d::Zero(); ///< z_a' (5.38): squared coordinates from the shifted origin
    bool negativeSquare = false; ///< a square was below zero and counted as zero
};

/// The modified, two-step weighted 3-D TOA of the thesis (5.19 to 5.39). Misprints corrected: last row of
/// 5.22 is -2 Z_M; 5.31 has a factor 2; the fourth element of h' is z_a,4, not its square; 5.38 has the
/// transpose of G_a' and h'; 5.39 keeps the sign of the first step. With exactly four anchors the weights of
/// the first step do nothing, as G_a is square. Kept for comparison: Gauss-Newton is better everywhere.
TwoStepToa twoStepToa(AnchorRanges ranges, const TwoStepSettings& settings = {});

} // namespace agv::estimation
