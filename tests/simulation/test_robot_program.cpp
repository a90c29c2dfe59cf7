// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/docking.h"
#include "simulation/plant_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

using namespace agv;
using namespace agv::simulation;

namespace {

constexpr double quarterTurn = std::numbers::pi / 2.0;

DriveSegment turn_deg(double degrees, double speed = 0.1)
{
    const double wheel = degrees > 0 ? speed : -speed;
    return {{-wheel, wheel}, 0.0, radFromDeg(degrees)};
}

DriveSegment straight(double metres, double speed = 0.2) { return {{speed, speed}, metres, 0.0}; }

const DriveSegment standStill{};

bool hasState(const PlantUnderTest& test, RobotState state)
{
    return std::ranges::count(test.all<protocol::StateUpdate>(), protocol::StateUpdate{state}) > 0;
}

/// Error state, wheels standing, and an assert report with the given code.
testing::AssertionResult failedWith(const PlantUnderTest& test, int code)
{
    if (test.state() != RobotState::Error)
        return testing::AssertionFailure() << "state is " << static_cast<int>(test.state());
    const auto asserts = test.all<protocol::AssertReport>();
    if (asserts.empty() || asserts.back().line != code)
        return testing::AssertionFailure() << "no assert report with code " << code;
    return testing::AssertionSuccess();
}

/// A hall with a mixing station (open side south) and a charging dock (open side north).
PlantLayout hallWithStations()
{
    PlantLayout layout = hall();
    layout.stations.push_back({"mixer", StationKind::Mixing, {{1.5, 3.85}, std::numbers::pi}, 0.4, 0.3});
    layout.stations.push_back({"dock", StationKind::Charging, {{1.5, 0.075}, 0.0}, 0.3, 0.15});
    return layout;
}

} // namespace

TEST(Segments, measuredTurnEndsAtItsAngleWhateverTheBattery)
{
    for (const double charge : {0.0, 0.5, 1.0}) {
        PlantSettings settings = idealSettings();
        settings.charge = charge;
        PlantUnderTest test(settings);
        test.send(protocol::AddSegments{7, {turn_deg(45.0), standStill}});
        test.run(3s);
        EXPECT_NEAR(test.heading_deg(), 45.0, 0.3) << charge;
        EXPECT_EQ(test.state(), RobotState::Idle);
        const auto done = test.all<protocol::SegmentDone>();
        ASSERT_EQ(done.size(), 2U);
        EXPECT_EQ(done[0].number, 7U);
        EXPECT_EQ(done[1].number, 8U);
        EXPECT_TRUE(hasState(test, RobotState::SegmentDriving));
    }
}

TEST(Segments, negativeAngleTurnsClockwise)
{
    PlantUnderTest test;
    test.send(protocol::AddSegments{0, {turn_deg(-90.0), standStill}});
    test.run(5s);
    EXPECT_NEAR(test.heading_deg(), -90.0, 0.3);
}

TEST(Segments, areDrivenOneAfterTheOther)
{
    PlantUnderTest test;
    test.send(protocol::AddSegments{1, {straight(0.5), turn_deg(90.0), straight(0.3), standStill}});
    test.run(12s);
    EXPECT_NEAR(test.pose().position.x, 2.0, 0.02);
    EXPECT_NEAR(test.pose().position.y, 2.3, 0.02);
    EXPECT_EQ(test.state(), RobotState::Idle);
    EXPECT_EQ(test.all<protocol::SegmentDone>().size(), 4U);
}

TEST(Segments, reportTheirProgressAsTelemetry)
{
    PlantUnderTest test;
    test.send(protocol::AddSegments{5, {straight(0.5), standStill}});
    test.run(2s);
    const auto progress = test.allTelemetry<protocol::SegmentUpdate>();
    ASSERT_GE(progress.size(), 15U);
    EXPECT_EQ(progress.back().number, 5U);
    EXPECT_NEAR(progress.back().distance_m, 0.38, 0.04);
    EXPECT_GT(progress.back().robotTime_ms, progress.front().robotTime_ms);
}

TEST(Segments, runningOutOfThemWithSpeedIsFatal)
{
    PlantUnderTest test;
    test.send(protocol::AddSegments{1, {straight(0.1)}});
    test.run(3s);
    EXPECT_TRUE(failedWith(test, 3));
    EXPECT_EQ(test.plant.truth(RobotId{1})->wheels, WheelSpeeds{});
}

TEST(Segments, replacingOnesNotStartedIsAllowed)
{
    PlantUnderTest test;
    test.send(protocol::AddSegments{1, {straight(0.3), straight(5.0), standStill}});
    test.run(500ms);
    test.send(protocol::AddSegments{2, {turn_deg(90.0), standStill}});
    test.run(6s);
    EXPECT_NEAR(test.pose().position.x, 1.8, 0.04); // does not stop between segments that both have speed
    EXPECT_NEAR(test.heading_deg(), 90.0, 0.5);
    EXPECT_EQ(test.state(), RobotState::Idle);
}

TEST(Segments, touchingAStartedOneIsFatal)
{
    PlantUnderTest test;
    test.send(protocol::AddSegments{1, {straight(0.3), standStill}});
    test.run(500ms);
    test.send(protocol::AddSegments{1, {straight(0.3), standStill}});
    test.run(100ms);
    EXPECT_TRUE(failedWith(test, 1));
}

TEST(Segments, touchingADoneOneIsFatalUntilAConsoleConnectsAnew)
{
    PlantUnderTest test;
    const protocol::AddSegments command{1, {turn_deg(10.0), standStill}};
    test.send(command);
    test.run(2s);
    test.plant.consoleConnected(RobotId{1});
    test.send(command);
    test.run(2s);
    EXPECT_EQ(test.state(), RobotState::Idle);
    EXPECT_NEAR(test.heading_deg(), 20.0, 0.5);
    test.send(command);
    test.run(100ms);
    EXPECT_TRUE(failedWith(test, 1));
}

TEST(Segments, gapInTheNumbersIsFatal)
{
    PlantUnderTest test;
    test.send(protocol::AddSegments{1, {straight(0.3), standStill}});
    test.run(100ms);
    test.send(protocol::AddSegments{9, {standStill}});
    test.run(100ms);
    EXPECT_TRUE(failedWith(test, 2));
}

TEST(Segments, bumpingWhileDrivingThemIsFatal)
{
    PlantUnderTest test;
    test.send(protocol::AddSegments{1, {straight(5.0), standStill}});
    test.run(20s);
    EXPECT_TRUE(failedWith(test, 4));
}

TEST(RobotProgram, ignoresEverythingButInterruptInItsErrorState)
{
    PlantUnderTest test;
    test.plant.failRobot(RobotId{1});
    test.drive(0.1, 0.1);
    test.run(1s);
    EXPECT_TRUE(failedWith(test, 99));
    EXPECT_EQ(test.pose().position, (Point2{1.5, 2.0}));
    test.send(protocol::Interrupt{});
    test.drive(0.1, 0.1);
    test.run(1s);
    EXPECT_EQ(test.state(), RobotState::DirectDriving);
}

TEST(RobotProgram, interruptEndsEveryManoeuvre)
{
    const std::vector<protocol::RobotCommand> manoeuvres{
        protocol::AddSegments{1, {straight(1.0), standStill}}, protocol::DirectDrive{{0.1, 0.1}},
        protocol::Dock{}, protocol::Undock{}, protocol::DockDemo{}};
    for (const protocol::RobotCommand& manoeuvre : manoeuvres) {
        PlantUnderTest test(idealSettings(), hallWithStations());
        const bool toStation = std::holds_alternative<protocol::Dock>(manoeuvre);
        test.plant.placeRobot(RobotId{1}, {{1.5, toStation ? 3.0 : 1.0}, 0.0});
        test.send(manoeuvre);
        test.run(300ms);
        EXPECT_NE(test.state(), RobotState::Idle) << manoeuvre.index();
        test.send(protocol::Interrupt{});
        test.run(1s);
        EXPECT_EQ(test.state(), RobotState::Idle) << manoeuvre.index();
        EXPECT_EQ(test.plant.truth(RobotId{1})->wheels, WheelSpeeds{}) << manoeuvre.index();
    }
}

TEST(RobotProgram, docksAtAStationAndBacksAwayFromIt)
{
    PlantUnderTest test(idealSettings(), hallWithStations());
    test.plant.placeRobot(RobotId{1}, {{1.2, 3.0}, 0.3});
    test.send(protocol::Dock{});
    test.run(25s);
    EXPECT_EQ(test.state(), RobotState::StationDocked);
    EXPECT_TRUE(isDocked(test.pose(), dockPose(hallWithStations().stations[0], 0.165)));
    EXPECT_NEAR(degFromRad(test.pose().heading), 90.0, 8.0);
    test.send(protocol::Undock{});
    test.run(5s);
    EXPECT_EQ(test.state(), RobotState::Idle);
    EXPECT_LT(test.pose().position.y, 3.35);
}

TEST(RobotProgram, chargesOnItsDockUntilItLeaves)
{
    PlantUnderTest test(idealSettings(), hallWithStations());
    test.plant.setCharge(RobotId{1}, 0.3);
    test.plant.placeRobot(RobotId{1}, {{1.9, 0.9}, quarterTurn});
    test.send(protocol::DockDemo{});
    test.run(30s);
    EXPECT_EQ(test.state(), RobotState::Idle);
    ASSERT_TRUE(test.plant.truth(RobotId{1})->charging);
    test.run(600s);
    EXPECT_GT(test.plant.truth(RobotId{1})->charge, 0.35);
    const BatteryStatus battery = test.allTelemetry<protocol::SensorUpdate>().back().battery;
    EXPECT_EQ(battery.charging, ChargingState::FullCharging);
    EXPECT_TRUE(battery.homeBase);
    EXPECT_GT(battery.current_A, 0.0);
    test.drive(-0.1, -0.1);
    test.run(1s);
    EXPECT_FALSE(test.plant.truth(RobotId{1})->charging);
}

TEST(RobotProgram, givesUpDockingWhenThereIsNoDock)
{
    PlantUnderTest test;
    test.send(protocol::DockDemo{});
    test.run(1s);
    EXPECT_EQ(test.state(), RobotState::Idle);
    ASSERT_FALSE(test.all<protocol::DebugReport>().empty());
    EXPECT_EQ(test.all<protocol::DebugReport>()[0].text, "no dock in sight");
}

TEST(RobotProgram, reportsStateAndBatteryRegularly)
{
    PlantUnderTest test;
    test.run(10s);
    EXPECT_NEAR(static_cast<double>(test.all<protocol::StateUpdate>().size()), 20.0, 1.0);
    const auto sensors = test.allTelemetry<protocol::SensorUpdate>();
    EXPECT_NEAR(static_cast<double>(sensors.size()), 10.0, 1.0);
    EXPECT_EQ(sensors[0].battery.charging, ChargingState::NotCharging);
    EXPECT_LT(sensors[0].battery.current_A, 0.0);
    EXPECT_GT(sensors[0].battery.voltage_V, 12.0);
    EXPECT_NEAR(sensors[0].battery.charge_Ah / sensors[0].battery.capacity_Ah, 5.0 / 6.0, 0.01);
}
