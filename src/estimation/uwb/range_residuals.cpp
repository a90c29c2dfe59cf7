// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/range_residuals.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

/// At an anchor the direction is undefined; a tag is never this near.
constexpr double kLeastRange_m = 1e-9;
/// Pivot, relative to its diagonal element, below which a matrix counts as singular.
constexpr double kLeastPivot = 1e-12;

} // namespace

RangeResiduals::RangeResiduals(AnchorRanges ranges, std::optional<TagHeight> height, double huber)
    : m_size(static_cast<int>(ranges.size())),
      m_huber(huber)
{
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const AnchorRange& range = ranges[i];
        m_x[i] = range.anchor.x();
        m_y[i] = range.anchor.y();
        m_z[i] = range.anchor.z();
        m_range[i] = range.range_m;
        m_weight[i] = 1.0 / (range.sd_m * range.sd_m);
    }
    m_padded = (ranges.size() + 1) & ~std::size_t{1};
    if (m_padded > ranges.size()) {
        // A pair for the last one; its result is not used.
        m_x[ranges.size()] = m_y[ranges.size()] = m_z[ranges.size()] = 0.0;
        m_range[ranges.size()] = 0.0;
    }
    if (height && height->sd_m > 0.0) {
        m_priorZ = height->z_m;
        m_priorWeight = 1.0 / (height->sd_m * height->sd_m);
    }
}

/// Directions from the anchors and residuals, in columns.
struct RangeResiduals::Rays {
    Column ux, uy, uz, inverse, e;
};

/// On its own because this loop, all square roots and divisions, runs two ranges at a time.
void RangeResiduals::look(Vec3 at, Rays& rays) const
{
    for (std::size_t i = 0; i < m_padded; ++i) {
        const double dx = at.x - m_x[i];
        const double dy = at.y - m_y[i];
        const double dz = at.z - m_z[i];
        const double d2 = dx * dx + dy * dy + dz * dz;
        const double d = std::sqrt(d2 > kLeastRange_m * kLeastRange_m ? d2 : kLeastRange_m * kLeastRange_m);
        const double inverse = 1.0 / d;
        rays.ux[i] = dx * inverse;
        rays.uy[i] = dy * inverse;
        rays.uz[i] = dz * inverse;
        rays.inverse[i] = inverse;
        rays.e[i] = m_range[i] - d;
    }
}

/// Adds the cost of one residual and returns its weight.
double RangeResiduals::weigh(double e, double w, double& cost) const
{
    if (m_huber <= 0.0) {
        cost += 0.5 * w * e * e;
        return w;
    }
    const double t = std::abs(e) * std::sqrt(w);
    if (t <= m_huber) {
        cost += 0.5 * t * t;
        return w;
    }
    cost += m_huber * t - 0.5 * m_huber * m_huber;
    return w * m_huber / t;
}

template<int Dim>
Slope RangeResiduals::slope(Vec3 at) const
{
    Rays rays;
    look(at, rays);
    Slope s;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_size); ++i) {
        const double e = rays.e[i];
        const double w = weigh(e, m_weight[i], s.cost);
        const double ux = rays.ux[i];
        const double uy = rays.uy[i];
        const double wx = w * ux;
        const double wy = w * uy;
        const double bend = e * rays.inverse[i];
        const double bx = bend * wx;
        const double by = bend * wy;
        s.gradient.x += wx * e;
        s.gradient.y += wy * e;
        s.information.xx += wx * ux;
        s.information.xy += wx * uy;
        s.information.yy += wy * uy;
        s.bend.xx += bx * ux;
        s.bend.xy += bx * uy;
        s.bend.yy += by * uy;
        s.bendTrace += bend * w;
        if constexpr (Dim == 3) {
            const double uz = rays.uz[i];
            const double wz = w * uz;
            s.gradient.z += wz * e;
            s.information.xz += wx * uz;
            s.information.yz += wy * uz;
            s.information.zz += wz * uz;
            s.bend.xz += bx * uz;
            s.bend.yz += by * uz;
            s.bend.zz += bend * wz * uz;
        }
    }
    if constexpr (Dim == 3) {
        const double away = at.z - m_priorZ;
        s.cost += 0.5 * m_priorWeight * away * away;
        s.gradient.z -= m_priorWeight * away;
        s.information.zz += m_priorWeight;
    }
    return s;
}

template<int Dim>
Summary RangeResiduals::summary(Vec3 at) const
{
    Rays rays;
    look(at, rays);
    Summary s;
    double squares = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_size); ++i) {
        const double e = rays.e[i];
        const double w = m_weight[i];
        const double wx = w * rays.ux[i];
        const double wy = w * rays.uy[i];
        s.information.xx += wx * rays.ux[i];
        s.information.xy += wx * rays.uy[i];
        s.information.yy += wy * rays.uy[i];
        s.information.xz += wx * rays.uz[i];
        s.information.yz += wy * rays.uz[i];
        s.information.zz += w * rays.uz[i] * rays.uz[i];
        s.chiSquared += w * e * e;
        squares += e * e;
        weights += w;
    }
    s.information.zz += m_priorWeight;
    s.residual_m = std::sqrt(squares / m_size);
    s.meanVariance = m_size / weights;
    return s;
}

template<int Dim>
bool solveSymmetric(const Symmetric& a, Vec3 right, double damping, Vec3& step)
{
    // L D L' with one division per pivot; comparisons are written so that NaN fails.
    const double axx = a.xx * (1.0 + damping);
    const double ayy = a.yy * (1.0 + damping);
    if (!(axx > 0.0))
        return false;
    const double ix = 1.0 / axx;
    const double lyx = a.xy * ix;
    const double dy = ayy - lyx * a.xy;
    if (!(dy > kLeastPivot * ayy))
        return false;
    const double iy = 1.0 / dy;
    const double by = right.y - lyx * right.x;
    if constexpr (Dim == 2) {
        step.y = by * iy;
        step.x = (right.x - a.xy * step.y) * ix;
        step.z = 0.0;
        return true;
    }
    const double azz = a.zz * (1.0 + damping);
    const double lzx = a.xz * ix;
    const double rest = a.yz - lzx * a.xy;
    const double lzy = rest * iy;
    const double dz = azz - lzx * a.xz - lzy * rest;
    if (!(dz > kLeastPivot * azz))
        return false;
    step.z = (right.z - lzx * right.x - lzy * by) / dz;
    step.y = by * iy - lzy * step.z;
    step.x = (right.x - a.xz * step.z - a.xy * step.y) * ix;
    return true;
}

template<int Dim>
bool invertSymmetric(const Symmetric& a, Symmetric& inverse)
{
    const double minor = a.xx * a.yy - a.xy * a.xy;
    if (!(minor > kLeastPivot * a.xx * a.yy))
        return false;
    if constexpr (Dim == 2) {
        inverse = {a.yy / minor, -a.xy / minor, 0.0, a.xx / minor, 0.0, 0.0};
        return true;
    }
    const double cx = a.yy * a.zz - a.yz * a.yz;
    const double cy = a.xz * a.yz - a.xy * a.zz;
    const double cz = a.xy * a.yz - a.xz * a.yy;
    const double determinant = a.xx * cx + a.xy * cy + a.xz * cz;
    if (!(determinant > kLeastPivot * minor * a.zz))
        return false;
    const double s = 1.0 / determinant;
    inverse = {cx * s,   cy * s, cz * s, (a.xx * a.zz - a.xz * a.xz) * s, (a.xy * a.xz - a.xx * a.yz) * s,
               minor * s};
    return true;
}

template Slope RangeResiduals::slope<2>(Vec3) const;
template Slope RangeResiduals::slope<3>(Vec3) const;
template Summary RangeResiduals::summary<2>(Vec3) const;
template Summary RangeResiduals::summary<3>(Vec3) const;
template bool solveSymmetric<2>(const Symmetric&, Vec3, double, Vec3&);
template bool solveSymmetric<3>(const Symmetric&, Vec3, double, Vec3&);
template bool invertSymmetric<2>(const Symmetric&, Symmetric&);
template bool invertSymmetric<3>(const Symmetric&, Symmetric&);

} // namespace agv::estimation
