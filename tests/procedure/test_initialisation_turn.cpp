// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/turn_harness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace agv::procedure {
namespace {

using namespace std::chrono_literals;

class AnyTurn : public testing::TestWithParam<std::tuple<TurnKind, Rotation, int>> {
protected:
    static TurnParameters parameters()
    {
        TurnParameters p;
        std::tie(p.kind, p.rotation, p.stopsPerTurn) = GetParam();
        return p;
    }
};

TEST_P(AnyTurn, ReadsEveryStopAndTheClosingOne)
{
    const TurnParameters p = parameters();
    TurnHarness harness(p);
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    const TurnRecord& record = harness.turn().record();
    EXPECT_EQ(record.stops.size(), static_cast<std::size_t>(p.stopsPerTurn) + 1);
    EXPECT_EQ(harness.motionsStarted(), p.stopsPerTurn);
    EXPECT_EQ(record.kind, p.kind);
    EXPECT_EQ(record.rotation, p.rotation);
    EXPECT_EQ(record.turnTime_s.has_value(), p.kind == TurnKind::Timed);
    EXPECT_NEAR(record.nominalStep * p.stopsPerTurn, 2.0 * std::numbers::pi, 1e-12);
    EXPECT_EQ(harness.turn().standingAt(), p.stopsPerTurn);
}

TEST_P(AnyTurn, UsesOnlyReadsOfTheStandingRobot)
{
    TurnHarness harness(parameters());
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    std::size_t moving = 0;
    unsigned stopNumber = 0;
    for (const TurnStop& stop : harness.turn().record().stops) {
        ++stopNumber;
        EXPECT_FALSE(stop.reads.empty());
        for (const TagRead& read : stop.reads)
            EXPECT_EQ(read.uid.value / 16, stopNumber);
        moving += stop.movingReads.size();
    }
    EXPECT_GT(moving, 8U);
}

TEST_P(AnyTurn, AsksForAPreviewFromTheThirdStopOnAndForOneResult)
{
    TurnHarness harness(parameters());
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    const std::vector<SolvePreview> previews = harness.all<SolvePreview>();
    const int stopCount = parameters().stopsPerTurn + 1;
    ASSERT_EQ(previews.size(), static_cast<std::size_t>(stopCount - 3));
    for (std::size_t i = 0; i < previews.size(); ++i)
        EXPECT_EQ(previews[i].stopsDone, static_cast<int>(i) + 3);
    EXPECT_EQ(harness.all<SolveResult>().size(), 1U);
}

TEST_P(AnyTurn, ShowsProgressThatNeverRunsBackwards)
{
    TurnHarness harness(parameters());
    harness.start();
    double progress = 0.0;
    int stop = 1;
    const bool finished = harness.runUntil([&] {
        const TurnSnapshot snapshot = harness.turn().snapshot(harness.now());
        EXPECT_GE(snapshot.progress, progress - 1e-9);
        EXPECT_GE(snapshot.stop, stop);
        EXPECT_GE(snapshot.timeLeft_s, 0.0);
        progress = snapshot.progress;
        stop = snapshot.stop;
        return snapshot.phase == TurnPhase::Finished;
    });
    ASSERT_TRUE(finished);
    EXPECT_EQ(progress, 1.0);
}

INSTANTIATE_TEST_SUITE_P(KindsDirectionsStops, AnyTurn,
                         testing::Combine(testing::Values(TurnKind::Timed, TurnKind::Measured),
                                          testing::Values(Rotation::CounterClockwise, Rotation::Clockwise),
                                          testing::Values(8, 12, 16)));

TEST(InitialisationTurn, DrivesCounterClockwiseWithTheLeftWheelBackwards)
{
    TurnHarness harness;
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
    EXPECT_EQ(harness.all<DriveWheels>().back().speeds, (WheelSpeeds{-0.1, 0.1}));
}

TEST(InitialisationTurn, MeasuredSegmentsCarryTheSignedAngleAndEndWithZero)
{
    TurnParameters p;
    p.kind = TurnKind::Measured;
    p.rotation = Rotation::Clockwise;
    TurnHarness harness(p);
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    std::uint32_t number = 0;
    for (const DriveSegments& drive : harness.all<DriveSegments>()) {
        EXPECT_EQ(drive.firstNumber, number);
        ASSERT_EQ(drive.segments.size(), 2U);
        EXPECT_EQ(drive.segments[0].speeds, (WheelSpeeds{0.1, -0.1}));
        EXPECT_NEAR(drive.segments[0].endAngle, radFromDeg(-45.0), 1e-12);
        EXPECT_EQ(drive.segments[1], DriveSegment{});
        number += 2;
    }
    EXPECT_EQ(harness.turn().nextSegment(), 16U);
}

TEST(InitialisationTurn, MeasuredStepsOfHalfDegreesAreWholeOnTheWireAndSumUpToAWholeTurn)
{
    TurnParameters p;
    p.kind = TurnKind::Measured;
    p.stopsPerTurn = 16;
    TurnHarness harness(p);
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    double sum_deg = 0.0;
    for (const DriveSegments& drive : harness.all<DriveSegments>()) {
        const double step_deg = degFromRad(drive.segments[0].endAngle);
        EXPECT_NEAR(step_deg, std::round(step_deg), 1e-9);
        EXPECT_NEAR(step_deg, 22.5, 0.5 + 1e-9);
        sum_deg += step_deg;
        EXPECT_NEAR(sum_deg, std::round(sum_deg / 22.5) * 22.5, 0.5 + 1e-9);
    }
    EXPECT_NEAR(sum_deg, 360.0, 1e-9);
}

TEST(InitialisationTurn, ATimedStepLastsItsShareOfTheSleeptime)
{
    for (const int stops : {8, 12, 16}) {
        TurnParameters p;
        p.stopsPerTurn = stops;
        TurnHarness harness(p);
        harness.start();
        ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
        const Time turnBegin = harness.now();
        ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Settling));
        const double expected = 1.125 * 8 / stops;
        EXPECT_NEAR(secondsFrom(harness.now() - turnBegin), expected, 1e-6);
    }
}

TEST(InitialisationTurn, TakesTwentySecondsAtMostFromPressToVerdict)
{
    for (std::uint32_t seed = 1; seed <= 25; ++seed) {
        for (const int tags : {4, 5, 6, 7}) {
            TurnHarness harness({}, {tags, 0.05 + 0.15 * (seed % 2), false}, seed);
            const Time press = harness.now();
            harness.start();
            ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
            EXPECT_LE(secondsFrom(harness.now() - press), 20.0) << "seed " << seed << ", " << tags << " tags";
        }
    }
}

TEST(InitialisationTurn, EstimatesItsTotalTimeWithinAQuarter)
{
    TurnHarness harness;
    const Time press = harness.now();
    harness.start();
    const double estimate = harness.turn().snapshot(harness.now()).timeLeft_s;
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    const double actual = secondsFrom(harness.now() - press);
    EXPECT_NEAR(estimate, actual, 0.25 * actual);
}

TEST(InitialisationTurn, AReadFromBeforeTheDwellThatArrivesInItIsNotUsed)
{
    TurnHarness harness({}, {0, 0.0, false});
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Reading));
    const Time arrived = harness.now();
    harness.turn().onTagRead({arrived - 10ms, TagUid{1}, 3});
    harness.turn().onTagRead({arrived + 10ms, TagUid{2}, 3});
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
    const TurnStop& stop = harness.turn().record().stops.at(0);
    ASSERT_EQ(stop.reads.size(), 1U);
    EXPECT_EQ(stop.reads[0].uid, TagUid{2});
    ASSERT_EQ(stop.movingReads.size(), 1U);
    EXPECT_EQ(stop.movingReads[0].uid, TagUid{1});
}

TEST(InitialisationTurn, AReadOfTheDwellThatArrivesLateStillCountsForIt)
{
    TurnHarness harness({}, {0, 0.0, false});
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
    harness.turn().onTagRead({harness.now() - 5ms, TagUid{9}, 3});
    EXPECT_EQ(harness.turn().record().stops.at(0).reads.size(), 1U);
}

TEST(InitialisationTurn, SaysWhichStopHadNoTagAndGoesOn)
{
    TurnHarness harness;
    harness.start();
    harness.reader.tagsInRange = 0;
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
    harness.reader.tagsInRange = 5;
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    ASSERT_EQ(harness.all<Report>().size(), 1U);
    EXPECT_EQ(harness.all<Report>()[0].text, "No floor tag was read at stop 1");
    EXPECT_TRUE(harness.turn().record().stops[0].reads.empty());
}

TEST(InitialisationTurn, WarnsWhenTheConsoleStoppedTheRobotLate)
{
    TurnHarness harness;
    harness.start();
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Turning));
    const TurnActions actions = harness.turn().onTimer(harness.now() + 1125ms + 50ms);
    ASSERT_EQ(actions.size(), 2U);
    EXPECT_EQ(
        std::get<Report>(actions[1]).text,
        "The robot was stopped 50 ms late: this computer was busy, the step is about 2.0 degrees too long");
}

TEST(InitialisationTurn, TheTableHasARowPerStopAndMarksTheDoneOnes)
{
    TurnHarness harness;
    EXPECT_TRUE(harness.turn().snapshot(harness.now()).table.empty());
    harness.start();
    ASSERT_TRUE(harness.runUntil([&] { return harness.turn().record().stops.size() == 2; }));
    const TurnSnapshot snapshot = harness.turn().snapshot(harness.now());
    ASSERT_EQ(snapshot.table.size(), 9U);
    EXPECT_TRUE(snapshot.table[1].done);
    EXPECT_FALSE(snapshot.table[2].done);
    EXPECT_EQ(snapshot.table[8].stop, 9);
}

class Retake : public testing::TestWithParam<TurnKind> {
protected:
    static TurnHarness finished()
    {
        TurnParameters p;
        p.kind = GetParam();
        TurnHarness harness(p);
        harness.start();
        EXPECT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
        harness.drain();
        return harness;
    }
};

TEST_P(Retake, ReplacesTheOneStopAndSolvesAgain)
{
    TurnHarness harness = finished();
    const TurnRecord before = harness.turn().record();
    harness.perform(harness.turn().retake(6, harness.now()));
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    const TurnRecord& after = harness.turn().record();
    ASSERT_EQ(after.stops.size(), before.stops.size());
    for (std::size_t i = 0; i < after.stops.size(); ++i)
        EXPECT_EQ(after.stops[i].reads == before.stops[i].reads, i != 6) << i;
    EXPECT_EQ(harness.all<SolveResult>().size(), 2U);
    EXPECT_EQ(harness.turn().standingAt(), 6);
    EXPECT_EQ(harness.motionsStarted(), 8 + 2);
}

TEST_P(Retake, OfTheStopWhereTheRobotStandsNeedsNoMotion)
{
    TurnHarness harness = finished();
    harness.perform(harness.turn().retake(8, harness.now()));
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    EXPECT_EQ(harness.motionsStarted(), 8);
}

TEST_P(Retake, GoesTheWayThatKeepsTheStopsWhereTheyWere)
{
    TurnHarness harness = finished();
    harness.perform(harness.turn().retake(1, harness.now()));
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    const bool timed = GetParam() == TurnKind::Timed;
    EXPECT_EQ(harness.motionsStarted(), timed ? 8 + 7 : 8 + 1);
    EXPECT_EQ(harness.turn().standingAt(), timed ? 1 : 9);
    harness.perform(harness.turn().retake(2, harness.now()));
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    EXPECT_EQ(harness.motionsStarted(), timed ? 8 + 8 : 8 + 2);
}

TEST_P(Retake, IsIgnoredBeforeTheEndAndForAStopThatDoesNotExist)
{
    TurnParameters p;
    p.kind = GetParam();
    TurnHarness harness(p);
    EXPECT_TRUE(harness.turn().retake(1, harness.now()).empty());
    harness.start();
    EXPECT_TRUE(harness.turn().retake(1, harness.now()).empty());
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Finished));
    EXPECT_TRUE(harness.turn().retake(-1, harness.now()).empty());
    EXPECT_TRUE(harness.turn().retake(9, harness.now()).empty());
}

TEST_P(Retake, KeepsTheOldReadsWhenItIsAborted)
{
    TurnHarness harness = finished();
    const TurnRecord before = harness.turn().record();
    harness.perform(harness.turn().retake(6, harness.now()));
    ASSERT_TRUE(harness.runUntilPhase(TurnPhase::Reading));
    harness.perform(harness.turn().abort(harness.now(), "stop"));
    EXPECT_EQ(harness.turn().record().stops[6].reads, before.stops[6].reads);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Retake, testing::Values(TurnKind::Timed, TurnKind::Measured));

} // namespace
} // namespace agv::procedure
