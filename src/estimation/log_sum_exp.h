// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace agv::estimation {

/// log(exp(a) + exp(b)) without overflow.
inline double logSumExp(double a, double b)
{
    const double most = std::max(a, b);
    return most + std::log1p(std::exp(std::min(a, b) - most));
}

} // namespace agv::estimation
