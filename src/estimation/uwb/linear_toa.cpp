// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/linear_toa.h"

#include <Eigen/QR>

namespace agv::estimation {

namespace {

template<int Columns>
using LinearRows = Eigen::Matrix<double, Eigen::Dynamic, Columns, 0, kMaxAnchors, Columns>;
using LinearColumn = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxAnchors, 1>;

} // namespace

UwbFix linearToa2d(AnchorRanges ranges, std::optional<TagHeight> height)
{
    UwbFix fix;
    fix.status = checkRanges(ranges, 3);
    if (!fix.ok())
        return fix;
    const auto n = static_cast<Eigen::Index>(ranges.size());
    LinearRows<3> a(n, 3);
    LinearColumn y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const AnchorRange& range = ranges[static_cast<std::size_t>(i)];
        const double rise = height ? height->z_m - range.anchor.z() : 0.0;
        a.row(i) << -2.0 * range.anchor.x(), -2.0 * range.anchor.y(), 1.0;
        y(i) = range.range_m * range.range_m - rise * rise - range.anchor.head<2>().squaredNorm();
    }
    Eigen::ColPivHouseholderQR<LinearRows<3>> factor(a);
    factor.setThreshold(kRankThreshold);
    if (factor.rank() < 3) {
        fix.status = FixStatus::CollinearAnchors;
        return fix;
    }
    const Eigen::Vector3d solution = factor.solve(y);
    fix.position << solution.head<2>(), height ? height->z_m : 0.0;
    if (height) {
        completeFix(fix, ranges, TagHeight{height->z_m, 0.0});
        return fix;
    }
    AnchorRangeList flat;
    for (AnchorRange range : ranges) {
        range.anchor.z() = 0.0;
        flat.add(range);
    }
    completeFix(fix, {flat.data(), flat.size()}, TagHeight{});
    return fix;
}

LinearToa3d linearToa3d(AnchorRanges ranges)
{
    LinearToa3d result;
    result.fix.status = checkRanges(ranges, 4);
    if (!result.fix.ok())
        return result;
    const auto n = static_cast<Eigen::Index>(ranges.size());
    LinearRows<4> g(n, 4);
    LinearColumn h(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const AnchorRange& range = ranges[static_cast<std::size_t>(i)];
        g.row(i) << -2.0 * range.anchor.transpose(), 1.0;
        h(i) = range.range_m * range.range_m - range.anchor.squaredNorm();
    }
    Eigen::ColPivHouseholderQR<LinearRows<4>> factor(g);
    factor.setThreshold(kRankThreshold);
    if (factor.rank() < 4) {
        result.fix.status = FixStatus::CoplanarAnchors;
        return result;
    }
    result.unknowns = factor.solve(h);
    result.fix.position = result.unknowns.head<3>();
    completeFix(result.fix, ranges);
    return result;
}

} // namespace agv::estimation
