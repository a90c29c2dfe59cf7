// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace agv::estimation {

/// How far an estimated pose is from the true one.
struct PoseError {
    double position_m = 0.0; ///< >= 0
    double heading = 0.0;    ///< rad, signed, (-pi, pi]
};

inline PoseError errorOf(const Pose2& estimate, const Pose2& truth)
{
    return {distance(estimate.position, truth.position), wrapAngle(estimate.heading - truth.heading)};
}

/// Squared Mahalanobis distance of the position error; below chi2(2, 95 %) = 5.991 the truth lies inside
/// the 95 % region. `floor_m` keeps a degenerate covariance from dividing by zero.
inline double normalisedPositionError2(const Pose2& estimate, const PoseCovariance& covariance,
                                       const Pose2& truth, double floor_m = 1e-6)
{
    const double dx = estimate.position.x - truth.position.x;
    const double dy = estimate.position.y - truth.position.y;
    const double xx = covariance[0] + floor_m * floor_m;
    const double yy = covariance[4] + floor_m * floor_m;
    const double xy = covariance[1];
    const double determinant = xx * yy - xy * xy;
    return (yy * dx * dx - 2.0 * xy * dx * dy + xx * dy * dy) / determinant;
}

constexpr double kChiSquared2At95 = 5.991464547;

/// A sample of magnitudes (errors, times) and its usual summaries. Empty: all zero.
class ErrorSample {
public:
    void add(double value) { m_values.push_back(std::abs(value)); }
    std::size_t size() const { return m_values.size(); }

    double mean() const
    {
        double sum = 0.0;
        for (const double v : m_values)
            sum += v;
        return m_values.empty() ? 0.0 : sum / static_cast<double>(m_values.size());
    }

    double rms() const
    {
        double sum = 0.0;
        for (const double v : m_values)
            sum += v * v;
        return m_values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(m_values.size()));
    }

    /// Linear interpolation between order statistics; `share` in [0, 1].
    double quantile(double share) const
    {
        if (m_values.empty())
            return 0.0;
        std::vector<double> sorted = m_values;
        std::sort(sorted.begin(), sorted.end());
        const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, sorted.size() - 1);
        return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
    }

    double max() const { return quantile(1.0); }

private:
    std::vector<double> m_values;
};

} // namespace agv::estimation
