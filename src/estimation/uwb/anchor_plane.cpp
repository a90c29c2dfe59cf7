// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/anchor_plane.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

/// Width of the anchors across their line, over their length, squared, below which they count as on a line.
constexpr double kLineWidth2 = 1e-6;
/// Thickness of the anchors across their plane, over their width, squared, above which the linear solution
/// determines all three coordinates well enough to start from.
constexpr double kThick2 = 0.04;
constexpr double kLeastOffset_m = 0.05;

struct Cloud {
    Vec3 centre;
    Symmetric scatter; ///< sum of a a', from the centre
    Vec3 moment;       ///< -1/2 sum of a (r^2 - |a|^2)
};

Cloud cloudOf(AnchorRanges ranges)
{
    Cloud c;
    const double share = 1.0 / static_cast<double>(ranges.size());
    for (const AnchorRange& range : ranges) {
        c.centre.x += share * range.anchor.x();
        c.centre.y += share * range.anchor.y();
        c.centre.z += share * range.anchor.z();
    }
    for (const AnchorRange& range : ranges) {
        const double x = range.anchor.x() - c.centre.x;
        const double y = range.anchor.y() - c.centre.y;
        const double z = range.anchor.z() - c.centre.z;
        c.scatter.xx += x * x;
        c.scatter.xy += x * y;
        c.scatter.xz += x * z;
        c.scatter.yy += y * y;
        c.scatter.yz += y * z;
        c.scatter.zz += z * z;
        const double k = -0.5 * (range.range_m * range.range_m - x * x - y * y - z * z);
        c.moment.x += k * x;
        c.moment.y += k * y;
        c.moment.z += k * z;
    }
    return c;
}

double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Any direction across n.
Vec3 across(Vec3 n)
{
    const Vec3 v = std::abs(n.x) < 0.6 ? Vec3{0.0, n.z, -n.y} : Vec3{-n.z, 0.0, n.x};
    const double s = 1.0 / std::sqrt(dot(v, v));
    return {s * v.x, s * v.y, s * v.z};
}

Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

double quadratic(const Symmetric& s, Vec3 a, Vec3 b)
{
    return a.x * (s.xx * b.x + s.xy * b.y + s.xz * b.z) + a.y * (s.xy * b.x + s.yy * b.y + s.yz * b.z) +
           a.z * (s.xz * b.x + s.yz * b.y + s.zz * b.z);
}

/// Mean over the ranges of r^2 - |p - a|^2.
double leftOver(AnchorRanges ranges, Vec3 p)
{
    double sum = 0.0;
    for (const AnchorRange& range : ranges) {
        const Vec3 d{p.x - range.anchor.x(), p.y - range.anchor.y(), p.z - range.anchor.z()};
        sum += range.range_m * range.range_m - dot(d, d);
    }
    return sum / static_cast<double>(ranges.size());
}

/// The column of the adjugate of S with the largest diagonal: the direction of least scatter when it is
/// much smaller than the others.
struct Adjugate {
    Vec3 normal;
    double trace = 0.0;
};

Adjugate adjugateOf(const Symmetric& s)
{
    const double xx = s.yy * s.zz - s.yz * s.yz;
    const double yy = s.xx * s.zz - s.xz * s.xz;
    const double zz = s.xx * s.yy - s.xy * s.xy;
    const double xy = s.xz * s.yz - s.xy * s.zz;
    const double xz = s.xy * s.yz - s.xz * s.yy;
    const double yz = s.xy * s.xz - s.xx * s.yz;
    Vec3 n{xz, yz, zz};
    if (xx > yy && xx > zz)
        n = {xx, xy, xz};
    else if (yy > zz)
        n = {xy, yy, yz};
    return {n, xx + yy + zz};
}

} // namespace

bool planarStart(AnchorRanges ranges, double height_m, Vec3& start)
{
    double cx = 0.0;
    double cy = 0.0;
    const double share = 1.0 / static_cast<double>(ranges.size());
    for (const AnchorRange& range : ranges) {
        cx += share * range.anchor.x();
        cy += share * range.anchor.y();
    }
    Symmetric s;
    Vec3 moment;
    for (const AnchorRange& range : ranges) {
        const double x = range.anchor.x() - cx;
        const double y = range.anchor.y() - cy;
        const double z = height_m - range.anchor.z();
        s.xx += x * x;
        s.xy += x * y;
        s.yy += y * y;
        const double k = -0.5 * (range.range_m * range.range_m - z * z - x * x - y * y);
        moment.x += k * x;
        moment.y += k * y;
    }
    const double trace = s.xx + s.yy;
    const double determinant = s.xx * s.yy - s.xy * s.xy;
    if (!(determinant > kLineWidth2 * trace * trace))
        return false;
    start = {cx + (s.yy * moment.x - s.xy * moment.y) / determinant,
             cy + (s.xx * moment.y - s.xy * moment.x) / determinant, height_m};
    return true;
}

bool spatialStarts(AnchorRanges ranges, SpatialStarts& starts)
{
    const Cloud cloud = cloudOf(ranges);
    const Symmetric& s = cloud.scatter;
    const double trace = s.xx + s.yy + s.zz;
    const Adjugate adjugate = adjugateOf(s);
    if (!(adjugate.trace > kLineWidth2 * trace * trace))
        return false;
    const double length = std::sqrt(dot(adjugate.normal, adjugate.normal));
    Vec3 n{adjugate.normal.x / length, adjugate.normal.y / length, adjugate.normal.z / length};
    const double thickness = quadratic(s, n, n);
    if (thickness > kThick2 * adjugate.trace / trace) {
        Vec3 p;
        if (solveSymmetric<3>(s, cloud.moment, 0.0, p)) {
            starts.lower = {cloud.centre.x + p.x, cloud.centre.y + p.y, cloud.centre.z + p.z};
            starts.upper = starts.lower;
            return true;
        }
    }
    if (n.z < 0.0)
        n = {-n.x, -n.y, -n.z};
    const Vec3 u = across(n);
    const Vec3 v = cross(n, u);
    const double uu = quadratic(s, u, u);
    const double uv = quadratic(s, u, v);
    const double vv = quadratic(s, v, v);
    const double mu = dot(u, cloud.moment);
    const double mv = dot(v, cloud.moment);
    const double determinant = uu * vv - uv * uv;
    const double pu = (vv * mu - uv * mv) / determinant;
    const double pv = (uu * mv - uv * mu) / determinant;
    const Vec3 foot{cloud.centre.x + pu * u.x + pv * v.x, cloud.centre.y + pu * u.y + pv * v.y,
                    cloud.centre.z + pu * u.z + pv * v.z};
    const double offset = std::sqrt(std::max(leftOver(ranges, foot), kLeastOffset_m * kLeastOffset_m));
    starts.lower = {foot.x - offset * n.x, foot.y - offset * n.y, foot.z - offset * n.z};
    starts.upper = {foot.x + offset * n.x, foot.y + offset * n.y, foot.z + offset * n.z};
    return true;
}

} // namespace agv::estimation
