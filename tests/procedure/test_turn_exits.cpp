// SPDX-License-Identifier: GPL-3.0-or-later
// Every way a turn can end leaves the wheels at zero: each cause, in each phase, at each stop.
#include "procedure/turn_harness.h"

#include <gtest/gtest.h>

#include <string>

namespace agv::procedure {
namespace {

using namespace std::chrono_literals;

struct Cause {
    const char* name;
    TurnPhase end;
    TurnActions (*happen)(TurnHarness&);
};

const Cause causes[] = {
    {"abort", TurnPhase::Aborted, [](TurnHarness& h) { return h.turn().abort(h.now(), "Operator"); }},
    {"robot lost", TurnPhase::Failed, [](TurnHarness& h) { return h.turn().onRobotLost(h.now(), "cut"); }},
    {"reader lost", TurnPhase::Failed, [](TurnHarness& h) { return h.turn().onReaderLost(h.now(), "cut"); }},
    {"robot error", TurnPhase::Failed,
     [](TurnHarness& h) { return h.turn().onRobotState(RobotState::Error, h.now()); }},
    {"robot docked", TurnPhase::Failed,
     [](TurnHarness& h) { return h.turn().onRobotState(RobotState::StationDocked, h.now()); }},
    {"robot docking", TurnPhase::Failed,
     [](TurnHarness& h) { return h.turn().onRobotState(RobotState::StationDocking, h.now()); }},
    {"robot undocking", TurnPhase::Failed,
     [](TurnHarness& h) { return h.turn().onRobotState(RobotState::StationUndocking, h.now()); }},
    {"robot demo docking", TurnPhase::Failed,
     [](TurnHarness& h) { return h.turn().onRobotState(RobotState::DemoDocking, h.now()); }},
};

/// The end: interrupt for a measured turn, five zeros, nothing else that moves the robot, ever.
void expectStandstill(const TurnHarness& harness, std::size_t from, TurnKind kind)
{
    int zeros = 0;
    int interrupts = 0;
    Time last{};
    for (std::size_t i = from; i < harness.emitted().size(); ++i) {
        const TurnHarness::Emitted& entry = harness.emitted()[i];
        EXPECT_FALSE(std::holds_alternative<DriveSegments>(entry.action));
        interrupts += std::holds_alternative<InterruptRobot>(entry.action) ? 1 : 0;
        if (const auto* drive = std::get_if<DriveWheels>(&entry.action)) {
            EXPECT_EQ(drive->speeds, WheelSpeeds{});
            if (zeros > 0) {
                EXPECT_EQ(entry.time - last, ZeroBurst::interval);
            }
            last = entry.time;
            ++zeros;
        }
    }
    EXPECT_EQ(zeros, ZeroBurst::repeats);
    EXPECT_EQ(interrupts, kind == TurnKind::Measured ? 1 : 0);
}

class EveryExit : public testing::TestWithParam<TurnKind> {};

TEST_P(EveryExit, LeavesTheWheelsAtZeroFromEveryPhaseOfEveryStop)
{
    TurnParameters parameters;
    parameters.kind = GetParam();
    for (const Cause& cause : causes) {
        for (const TurnPhase phase :
             {TurnPhase::Settling, TurnPhase::Reading, TurnPhase::Turning, TurnPhase::Solving}) {
            for (int stop = 1; stop <= 9; ++stop) {
                const bool reachable =
                    (phase != TurnPhase::Turning || stop > 1) && (phase != TurnPhase::Solving || stop == 9);
                const bool matters = phase != TurnPhase::Solving || std::string(cause.name) != "reader lost";
                if (!reachable || !matters)
                    continue;
                SCOPED_TRACE(std::string(cause.name) + " in phase " + std::to_string(int(phase)) + ", stop " +
                             std::to_string(stop));
                TurnHarness harness(parameters);
                harness.start();
                ASSERT_TRUE(harness.runUntil([&] {
                    const TurnSnapshot snapshot = harness.turn().snapshot(harness.now());
                    return snapshot.phase == phase && snapshot.stop == stop;
                }));
                const std::size_t from = harness.emitted().size();
                harness.perform(cause.happen(harness));
                EXPECT_EQ(harness.turn().phase(), cause.end);
                EXPECT_FALSE(harness.turn().isActive());
                harness.drain();
                expectStandstill(harness, from, GetParam());
                EXPECT_FALSE(harness.turn().deadline().has_value());
                EXPECT_FALSE(harness.turn().snapshot(harness.now()).message.empty());
            }
        }
    }
}

TEST_P(EveryExit, DuringARetakeLeavesTheWheelsAtZeroToo)
{
    TurnParameters parameters;
    parameters.kind = GetParam();
    for (const Cause& cause : causes) {
        for (const TurnPhase phase : {TurnPhase::Settling, TurnPhase::Reading, TurnPhase::Turning}) {
            SCOPED_TRACE(std::string(cause.name) + " in phase " + std::to_string(int(phase)));
            TurnHarness harness(parameters);
            harness.start();
            ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
            harness.perform(harness.turn().retake(5, harness.now()));
            ASSERT_TRUE(harness.runUntilPhase(phase));
            const std::size_t from = harness.emitted().size();
            harness.perform(cause.happen(harness));
            EXPECT_EQ(harness.turn().phase(), cause.end);
            harness.drain();
            expectStandstill(harness, from, GetParam());
        }
    }
}

TEST_P(EveryExit, OfAFinishedTurnLeavesTheWheelsAtZero)
{
    TurnParameters parameters;
    parameters.kind = GetParam();
    TurnHarness harness(parameters);
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Solving));
    harness.drain();
    EXPECT_EQ(harness.turn().phase(), TurnPhase::Finished);
    int zeros = 0;
    for (auto entry = harness.emitted().rbegin(); entry != harness.emitted().rend(); ++entry) {
        const auto* drive = std::get_if<DriveWheels>(&entry->action);
        if (std::holds_alternative<DriveSegments>(entry->action) || (drive && drive->speeds != WheelSpeeds{}))
            break;
        zeros += drive ? 1 : 0;
    }
    EXPECT_GE(zeros, ZeroBurst::repeats);
}

TEST_P(EveryExit, NothingThatComesAfterTheEndMovesTheRobot)
{
    TurnParameters parameters;
    parameters.kind = GetParam();
    TurnHarness harness(parameters);
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
    harness.perform(harness.turn().abort(harness.now(), "Operator"));
    const int motions = harness.motionsStarted();
    for (int i = 0; i < 20; ++i) {
        InitialisationTurn& turn = harness.turn();
        const Time now = harness.now() + i * 1s;
        harness.perform(turn.onTimer(now));
        harness.perform(turn.onTagRead({now, TagUid{1}, 1}));
        harness.perform(turn.onSegmentDone(static_cast<std::uint32_t>(i), now));
        harness.perform(turn.onRobotState(RobotState::Idle, now));
        harness.perform(turn.solved(now));
        harness.perform(turn.start(now));
        harness.perform(turn.retake(1, now));
        harness.perform(turn.onRobotLost(now, "again"));
        harness.perform(turn.onReaderLost(now, "again"));
    }
    EXPECT_EQ(harness.motionsStarted(), motions);
    EXPECT_EQ(harness.turn().phase(), TurnPhase::Aborted);
}

TEST_P(EveryExit, AReaderThatFallsSilentEndsTheTurn)
{
    for (int stop = 1; stop <= 4; ++stop) {
        for (const TurnPhase phase : {TurnPhase::Settling, TurnPhase::Reading, TurnPhase::Turning}) {
            if (phase == TurnPhase::Turning && stop == 1)
                continue;
            SCOPED_TRACE("phase " + std::to_string(int(phase)) + ", stop " + std::to_string(stop));
            TurnParameters parameters;
            parameters.kind = GetParam();
            TurnHarness harness(parameters);
            harness.start();
            ASSERT_TRUE(harness.runUntil([&] {
                const TurnSnapshot snapshot = harness.turn().snapshot(harness.now());
                return snapshot.phase == phase && snapshot.stop == stop;
            }));
            harness.reader.silent = true;
            ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Failed));
            const Time end = harness.now();
            harness.drain();
            std::size_t from = 0;
            while (harness.emitted()[from].time < end || harness.emitted()[from].phase != TurnPhase::Failed)
                ++from;
            expectStandstill(harness, from, GetParam());
            EXPECT_EQ(harness.all<Report>().back().text.substr(0, 24), "No floor tag was read fo");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryExit, testing::Values(TurnKind::Timed, TurnKind::Measured));

TEST(TurnExit, ARobotThatNeverReportsTheEndOfItsSegmentIsStopped)
{
    TurnParameters parameters;
    parameters.kind = TurnKind::Measured;
    TurnHarness harness(parameters);
    harness.robotAnswers = false;
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
    const Time turnBegin = harness.now();
    const std::size_t from = harness.emitted().size();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Failed));
    EXPECT_NEAR(secondsFrom(harness.now() - turnBegin), 3 * 1.125 + 2.0, 1e-6);
    harness.drain();
    expectStandstill(harness, from, TurnKind::Measured);
}

TEST_P(EveryExit, ARobotThatStopsByItselfInTheMiddleOfAStepEndsTheTurn)
{
    TurnParameters parameters;
    parameters.kind = GetParam();
    const bool timed = parameters.kind == TurnKind::Timed;
    TurnHarness harness(parameters);
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
    InitialisationTurn& turn = harness.turn();
    EXPECT_TRUE(turn.onRobotState(RobotState::Idle, harness.now()).empty()) << "a report of before the step";
    turn.onRobotState(timed ? RobotState::DirectDriving : RobotState::SegmentDriving, harness.now());
    const std::size_t from = harness.emitted().size();
    harness.perform(turn.onRobotState(RobotState::Idle, harness.now()));
    EXPECT_EQ(turn.phase(), TurnPhase::Failed);
    harness.drain();
    expectStandstill(harness, from, GetParam());
}

TEST(TurnExit, ASolverThatNeverAnswersEndsTheTurn)
{
    TurnHarness harness;
    harness.solveTime.reset();
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Failed));
    EXPECT_EQ(harness.turn().snapshot(harness.now()).message, "The solver gave no answer");
}

TEST(TurnExit, ALostReaderNoLongerMattersWhileSolving)
{
    TurnHarness harness;
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Solving));
    EXPECT_TRUE(harness.turn().onReaderLost(harness.now(), "cut").empty());
    EXPECT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
}

TEST(TurnExit, AbortingAnIdleTurnStillSendsZero)
{
    TurnHarness harness;
    harness.perform(harness.turn().abort(harness.now(), "Stop all"));
    harness.drain();
    EXPECT_EQ(harness.all<DriveWheels>().size(), std::size_t{ZeroBurst::repeats});
    EXPECT_EQ(harness.turn().phase(), TurnPhase::Idle);
}

} // namespace
} // namespace agv::procedure
