// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "estimation/error_metrics.h"
#include "estimation/uwb/locator.h"
#include "estimation/uwb/uwb_vectors.h"

#include <gtest/gtest.h>

#include <set>

namespace agv::estimation {
namespace {

TEST(Methods, HaveNamesOfTheirOwnTitlesAndSources)
{
    std::set<std::string_view> names;
    for (const MethodInfo& method : allMethods()) {
        EXPECT_TRUE(names.insert(method.name).second) << method.name;
        EXPECT_FALSE(method.title.empty());
        EXPECT_FALSE(method.source.empty());
        EXPECT_EQ(findMethod(method.name), &method);
    }
    EXPECT_EQ(allMethods().front().name, "ekf-los");
    EXPECT_EQ(findMethod("no such thing"), nullptr);
}

TEST(Methods, UnknownAndSpecialOnesAreRefusedWithTheReason)
{
    const auto unknown = makeLocator("guess", {});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::NotFound);
    EXPECT_NE(unknown.error().detail.find("ekf-los"), std::string::npos);
    const auto special = makeLocator("aoa", {});
    ASSERT_FALSE(special);
    EXPECT_EQ(special.error().code, ErrorCode::BadInput);
}

/// A tag that stands in the room of the thesis, 5 cm noise; floor tags and wheels that stand still, too.
TEST(Methods, EveryOneThatRunsOnRangesFindsAStandingTag)
{
    const Eigen::Vector3d tag(1.6, 1.2, 0.3);
    const LocatorSettings settings{
        .anchors = thesisAnchors(), .height_m = 0.3, .startPose = Pose2{{1.5, 1.1}, 0.0}};
    for (const MethodInfo& method : allMethods()) {
        auto made = makeLocator(method.name, settings);
        if (method.input == MethodInput::Special) {
            EXPECT_FALSE(made);
            continue;
        }
        ASSERT_TRUE(made) << method.name;
        SplitMix64 random(3);
        ErrorSample errors;
        for (int k = 0; k < 60; ++k) {
            const double t = 0.1 * k;
            (*made)->odometry(t, {}, 0.1);
            if (method.input == MethodInput::Fusion && k % 2 == 0)
                (*made)->floorTag(t, {tag.x() + 0.03 * random.normal(), tag.y() + 0.03 * random.normal()});
            auto ranges = exactRanges(thesisAnchors(), tag);
            for (double& r : ranges)
                r += 0.05 * random.normal();
            const Located located = (*made)->locate(t, rangesFrom(thesisAnchors(), ranges, 0.05));
            EXPECT_TRUE(located.position.allFinite() && located.covariance.allFinite()) << method.name;
            if (located.ok() && k >= 10)
                errors.add((located.position - tag).head<2>().norm());
        }
        EXPECT_GE(errors.size(), 20U) << method.name;
        EXPECT_LT(errors.mean(), method.inSpace ? 0.25 : 0.15) << method.name;
    }
}

TEST(Methods, ReportsThatGiveNoPositionHaveAReasonAndRubbishDoesNoHarm)
{
    for (const MethodInfo& method : allMethods()) {
        auto made = makeLocator(method.name, {.anchors = thesisAnchors(), .height_m = 0.3});
        if (!made)
            continue;
        const Located nothing = (*made)->locate(0.0, {});
        EXPECT_FALSE(nothing.ok()) << method.name;
        auto ranges = rangesFrom(thesisAnchors(), exactRanges(thesisAnchors(), {1, 1, 0.3}), 0.05);
        ranges[1].range_m = std::nan("");
        ranges[2].index = 77;
        for (int k = 0; k < 5; ++k)
            EXPECT_TRUE((*made)->locate(0.1 * k, ranges).position.allFinite()) << method.name;
        (*made)->locate(-5.0, ranges);
    }
}

TEST(Methods, TrackersStartAnewAfterALongSilence)
{
    for (const std::string_view name : {"ekf-los", "ekf", "ekf-robust", "ekf-manual", "particle"}) {
        auto made = makeLocator(name, {.anchors = thesisAnchors(), .height_m = 0.3});
        ASSERT_TRUE(made);
        const auto at = [](double x, double y) {
            return rangesFrom(thesisAnchors(), exactRanges(thesisAnchors(), {x, y, 0.3}), 0.05);
        };
        for (int k = 0; k < 20; ++k)
            (*made)->locate(0.1 * k, at(0.5, 0.5));
        const auto few = at(2.5, 1.5);
        EXPECT_FALSE((*made)->locate(1000.0, AnchorRanges(few).first(2)).ok())
            << name << ": two ranges tell nothing";
        const Located located = (*made)->locate(1000.1, at(2.5, 1.5));
        ASSERT_TRUE(located.ok()) << name;
        EXPECT_LT((located.position.head<2>() - Eigen::Vector2d(2.5, 1.5)).norm(), 0.15) << name;
    }
}

} // namespace
} // namespace agv::estimation
