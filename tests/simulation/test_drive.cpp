// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant_fixture.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace agv;
using namespace agv::simulation;

namespace {

/// The seed's timed turn: directDrive, wait for the sleeptime, stop; returns the angle turned, degrees.
double timedTurn_deg(PlantUnderTest& test, Duration sleeptime = 1125ms, double speed = 0.1)
{
    const double before = test.heading_deg();
    test.drive(-speed, speed);
    test.run(sleeptime);
    test.drive(0.0, 0.0);
    test.run(1s);
    return degFromRad(wrapAngle(radFromDeg(test.heading_deg() - before)));
}

PlantUnderTest withCharge(double charge)
{
    PlantSettings settings = idealSettings();
    settings.charge = charge;
    return PlantUnderTest(settings);
}

} // namespace

TEST(Drive, turnsByFortyFiveDegreesInTheSeedsSleeptimeAtNominalBattery)
{
    PlantUnderTest test;
    EXPECT_NEAR(timedTurn_deg(test), 45.0, 0.1);
    EXPECT_NEAR(distance(test.pose().position, {1.5, 2.0}), 0.0, 1e-9);
}

TEST(Drive, turnsClockwiseWithTheSeedsWheelSigns)
{
    PlantUnderTest test;
    EXPECT_NEAR(timedTurn_deg(test, 1125ms, -0.1), -45.0, 0.1);
}

TEST(Drive, turnsLessTheEmptierTheBattery)
{
    PlantUnderTest full = withCharge(1.0);
    PlantUnderTest half = withCharge(0.5);
    PlantUnderTest empty = withCharge(0.0);
    EXPECT_NEAR(timedTurn_deg(full), 45.0 * 1.04, 0.1);
    EXPECT_NEAR(timedTurn_deg(half), 45.0 * 0.92, 0.1);
    EXPECT_NEAR(timedTurn_deg(empty), 45.0 * 0.80, 0.1);
}

TEST(Drive, chargeFallsFasterWhileDriving)
{
    PlantUnderTest standing = withCharge(0.8);
    PlantUnderTest driving = withCharge(0.8);
    driving.drive(-0.5, 0.5);
    standing.run(60s);
    driving.run(60s);
    const double used = 0.8 - standing.plant.truth(RobotId{1})->charge;
    EXPECT_GT(used, 0.0);
    EXPECT_GT(0.8 - driving.plant.truth(RobotId{1})->charge, 2.0 * used);
}

TEST(Drive, wheelsNeedTimeToReachTheirSpeed)
{
    PlantUnderTest test;
    test.drive(0.5, 0.5);
    test.run(100ms);
    EXPECT_NEAR(test.plant.truth(RobotId{1})->wheels.left, 0.1, 1e-3);
    test.run(500ms);
    EXPECT_NEAR(test.plant.truth(RobotId{1})->wheels.left, 0.5, 1e-3);
}

TEST(Drive, keepsTheLastSpeedWhenTheConsoleIsSilent)
{
    PlantUnderTest test;
    test.drive(0.1, 0.1);
    test.run(10s);
    EXPECT_NEAR(test.pose().position.x, 2.5, 0.01);
    EXPECT_EQ(test.state(), RobotState::DirectDriving);
}

TEST(Drive, slippingWheelsTurnLessThanTheirEncodersSay)
{
    PlantUnderTest test;
    test.plant.setSlip(RobotId{1}, 0.2);
    EXPECT_NEAR(timedTurn_deg(test), 36.0, 0.1);
    test.plant.restore();
    EXPECT_NEAR(timedTurn_deg(test), 45.0, 0.1);
}

TEST(Drive, slipNoiseScattersTheStepsByLessThanOneDegree)
{
    PlantSettings settings = idealSettings();
    settings.drive.slipNoise_sqrtM = DriveModel{}.slipNoise_sqrtM;
    PlantUnderTest test(settings);
    double sum = 0.0;
    double squares = 0.0;
    constexpr int turns = 200;
    for (int i = 0; i < turns; ++i) {
        test.plant.setCharge(RobotId{1}, *settings.charge);
        const double error = timedTurn_deg(test) - 45.0;
        sum += error;
        squares += error * error;
    }
    const double sd = std::sqrt(squares / turns - (sum / turns) * (sum / turns));
    EXPECT_GT(sd, 0.15);
    EXPECT_LT(sd, 0.5);
    EXPECT_NEAR(sum / turns, 0.0, 0.1);
}

TEST(Drive, stopsAtTheEdgeOfThePlant)
{
    PlantUnderTest test;
    test.drive(0.5, 0.5);
    test.run(10s);
    EXPECT_NEAR(test.pose().position.x, 3.0 - 0.165, 0.001);
    EXPECT_EQ(test.plant.truth(RobotId{1})->wheels, WheelSpeeds{});
    EXPECT_TRUE(test.plant.takeBump(RobotId{1}));
    EXPECT_FALSE(test.plant.takeBump(RobotId{1}));
    const auto debugs = test.all<protocol::DebugReport>();
    ASSERT_EQ(debugs.size(), 1U);
    EXPECT_EQ(debugs[0].text, "bump");
    test.drive(-0.1, -0.1);
    test.run(2s);
    EXPECT_LT(test.pose().position.x, 2.7);
}

TEST(Drive, stopsAtAnotherRobotAndAtAnObstacle)
{
    PlantLayout layout = hall(2);
    layout.obstacles.push_back({"pillar", {{0.5, 1.9}, {0.6, 1.9}, {0.6, 2.1}, {0.5, 2.1}}});
    PlantUnderTest test(idealSettings(), layout);
    test.plant.placeRobot(RobotId{2}, {{2.3, 2.0}, 0.0});
    test.drive(0.3, 0.3);
    test.run(5s);
    EXPECT_NEAR(test.pose().position.x, 2.3 - 0.33, 0.001);
    test.drive(-0.3, -0.3);
    test.run(10s);
    EXPECT_NEAR(test.pose().position.x, 0.6 + 0.165, 0.001);
}
