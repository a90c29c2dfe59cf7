// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/anchor_range.h"

#include <array>
#include <optional>

namespace agv::estimation {

/// Small plain types for the inner loop of the fix, which must not cost a microsecond.
struct Vec3 {
    double x = 0.0, y = 0.0, z = 0.0;
};
struct Symmetric {
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
};

/// The cost 1/2 sum (e / sd)^2 and its derivatives at a point, e = r - |p - a|.
struct Slope {
    double cost = 0.0;
    Vec3 gradient;         ///< downhill: J' W e
    Symmetric information; ///< J' W J
    Symmetric bend;        ///< sum of w e/d u u'
    double bendTrace = 0.0;

    /// The exact second derivatives: J' W J - sum of w e/d (1 - u u').
    Symmetric curvature() const
    {
        return {information.xx + bend.xx - bendTrace,
                information.xy + bend.xy,
                information.xz + bend.xz,
                information.yy + bend.yy - bendTrace,
                information.yz + bend.yz,
                information.zz + bend.zz - bendTrace};
    }
};

struct Summary {
    Symmetric information; ///< Fisher information, without down-weighting
    double chiSquared = 0.0;
    double residual_m = 0.0;   ///< rms
    double meanVariance = 0.0; ///< harmonic mean of the range variances, m^2
};

/// The ranges of a fix laid out for the inner loop, with an optional prior of the height. Dim 2: z stays.
class RangeResiduals {
public:
    RangeResiduals(AnchorRanges ranges, std::optional<TagHeight> height, double huber);

    int size() const { return m_size; }
    /// Whether the cost is twice differentiable, that is without Huber's kinks.
    bool smooth() const { return m_huber <= 0.0; }
    template<int Dim>
    Slope slope(Vec3 at) const;
    template<int Dim>
    Summary summary(Vec3 at) const;

private:
    using Column = std::array<double, kMaxAnchors>;
    Column m_x, m_y, m_z, m_range, m_weight;
    struct Rays;
    void look(Vec3 at, Rays& rays) const;
    double weigh(double e, double w, double& cost) const;

    int m_size = 0;
    std::size_t m_padded = 0; ///< m_size rounded up to pairs
    double m_priorZ = 0.0;
    double m_priorWeight = 0.0;
    double m_huber = 0.0;
};

/// Solves (A + damping diag A) step = right for a positive definite A; false when it is not one.
template<int Dim>
bool solveSymmetric(const Symmetric& a, Vec3 right, double damping, Vec3& step);

/// Inverse of a positive definite matrix; false when it is singular to working accuracy. Dim 2: of the upper
/// left part, the rest is zero.
template<int Dim>
bool invertSymmetric(const Symmetric& a, Symmetric& inverse);

} // namespace agv::estimation
