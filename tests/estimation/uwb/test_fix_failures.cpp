// SPDX-License-Identifier: GPL-3.0-or-later
// Every way in which ranges can fail to determine a position has a status with a reason, and no fix ever
// holds a number that is not finite.
#include "core/random.h"
#include "estimation/uwb/linear_toa.h"
#include "estimation/uwb/range_fix.h"
#include "estimation/uwb/two_step_toa.h"
#include "estimation/uwb/uwb_vectors.h"

#include <gtest/gtest.h>

namespace agv::estimation {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

bool finite(const UwbFix& fix)
{
    return fix.position.allFinite() && fix.covariance.allFinite() && fix.mirror.allFinite() &&
           std::isfinite(fix.chiSquared) && std::isfinite(fix.residual_m) &&
           std::isfinite(fix.dop.horizontal) && std::isfinite(fix.dop.vertical);
}

std::vector<AnchorRange> around(const std::vector<Eigen::Vector3d>& anchors, const Eigen::Vector3d& tag)
{
    return rangesFrom(anchors, exactRanges(anchors, tag), 0.05);
}

TEST(FixFailures, TooFewRangesAreNamed)
{
    const auto ranges = around({{0, 0, 2}, {4, 0, 2}}, {1, 1, 0.3});
    EXPECT_EQ(fixFromRanges(ranges, {.height = TagHeight{0.3}}).status, FixStatus::TooFewRanges);
    EXPECT_EQ(fixFromRanges({}).status, FixStatus::TooFewRanges);
    EXPECT_EQ(linearToa2d(ranges).status, FixStatus::TooFewRanges);
    EXPECT_EQ(linearToa3d(around({{0, 0, 2}, {4, 0, 2}, {4, 2, 2}}, {1, 1, 1})).fix.status,
              FixStatus::TooFewRanges);
}

TEST(FixFailures, InputThatIsNotANumberIsNamed)
{
    auto ranges = around(thesisAnchors(), {1, 1, 0.3});
    ranges[1].range_m = kNan;
    EXPECT_EQ(fixFromRanges(ranges).status, FixStatus::BadInput);
    EXPECT_EQ(twoStepToa(ranges).fix.status, FixStatus::BadInput);
    ranges = around(thesisAnchors(), {1, 1, 0.3});
    ranges[2].anchor.x() = kNan;
    EXPECT_EQ(fixFromRanges(ranges).status, FixStatus::BadInput);
    ranges = around(thesisAnchors(), {1, 1, 0.3});
    ranges[0].sd_m = 0.0;
    EXPECT_EQ(fixFromRanges(ranges).status, FixStatus::BadInput);
    ranges[0].sd_m = 0.05;
    EXPECT_EQ(fixFromRanges(ranges, {.height = TagHeight{kNan}}).status, FixStatus::BadInput);
}

TEST(FixFailures, AnchorsOnOneLineAreNamed)
{
    const auto ranges = around({{0, 0, 2}, {2, 2, 2}, {4, 4, 2}, {1, 1, 2}}, {1, 2, 0.3});
    EXPECT_EQ(fixFromRanges(ranges, {.height = TagHeight{0.3}}).status, FixStatus::CollinearAnchors);
    EXPECT_EQ(fixFromRanges(ranges).status, FixStatus::CollinearAnchors);
    EXPECT_EQ(linearToa2d(ranges, TagHeight{0.3}).status, FixStatus::CollinearAnchors);
}

TEST(FixFailures, AnchorsInOnePlaneDefeatOnlyTheLinearSolutions)
{
    const std::vector<Eigen::Vector3d> flat{{0, 0, 2}, {4, 0, 2}, {4, 2, 2}, {0, 2, 2}};
    const auto ranges = around(flat, {1, 1, 0.5});
    EXPECT_EQ(linearToa3d(ranges).fix.status, FixStatus::CoplanarAnchors);
    EXPECT_EQ(twoStepToa(ranges).fix.status, FixStatus::CoplanarAnchors);
    const UwbFix below = fixFromRanges(ranges);
    ASSERT_TRUE(below.ok());
    EXPECT_LT((below.position - Eigen::Vector3d(1, 1, 0.5)).norm(), 1e-7);
    const UwbFix either = fixFromRanges(ranges, {.side = TagSide::Either});
    EXPECT_TRUE(either.mirrored);
    EXPECT_NEAR(either.position.z() + either.mirror.z(), 4.0, 1e-7);
}

TEST(FixFailures, ThreeAnchorsAreEnoughInSpaceWithTheTagBelowThem)
{
    const auto ranges = around({{0, 0, 2}, {4, 0, 2.2}, {1, 3, 2.5}}, {1.5, 1, 0.4});
    const UwbFix fix = fixFromRanges(ranges);
    ASSERT_TRUE(fix.ok());
    EXPECT_LT((fix.position - Eigen::Vector3d(1.5, 1, 0.4)).norm(), 1e-7);
}

TEST(FixFailures, ATagInThePlaneOfItsAnchorsHasNoHeight)
{
    const std::vector<Eigen::Vector3d> flat{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}};
    const auto ranges = around(flat, {1, 1, 0});
    const UwbFix fix = fixFromRanges(ranges);
    EXPECT_TRUE(finite(fix));
    EXPECT_TRUE(!fix.ok() || fix.covariance(2, 2) > 1.0) << toText(fix.status);
    EXPECT_TRUE(fixFromRanges(ranges, {.height = TagHeight{0.0}}).ok());
}

TEST(FixFailures, RandomRubbishGivesAStatusAndFiniteNumbers)
{
    SplitMix64 random(77);
    int ok = 0;
    for (int k = 0; k < 20000; ++k) {
        std::vector<AnchorRange> ranges;
        const int n = static_cast<int>(random.uniform(0, 8));
        // Often coarse coordinates: equal anchors, lines and planes are then common.
        const double grid = random.uniform() < 0.5 ? 1.0 : 1e-3;
        for (int i = 0; i < n; ++i)
            ranges.push_back({{grid * std::floor(random.uniform(-4, 4) / grid),
                               grid * std::floor(random.uniform(-2, 2) / grid),
                               grid * std::floor(random.uniform(0, 3) / grid)},
                              random.uniform() < 0.1 ? 0.0 : random.exponential(3.0),
                              0.05,
                              i});
        for (const UwbFix& fix :
             {fixFromRanges(ranges), fixFromRanges(ranges, {.side = TagSide::Either}),
              fixFromRanges(ranges, {.height = TagHeight{0.3}}),
              fixFromRanges(ranges, {.height = TagHeight{0.3, 0.1}}),
              fixFromRanges(ranges, {.height = TagHeight{0.3}, .huber = 1.5}), linearToa2d(ranges),
              linearToa2d(ranges, TagHeight{0.3}), linearToa3d(ranges).fix, twoStepToa(ranges).fix,
              twoStepToa(ranges, {.originShift_m = 0.0}).fix}) {
            ASSERT_TRUE(finite(fix)) << "draw " << k;
            EXPECT_NE(std::string(toText(fix.status)), "unknown");
            ok += fix.ok() ? 1 : 0;
        }
    }
    EXPECT_GT(ok, 50000);
}

TEST(FixFailures, NoiseNearTheAnchorsPlaneNeverGivesNan)
{
    SplitMix64 random(5);
    const auto anchors = thesisAnchors();
    for (int k = 0; k < 5000; ++k) {
        const Eigen::Vector3d tag(random.uniform(0, 4), random.uniform(0, 2), random.uniform(1.8, 2.2));
        auto exact = exactRanges(anchors, tag);
        for (double& r : exact)
            r = std::abs(r + 0.1 * random.normal());
        const auto ranges = rangesFrom(anchors, exact, 0.1);
        const UwbFix fix = fixFromRanges(ranges, {.side = TagSide::Either});
        ASSERT_TRUE(finite(fix));
        EXPECT_NE(fix.status, FixStatus::Diverged);
    }
}

} // namespace
} // namespace agv::estimation
