// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "estimation/uwb/obstruction.h"
#include "estimation/uwb/planar_ekf.h"
#include "estimation/uwb/range_ekf.h"
#include "estimation/uwb/range_particle_filter.h"
#include "estimation/uwb/robust_fix.h"
#include "estimation/uwb/switching_rule.h"
#include "estimation/uwb/track_vectors.h"

#include <gtest/gtest.h>

namespace agv::estimation {
namespace {

const Eigen::Vector3d kTag(1.4, 1.1, 0.3);

std::vector<AnchorRange> noisy(const std::vector<Eigen::Vector3d>& anchors, const Eigen::Vector3d& tag,
                               SplitMix64& random, double sd_m = 0.05)
{
    auto ranges = exactRanges(anchors, tag);
    for (double& r : ranges)
        r += sd_m * random.normal();
    return rangesFrom(anchors, ranges, sd_m);
}

TEST(Obstruction, TheTailOfTheNormalDistributionIsContinuousAndExact)
{
    EXPECT_NEAR(logNormalCdf(0.0), std::log(0.5), 1e-15);
    EXPECT_NEAR(logNormalCdf(-10.0), -53.23128515051247, 1e-10);
    EXPECT_NEAR(logNormalCdf(-40.0), -804.6084420137538, 1e-8);
    EXPECT_NEAR(logNormalCdf(-30.0 - 1e-9), logNormalCdf(-30.0 + 1e-9), 1e-6);
}

TEST(Obstruction, LongRangesAreTakenForHiddenAndShortOnesForNeither)
{
    const ObstructionModel model;
    Obstruction far(model);
    EXPECT_LT(far.update(model, 0.6, 0.01), 0.05);
    Obstruction near(model);
    EXPECT_GT(near.update(model, 0.02, 0.01), 0.8);
    Obstruction wild(model);
    EXPECT_TRUE(std::isfinite(wild.update(model, -50.0, 0.0025)));
    EXPECT_TRUE(std::isfinite(wild.update(model, 1e6, 0.0025)));
}

TEST(RobustFix, IgnoresAHiddenAnchorAndSaysWhichOne)
{
    SplitMix64 random(11);
    const std::vector<Eigen::Vector3d> anchors{
        {0, 0, 1.3}, {5, 0, 1.7}, {0, 5, 1.7}, {5, 5, 1.3}, {2.5, 0, 2}};
    ErrorSample robust;
    ErrorSample plain;
    int named = 0;
    for (int k = 0; k < 500; ++k) {
        auto ranges = noisy(anchors, {2.1, 3.2, 0.9}, random);
        const auto hidden = static_cast<std::size_t>(k % 5);
        ranges[hidden].range_m += 0.6;
        const RobustFix fix = robustFix(ranges, {.height = TagHeight{0.9}});
        ASSERT_TRUE(fix.fix.ok());
        robust.add((fix.fix.position - Eigen::Vector3d(2.1, 3.2, 0.9)).norm());
        plain.add(
            (fixFromRanges(ranges, {.height = TagHeight{0.9}}).position - Eigen::Vector3d(2.1, 3.2, 0.9))
                .norm());
        named += fix.probabilitySeen[hidden] < 0.5 && fix.records[hidden].rejected ? 1 : 0;
    }
    EXPECT_LT(robust.rms(), 0.4 * plain.rms());
    EXPECT_GT(named, 475);
}

TEST(RobustFix, CostsLittleWhenEveryAnchorIsSeen)
{
    SplitMix64 random(12);
    ErrorSample robust;
    ErrorSample plain;
    for (int k = 0; k < 2000; ++k) {
        const auto ranges = noisy(thesisAnchors(), kTag, random);
        robust.add((robustFix(ranges, {.height = TagHeight{0.3}}).fix.position - kTag).norm());
        plain.add((fixFromRanges(ranges, {.height = TagHeight{0.3}}).position - kTag).norm());
    }
    EXPECT_LT(robust.rms(), 1.15 * plain.rms());
}

TEST(RobustFix, NamesRangesThatGiveNoFix)
{
    EXPECT_EQ(robustFix({}).fix.status, FixStatus::TooFewRanges);
    const std::vector<Eigen::Vector3d> line{{0, 0, 2}, {1, 1, 2}, {2, 2, 2}, {3, 3, 2}};
    const RobustFix fix =
        robustFix(rangesFrom(line, exactRanges(line, kTag), 0.05), {.height = TagHeight{0.3}});
    EXPECT_EQ(fix.fix.status, FixStatus::CollinearAnchors);
}

TEST(PlanarEkf, FollowsASlowTag)
{
    SplitMix64 random(13);
    PlanarEkf filter({.height_m = 0.3, .walkSd_m = 0.05});
    ErrorSample errors;
    for (int k = 0; k < 600; ++k) {
        const Eigen::Vector3d tag(0.5 + 0.005 * k, 1.0, 0.3);
        const auto ranges = noisy(thesisAnchors(), tag, random);
        if (!filter.started()) {
            ASSERT_TRUE(filter.start(ranges));
        }
        filter.predict(0.1);
        const MeasurementRecords& records = filter.update(ranges);
        EXPECT_EQ(records.size(), 4U);
        if (k > 50)
            errors.add((filter.position() - tag.head<2>()).norm());
    }
    EXPECT_LT(errors.mean(), 0.08);
}

TEST(RangeEkf, SurvivesMissingAnchorsAndRubbishAndRecordsThem)
{
    SplitMix64 random(14);
    RangeEkf filter({.height_m = 0.3, .obstruction = {}});
    EXPECT_TRUE(filter.update(noisy(thesisAnchors(), kTag, random)).empty());
    ASSERT_TRUE(filter.start(noisy(thesisAnchors(), kTag, random)));
    ErrorSample errors;
    for (int k = 0; k < 300; ++k) {
        filter.predict(0.1);
        filter.predict(-1.0);
        auto ranges = noisy(thesisAnchors(), kTag, random);
        ranges[1].range_m = k % 3 == 0 ? std::numeric_limits<double>::quiet_NaN() : ranges[1].range_m;
        if (k % 5 == 0)
            ranges[2].range_m = 9.8;
        if (k % 7 == 0)
            ranges.resize(2);
        const MeasurementRecords& records = filter.update(ranges);
        ASSERT_EQ(records.size(), ranges.size());
        if (k % 3 == 0) {
            EXPECT_TRUE(records[1].rejected && !records[1].fused);
        } else {
            EXPECT_TRUE(records[0].fused && records[0].variance > 0.0025);
        }
        ASSERT_TRUE(filter.state().allFinite());
        if (k > 30)
            errors.add((filter.state().head<2>() - kTag.head<2>()).norm());
    }
    EXPECT_LT(errors.mean(), 0.06);
    EXPECT_LT(filter.probabilitySeen(2), 1.0);
}

TEST(RangeEkf, ReportsOneperiodOldAreAheadByTheAge)
{
    SplitMix64 random(15);
    RangeEkf filter({.height_m = 0.3, .obstruction = {}});
    ErrorSample late;
    ErrorSample compensated;
    for (int k = 0; k < 400; ++k) {
        const double t = 0.1 * k;
        const Eigen::Vector3d then(0.3 + 0.4 * (t - 0.1), 1.0, 0.3);
        const Eigen::Vector2d now(0.3 + 0.4 * t, 1.0);
        const auto ranges = noisy(thesisAnchors(), then, random, 0.03);
        if (filter.started()) {
            filter.predict(0.1);
        } else {
            ASSERT_TRUE(filter.start(ranges));
        }
        filter.update(ranges);
        if (k < 100)
            continue;
        late.add((filter.state().head<2>() - now).norm());
        compensated.add((filter.positionAfter(0.1) - now).norm());
    }
    EXPECT_LT(compensated.mean(), 0.8 * late.mean());
}

TEST(RangeParticleFilter, RepeatsItselfAndKnowsFloorTags)
{
    const auto run = [](std::uint64_t seed) {
        SplitMix64 random(16);
        RangeParticleFilter filter({.particles = 300, .height_m = 0.3, .seed = seed});
        EXPECT_TRUE(filter.start(noisy(thesisAnchors(), kTag, random)));
        for (int k = 0; k < 50; ++k) {
            filter.predict(0.1);
            filter.update(noisy(thesisAnchors(), kTag, random));
        }
        EXPECT_TRUE(filter.updateFloorTag(kTag.head<2>()).fused);
        EXPECT_FALSE(filter.updateFloorTag({std::nan(""), 0.0}).fused);
        return filter.position();
    };
    EXPECT_EQ(run(1), run(1));
    EXPECT_NE(run(1), run(2));
    EXPECT_LT((run(1) - kTag.head<2>()).norm(), 0.12);
}

TEST(SwitchingRule, ChoosesAsTheThesisSays)
{
    const auto anchors = std::vector<Eigen::Vector3d>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    SwitchingRule rule(anchors);
    EXPECT_FALSE(rule.choose({}, {}).position);
    EXPECT_EQ(rule.choose(Point2{1, 1}, Point2{1.2, 1}).source, SwitchingSource::Uwb);
    const auto both = rule.choose(Point2{4, 1}, Point2{4.2, 1});
    EXPECT_EQ(both.source, SwitchingSource::Both);
    EXPECT_GT(both.position->x, 4.15);
    EXPECT_EQ(rule.choose({}, Point2{4, 1}).source, SwitchingSource::FloorTag);
    EXPECT_EQ(rule.choose(Point2{4, 1}, {}).source, SwitchingSource::Uwb);
    const auto held = rule.choose({}, {});
    EXPECT_EQ(held.source, SwitchingSource::Held);
    EXPECT_EQ(held.position, (Point2{4, 1}));
}

} // namespace
} // namespace agv::estimation
