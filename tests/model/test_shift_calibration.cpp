// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "model/shift_calibration.h"

using namespace agv;
using namespace agv::model;
using Outcome = ShiftCalibration::Outcome;
using State = ShiftCalibration::State;

namespace {

/// Three AGVs whose turns the test plays, in virtual time.
class Plant {
public:
    ShiftCalibration calibration;
    PlantSnapshot snapshot;
    std::vector<int> asked;

    Plant()
    {
        for (int robot : {1, 2, 3})
            snapshot.agvs.emplace_back().id = RobotId{robot};
    }
    TurnSnapshot& turn(int robot) { return snapshot.agvs[static_cast<std::size_t>(robot - 1)].turn; }
    void pass(Duration time = std::chrono::milliseconds(100))
    {
        snapshot.time += time;
        if (const std::optional<int> robot = calibration.update(snapshot))
            asked.push_back(*robot);
    }
    void begin(int robot)
    {
        turn(robot).phase = TurnPhase::Settling;
        turn(robot).result = nullptr;
        pass();
    }
    void finish(int robot, bool valid = true)
    {
        auto result = std::make_shared<TurnEstimate>();
        result->valid = valid;
        turn(robot).result = result;
        turn(robot).phase = TurnPhase::Finished;
        pass();
        pass();
    }
    Outcome outcome(int robot) const
    {
        return calibration.entries().at(static_cast<std::size_t>(robot - 1)).outcome;
    }
};

} // namespace

TEST(ShiftCalibration, TurnsOneAgvAfterTheOther)
{
    Plant plant;
    plant.calibration.start({1, 2, 3}, plant.snapshot.time);
    plant.pass();
    EXPECT_EQ(plant.asked, std::vector<int>{1});
    plant.begin(1);
    EXPECT_EQ(plant.outcome(1), Outcome::Running);
    for (const TurnPhase phase : {TurnPhase::Reading, TurnPhase::Turning, TurnPhase::Solving}) {
        plant.turn(1).phase = phase;
        plant.pass(std::chrono::seconds(7)); // longer than the patience with a start
    }
    EXPECT_EQ(plant.asked, std::vector<int>{1}) << "no two turn at once";
    plant.finish(1);
    EXPECT_EQ(plant.asked, (std::vector<int>{1, 2}));
    plant.begin(2);
    plant.finish(2);
    plant.begin(3);
    EXPECT_FALSE(plant.calibration.foundAll());
    plant.finish(3);
    EXPECT_EQ(plant.asked, (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(plant.calibration.state(), State::Over);
    EXPECT_TRUE(plant.calibration.foundAll());
}

TEST(ShiftCalibration, AnAgvThatIsNotFoundDoesNotKeepTheOthersFromTurning)
{
    Plant plant;
    plant.calibration.start({1, 2}, plant.snapshot.time);
    plant.pass();
    plant.begin(1);
    plant.finish(1, false);
    EXPECT_EQ(plant.outcome(1), Outcome::NotFound);
    plant.begin(2);
    plant.finish(2);
    EXPECT_EQ(plant.outcome(2), Outcome::Found);
    EXPECT_FALSE(plant.calibration.foundAll());
}

TEST(ShiftCalibration, StartsNoOtherTurnAfterOneThatWasAbortedOrFailed)
{
    for (const TurnPhase end : {TurnPhase::Aborted, TurnPhase::Failed, TurnPhase::Idle}) {
        Plant plant;
        plant.calibration.start({1, 2}, plant.snapshot.time);
        plant.pass();
        plant.begin(1);
        plant.turn(1).phase = end;
        for (int i = 0; i < 100; ++i)
            plant.pass();
        EXPECT_EQ(plant.asked, std::vector<int>{1});
        EXPECT_EQ(plant.outcome(1), Outcome::Stopped);
        EXPECT_EQ(plant.outcome(2), Outcome::Waiting);
        EXPECT_EQ(plant.calibration.state(), State::Over);
    }
}

TEST(ShiftCalibration, StartsNoOtherTurnAfterStop)
{
    for (const bool whileTurning : {false, true}) {
        Plant plant;
        plant.calibration.start({1, 2}, plant.snapshot.time);
        plant.pass();
        if (whileTurning)
            plant.begin(1);
        plant.calibration.stop();
        plant.finish(1);
        for (int i = 0; i < 100; ++i)
            plant.pass();
        EXPECT_EQ(plant.asked, std::vector<int>{1});
        EXPECT_FALSE(plant.calibration.isRunning());
    }
}

TEST(ShiftCalibration, GivesUpOnATurnThatDoesNotBegin)
{
    Plant plant;
    plant.calibration.start({1, 2}, plant.snapshot.time);
    plant.pass();
    plant.pass(ShiftCalibration::patience);
    EXPECT_TRUE(plant.calibration.isRunning());
    plant.pass();
    EXPECT_EQ(plant.outcome(1), Outcome::NotStarted);
    EXPECT_EQ(plant.asked, std::vector<int>{1});
}

TEST(ShiftCalibration, TakesNoOldResultForANewOne)
{
    Plant plant;
    auto old = std::make_shared<TurnEstimate>();
    old->valid = true;
    plant.turn(1).result = old;
    plant.turn(1).phase = TurnPhase::Finished;
    plant.calibration.start({1}, plant.snapshot.time);
    plant.pass();
    plant.pass();
    EXPECT_TRUE(plant.calibration.isRunning());
    plant.turn(1).phase = TurnPhase::Reading;
    plant.pass();
    plant.turn(1).phase = TurnPhase::Finished; // with the old result still
    plant.pass();
    EXPECT_EQ(plant.outcome(1), Outcome::Stopped);
}

TEST(ShiftCalibration, IsOverAtOnceWithoutAgvs)
{
    Plant plant;
    plant.calibration.start({}, plant.snapshot.time);
    plant.pass();
    EXPECT_EQ(plant.calibration.state(), State::Over);
    EXPECT_FALSE(plant.calibration.foundAll());
    plant.calibration.start({9}, plant.snapshot.time); // no such AGV
    plant.pass();
    EXPECT_EQ(plant.calibration.entries()[0].outcome, Outcome::NotStarted);
}
