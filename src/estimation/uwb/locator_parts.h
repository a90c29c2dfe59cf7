// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/locator.h"

#include <algorithm>

namespace agv::estimation {

inline Located locatedFrom(const UwbFix& fix) { return {fix.status, fix.position, fix.covariance, {}, {}}; }

inline Located locatedAt(const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance, double height_m)
{
    Located result;
    result.status = FixStatus::Ok;
    result.position << position, height_m;
    result.covariance.topLeftCorner<2, 2>() = covariance;
    return result;
}

/// Time since the last call; 0 at the first and when time steps back.
class Stopwatch {
public:
    double since(double time_s)
    {
        const double dt = m_last ? std::max(time_s - *m_last, 0.0) : 0.0;
        m_last = time_s;
        return dt;
    }

private:
    std::optional<double> m_last;
};

/// The locators of MethodInput::Fusion that are not range trackers; null for other names.
std::unique_ptr<Locator> makeFusionLocator(std::string_view name, const LocatorSettings& settings);

} // namespace agv::estimation
