// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "estimation/uwb/aoa.h"
#include "estimation/uwb/floor_fix.h"
#include "estimation/uwb/linear_toa.h"
#include "estimation/uwb/tdoa.h"
#include "estimation/uwb/uwb_vectors.h"

#include <gtest/gtest.h>

#include <numbers>

namespace agv::estimation {
namespace {

std::vector<RangeDifference> differencesAt(const std::vector<Eigen::Vector3d>& anchors,
                                           const Eigen::Vector3d& tag)
{
    std::vector<RangeDifference> result;
    for (const auto& anchor : anchors)
        result.push_back({anchor, (tag - anchor).norm() - (tag - anchors[0]).norm(), 0.05});
    return result;
}

TEST(LinearToa, FindsExactPlanePositionsWithAndWithoutHeights)
{
    const Eigen::Vector3d tag(1.3, 0.7, 0.3);
    const UwbFix reduced =
        linearToa2d(rangesFrom(thesisAnchors(), exactRanges(thesisAnchors(), tag), 0.05), TagHeight{0.3});
    ASSERT_TRUE(reduced.ok());
    EXPECT_LT((reduced.position - tag).norm(), 1e-9);
    const std::vector<Eigen::Vector3d> floor{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}};
    const UwbFix plane = linearToa2d(rangesFrom(floor, exactRanges(floor, {2, 3, 0}), 0.05));
    ASSERT_TRUE(plane.ok());
    EXPECT_LT((plane.position - Eigen::Vector3d(2, 3, 0)).norm(), 1e-9);
    EXPECT_GT(plane.dop.horizontal, 0.5);
}

TEST(Tdoa, FindsTheTagFromThreeOrMoreAnchorsAnywhereInTheField)
{
    SplitMix64 random(3);
    const std::vector<std::vector<Eigen::Vector3d>> rooms{{{0, 0, 0}, {5, 0, 0}, {0, 4, 0}},
                                                          {{0, 0, 2}, {5, 0, 2.2}, {5, 4, 2}, {0, 4, 1.8}}};
    for (const auto& anchors : rooms)
        for (int k = 0; k < 500; ++k) {
            const double height = anchors.size() == 3 ? 0.0 : 0.3;
            const Eigen::Vector3d tag(random.uniform(0.5, 4.5), random.uniform(0.5, 3.5), height);
            const UwbFix fix = tdoaFix(differencesAt(anchors, tag), height);
            ASSERT_TRUE(fix.ok()) << toText(fix.status);
            const double error =
                std::min((fix.position - tag).norm(), fix.mirrored ? (fix.mirror - tag).norm() : 1e9);
            EXPECT_LT(error, 1e-6) << tag.transpose();
        }
}

TEST(Tdoa, NamesLinesOfAnchorsAndContradictions)
{
    EXPECT_EQ(tdoaFix(differencesAt({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, {1, 0, 0})).status,
              FixStatus::CollinearAnchors);
    EXPECT_EQ(tdoaFix(differencesAt({{0, 0, 0}, {1, 1, 0}}, {1, 0, 0})).status, FixStatus::TooFewRanges);
    auto wrong = differencesAt({{0, 0, 0}, {5, 0, 0}, {0, 4, 0}}, {1, 1, 0});
    wrong[1].difference_m = 40.0;
    wrong[2].difference_m = -40.0;
    const UwbFix fix = tdoaFix(wrong);
    EXPECT_TRUE(fix.position.allFinite());
    EXPECT_TRUE(fix.status == FixStatus::NoIntersection || fix.residual_m > 1.0) << toText(fix.status);
}

TEST(Aoa, IntersectsBearings)
{
    const Eigen::Vector2d tag(1.2, 2.5);
    std::vector<ArrivalAngle> angles;
    for (const Eigen::Vector2d& anchor :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 0), Eigen::Vector2d(4, 5)}) {
        const Eigen::Vector2d d = anchor - tag;
        angles.push_back({anchor, std::atan2(d.y(), d.x()), 0.02});
    }
    for (const std::size_t n : {2U, 3U}) {
        const UwbFix fix = aoaFix(std::span(angles).first(n));
        ASSERT_TRUE(fix.ok());
        EXPECT_LT((fix.position.head<2>() - tag).norm(), 1e-9);
        EXPECT_GT(fix.horizontalSd_m(), 0.0);
    }
}

TEST(Aoa, NamesParallelBearingsAndMeetingPointsBehindAnAnchor)
{
    EXPECT_EQ(aoaFix(std::vector<ArrivalAngle>{{{0, 0}, 0.5}, {{1, 0}, 0.5}}).status,
              FixStatus::ParallelBearings);
    EXPECT_EQ(aoaFix(std::vector<ArrivalAngle>{{{0, 0}, 0.25 * std::numbers::pi},
                                               {{1, 0}, 0.75 * std::numbers::pi}})
                  .status,
              FixStatus::NoIntersection);
    EXPECT_EQ(aoaFix(std::vector<ArrivalAngle>{{{0, 0}, 0.5}}).status, FixStatus::TooFewRanges);
}

TEST(FloorFix, AveragesTheTagsRead)
{
    EXPECT_FALSE(meanOfTags({}));
    const std::vector<Point2> tags{{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}};
    const auto mean = meanOfTags(tags);
    ASSERT_TRUE(mean);
    EXPECT_NEAR(mean->x, 0.05, 1e-12);
    EXPECT_NEAR(mean->y, 0.05, 1e-12);
}

TEST(Fingerprint, LooksUpThePlaceWhoseReadingsAreNearest)
{
    FingerprintTable table(-1.0);
    const std::vector<Heard> a{{1, 7}, {2, 3}};
    const std::vector<Heard> b{{2, 6}, {3, 5}};
    table.add({0, 0}, a);
    table.add({1, 0}, b);
    EXPECT_FALSE(table.nearest({}));
    const std::vector<Heard> exact{{2, 3}, {1, 7}};
    EXPECT_EQ(table.nearest(exact)->place, (Point2{0, 0}));
    EXPECT_EQ(table.nearest(exact)->distance, 0.0);
    const std::vector<Heard> like{{2, 5}, {3, 5}, {9, 0}};
    EXPECT_EQ(table.nearest(like)->place, (Point2{1, 0}));
    const auto between = table.nearest(like, 2);
    EXPECT_GT(between->place.x, 0.5);
    EXPECT_LT(between->place.x, 1.0);
}

} // namespace
} // namespace agv::estimation
