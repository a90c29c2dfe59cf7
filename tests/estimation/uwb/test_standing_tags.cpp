// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "estimation/error_metrics.h"
#include "estimation/fusion/body_tracker.h"
#include "estimation/uwb/bias_calibration.h"
#include "estimation/uwb/consensus_fix.h"
#include "estimation/uwb/static_position.h"
#include "estimation/uwb/uwb_vectors.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace agv::estimation {
namespace {

const std::vector<Eigen::Vector3d> kRoom{{0, 0, 1.3}, {5, 0, 1.7}, {0, 5, 1.7}, {5, 5, 1.3}};

TEST(StaticPosition, GathersReportsAndSeesThroughAnchorsThatAreHiddenForATime)
{
    ErrorSample first;
    ErrorSample last;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SplitMix64 random(seed);
        const Eigen::Vector3d tag(random.uniform(0.5, 4.5), random.uniform(0.5, 4.5), 0.9);
        StaticPosition position({.height_m = 0.9, .obstruction = {}});
        for (int k = 0; k < 40; ++k) {
            auto ranges = exactRanges(kRoom, tag);
            for (double& r : ranges)
                r += 0.05 * random.normal();
            ranges[k < 20 ? 1 : 2] += random.uniform(0.2, 0.9);
            position.add(rangesFrom(kRoom, ranges, 0.05));
            if (k > 0 && k < 39)
                continue;
            const UwbFix fix = position.fix();
            ASSERT_TRUE(fix.ok());
            (k == 0 ? first : last).add((fix.position - tag).norm());
        }
        EXPECT_EQ(position.reports(), 40);
    }
    EXPECT_LT(last.rms(), 0.03);
    EXPECT_GT(first.rms(), 2.0 * last.rms());
}

TEST(StaticPosition, ClaimsTheAccuracyThatItHas)
{
    SplitMix64 random(8);
    int inside = 0;
    for (int k = 0; k < 300; ++k) {
        StaticPosition position({.height_m = 0.3, .obstruction = {}});
        auto ranges = exactRanges(thesisAnchors(), {1.4, 1.1, 0.3});
        for (double& r : ranges)
            r += 0.05 * random.normal();
        position.add(rangesFrom(thesisAnchors(), ranges, 0.05));
        const UwbFix fix = position.fix();
        ASSERT_TRUE(fix.ok());
        const Eigen::Vector2d error = (fix.position - Eigen::Vector3d(1.4, 1.1, 0.3)).head<2>();
        const Eigen::Matrix2d c = fix.covariance.topLeftCorner<2, 2>();
        inside += error.dot(c.inverse() * error) < kChiSquared2At95 ? 1 : 0;
    }
    EXPECT_GT(inside, 270);
}

TEST(StaticPosition, NamesWhatIsMissing)
{
    StaticPosition position;
    EXPECT_EQ(position.fix().status, FixStatus::TooFewRanges);
    const std::vector<Eigen::Vector3d> line{{0, 0, 2}, {1, 1, 2}, {2, 2, 2}};
    position.add(rangesFrom(line, exactRanges(line, {1, 0, 0}), 0.05));
    EXPECT_EQ(position.fix().status, FixStatus::CollinearAnchors);
    position.clear();
    EXPECT_EQ(position.fix().status, FixStatus::TooFewRanges);
}

TEST(ConsensusFix, FindsThePositionThatMostRangesAgreeOn)
{
    SplitMix64 random(9);
    std::vector<Eigen::Vector3d> anchors;
    for (int i = 0; i < 8; ++i)
        anchors.emplace_back(3.5 * std::cos(0.785 * i), 3.0 * std::sin(0.785 * i), 1.0);
    for (int k = 0; k < 50; ++k) {
        const Eigen::Vector3d tag(random.uniform(-2, 2), random.uniform(-2, 2), 0.9);
        auto ranges = exactRanges(anchors, tag);
        for (double& r : ranges)
            r += 0.05 * random.normal();
        ranges[0] += 2.0;
        ranges[3] = std::abs(ranges[3] - 2.0);
        ranges[6] += 3.3;
        const ConsensusFix fix =
            consensusFix(rangesFrom(anchors, ranges, 0.05), {.height = TagHeight{0.9, 0.0}}, {}, 1e-3);
        ASSERT_TRUE(fix.fix.ok());
        EXPECT_LT((fix.fix.position - tag).norm(), 0.2);
        EXPECT_LT(fix.probabilitySeen[0], 0.1);
        EXPECT_GT(fix.probabilitySeen[1], 0.5);
    }
}

TEST(BiasCalibration, LearnsOffsetsPerPairInSpiteOfOutliersAndLeansOnTagAndAnchor)
{
    SplitMix64 random(10);
    BiasCalibration calibration;
    const auto biasOf = [](int tag, int anchor) { return 0.1 + 0.05 * tag + 0.03 * anchor; };
    for (int place = 0; place < 6; ++place)
        for (int tag = 0; tag < 3; ++tag)
            for (int anchor = 0; anchor < 4; ++anchor) {
                if (tag == 2 && anchor == 3)
                    continue; // heard at the last place only
                const double d = random.uniform(1.0, 6.0);
                for (int k = 0; k < 40; ++k)
                    calibration.add(
                        tag, anchor, place,
                        d + biasOf(tag, anchor) + 0.02 * random.normal() + (k % 9 == 0 ? 4.0 : 0.0), d);
            }
    calibration.add(2, 3, 5, 3.0 + biasOf(2, 3), 3.0);
    calibration.add(0, 0, 0, std::nan(""), 3.0);
    const auto solved = calibration.solve();
    ASSERT_TRUE(solved);
    EXPECT_EQ(solved->size(), 12U);
    for (const auto& [pair, bias] : *solved) {
        const double measured = 4.0 + biasOf(pair.first, pair.second);
        EXPECT_NEAR(bias.corrected(measured), 4.0, 0.03) << pair.first << ' ' << pair.second;
        EXPECT_GT(bias.sd_m, 0.0);
    }
    EXPECT_EQ(solved->at({2, 3}).places, 1);
}

TEST(BiasCalibration, SaysThatNothingWasMeasured)
{
    const auto nothing = BiasCalibration().solve();
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().code, ErrorCode::NoSolution);
}

TEST(BodyTracker, KnowsTheHeadingOfAVehicleWithThreeTagsStandingAndDriving)
{
    const std::array<Point2, 3> mounts{Point2{-0.1, -0.2}, Point2{-0.1, 0.2}, Point2{0.3, 0.0}};
    SplitMix64 random(12);
    Pose2 pose{{2.0, 2.0}, 0.6};
    BodyTracker tracker;
    ErrorSample standing;
    ErrorSample driving;
    for (int k = 0; k < 400; ++k) {
        const bool moves = k >= 150;
        if (moves) {
            pose.heading = wrapAngle(pose.heading + 0.02);
            pose.position = pose.position + 0.02 * Point2{std::cos(pose.heading), std::sin(pose.heading)};
        }
        std::array<std::vector<AnchorRange>, 3> ranges;
        std::vector<BodyTagRanges> tags;
        for (std::size_t i = 0; i < 3; ++i) {
            const Point2 p = fromVehicleFrame(pose, mounts[i]);
            auto exact = exactRanges(kRoom, {p.x, p.y, 0.0});
            for (double& r : exact)
                r += 0.05 * random.normal();
            ranges[i] = rangesFrom(kRoom, exact, 0.05);
            tags.push_back({mounts[i], static_cast<int>(i), ranges[i]});
        }
        if (!tracker.started()) {
            ASSERT_TRUE(tracker.start(tags));
        } else {
            tracker.predict(0.1);
        }
        EXPECT_EQ(tracker.update(tags).size(), 12U);
        const PoseError error = errorOf(tracker.pose(), pose);
        if (k > 100)
            (moves ? driving : standing).add(degFromRad(error.heading));
    }
    EXPECT_LT(standing.rms(), 12.0);
    EXPECT_LT(driving.rms(), 8.0);
    EXPECT_EQ(bodyFix({}, 0.0).status, FixStatus::TooFewRanges);
}

} // namespace
} // namespace agv::estimation
