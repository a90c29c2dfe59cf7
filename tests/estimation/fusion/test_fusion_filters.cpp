// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "estimation/error_metrics.h"
#include "estimation/fusion/position_fusion.h"
#include "estimation/fusion/vehicle_fusion.h"

#include <gtest/gtest.h>

#include <numbers>

namespace agv::estimation {
namespace {

const std::vector<Eigen::Vector3d> kFilterAnchors{{0, 0, 2}, {4, 0, 2}, {4, 3, 2}, {0, 3, 2}};
constexpr double kStep_s = 0.1;

/// A vehicle on a circle, with wheels and a track that are not what the console believes, and a tag off its
/// centre.
class Circle {
public:
    explicit Circle(std::uint64_t seed) : m_random(seed) {}

    void step()
    {
        const double forward = 0.2 * kStep_s;
        const double turn = forward / 0.9;
        m_pose.position = m_pose.position + forward * Point2{std::cos(m_pose.heading + 0.5 * turn),
                                                             std::sin(m_pose.heading + 0.5 * turn)};
        m_pose.heading = wrapAngle(m_pose.heading + turn);
        m_odometry = {forward / 1.04 * (1.0 + 0.02 * m_random.normal()), 0.0,
                      turn / 0.96 * (1.0 + 0.02 * m_random.normal())};
    }

    std::vector<AnchorRange> ranges()
    {
        std::vector<AnchorRange> result;
        const Point2 tag = fromVehicleFrame(m_pose, kTag);
        for (int i = 0; i < 4; ++i) {
            const Eigen::Vector3d& a = kFilterAnchors[static_cast<std::size_t>(i)];
            const double d = (Eigen::Vector3d(tag.x, tag.y, 0.3) - a).norm();
            result.push_back({a, d + 0.05 * m_random.normal(), 0.05, i});
        }
        return result;
    }

    const Pose2& pose() const { return m_pose; }
    const OdometryStep& odometry() const { return m_odometry; }
    static constexpr Point2 kTag{0.15, -0.1};

private:
    SplitMix64 m_random;
    Pose2 m_pose{{2.0, 0.6}, 0.0};
    OdometryStep m_odometry;
};

VehicleFusion circleFilter()
{
    VehicleFusionSettings settings;
    settings.model.height_m = 0.3;
    return VehicleFusion(settings);
}

TEST(VehicleFusion, LearnsTheScalesOfTheOdometryAndKeepsItsHeading)
{
    Circle circle(1);
    VehicleFusion filter = circleFilter();
    filter.start(circle.pose(), {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 3e-3});
    ErrorSample places;
    ErrorSample headings;
    int inside = 0;
    int counted = 0;
    for (int k = 0; k < 1500; ++k) {
        circle.step();
        filter.predict(circle.odometry(), kStep_s);
        filter.update(circle.ranges(), Circle::kTag);
        if (k < 500)
            continue;
        const PoseError error = errorOf(filter.pose(), circle.pose());
        places.add(error.position_m);
        headings.add(degFromRad(error.heading));
        inside +=
            normalisedPositionError2(filter.pose(), filter.covariance(), circle.pose()) < kChiSquared2At95
                ? 1
                : 0;
        ++counted;
    }
    EXPECT_LT(places.mean(), 0.03);
    EXPECT_LT(headings.mean(), 2.0);
    EXPECT_NEAR(filter.scale(), 1.04, 0.01);
    EXPECT_NEAR(filter.turnScale(), 0.96, 0.01);
    EXPECT_GT(inside, counted * 8 / 10);
}

TEST(VehicleFusion, HoldsItsPlaceThroughABlockedAnchorAndSaysWhichOne)
{
    Circle circle(2);
    VehicleFusion filter = circleFilter();
    filter.start(circle.pose(), {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 3e-3});
    ErrorSample places;
    for (int k = 0; k < 900; ++k) {
        circle.step();
        filter.predict(circle.odometry(), kStep_s);
        auto ranges = circle.ranges();
        if (k >= 600)
            ranges[2].range_m += 0.5;
        const MeasurementRecords& records = filter.update(ranges, Circle::kTag);
        if (k < 605)
            continue;
        places.add(distance(filter.pose().position, circle.pose().position));
        EXPECT_TRUE(records[2].rejected) << k;
        EXPECT_GT(records[2].innovation, 0.2);
    }
    EXPECT_LT(places.mean(), 0.06);
    EXPECT_LT(filter.model().probabilitySeen(2), 0.1);
    EXPECT_GT(filter.model().probabilitySeen(0), 0.5);
}

TEST(VehicleFusion, DrivesOnOdometryAndFloorTagsWithoutAnyAnchor)
{
    Circle circle(3);
    VehicleFusion filter = circleFilter();
    filter.start(circle.pose(), {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-3});
    SplitMix64 random(4);
    ErrorSample places;
    const Point2 antenna{-0.1, 0.0};
    for (int k = 0; k < 900; ++k) {
        circle.step();
        filter.predict(circle.odometry(), kStep_s);
        filter.update({});
        if (k % 5 == 0) {
            const Point2 p = fromVehicleFrame(circle.pose(), antenna);
            const MeasurementRecord record = filter.updateFloorTag(
                {p.x + 0.03 * random.normal(), p.y + 0.03 * random.normal()}, antenna, 0.03);
            EXPECT_TRUE(record.fused);
        }
        if (k > 300)
            places.add(distance(filter.pose().position, circle.pose().position));
    }
    EXPECT_LT(places.mean(), 0.03);
}

TEST(VehicleFusion, TakesReportsOfThePastForWhatTheyAre)
{
    ErrorSample blind;
    ErrorSample aware;
    for (const bool compensated : {false, true}) {
        Circle circle(5);
        VehicleFusion filter = circleFilter();
        filter.start(circle.pose(), {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 3e-3});
        std::vector<AnchorRange> older = circle.ranges();
        for (int k = 0; k < 900; ++k) {
            circle.step();
            filter.predict(circle.odometry(), kStep_s);
            filter.update(older, Circle::kTag, compensated ? 2.0 * kStep_s : 0.0);
            if (k % 2 == 1)
                older = circle.ranges();
            if (k > 300)
                (compensated ? aware : blind).add(distance(filter.pose().position, circle.pose().position));
        }
    }
    EXPECT_LT(aware.mean(), 0.9 * blind.mean());
}

TEST(Fusion, IgnoresInputThatIsNotANumber)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    VehicleFusion vehicle = circleFilter();
    EXPECT_TRUE(vehicle.update(Circle(6).ranges()).empty());
    EXPECT_FALSE(vehicle.updateFloorTag({1, 1}).fused);
    vehicle.start(Pose2{{2, 1}, 0.0});
    vehicle.predict({nan, 0.0, 0.0}, 0.1);
    vehicle.predict({0.1, 0.0, 0.0}, nan);
    auto ranges = Circle(6).ranges();
    ranges[0].range_m = nan;
    ranges[1].index = 99;
    const MeasurementRecords& records = vehicle.update(ranges);
    EXPECT_TRUE(records[0].rejected && records[1].rejected);
    EXPECT_TRUE(records[2].fused);
    EXPECT_TRUE(vehicle.updateFloorTag({nan, 1.0}).rejected);
    EXPECT_TRUE(vehicle.state().mean.allFinite() && vehicle.state().p.allFinite());

    PositionFusion position({.model = {.height_m = 0.3, .obstruction = {}}});
    position.start({2, 1});
    position.predict(nan);
    EXPECT_TRUE(position.update(ranges, 0.1)[0].rejected);
    EXPECT_TRUE(position.position().allFinite());
}

TEST(Odometry, TwoWheelsGiveWayAndTurn)
{
    const OdometryStep step = odometryFromWheels(0.1, 0.2, 0.2);
    EXPECT_DOUBLE_EQ(step.forward_m, 0.15);
    EXPECT_DOUBLE_EQ(step.turn, 0.5);
}

} // namespace
} // namespace agv::estimation
