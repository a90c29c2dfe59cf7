// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/error_metrics.h"
#include "estimation/turn_scenarios.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numbers>
#include <thread>

namespace agv::estimation::testing {
namespace {

SimulatedTurn ordinaryTurn(int index = 0)
{
    return studyTurn(studyScenario("A5_step10_jit1_noise_miss10"), index);
}
TurnContext largeField() { return contextOf(studyScenario("A0_clean")); }

bool has(const TurnEstimate& estimate, TurnFlag flag) { return std::ranges::count(estimate.flags, flag) > 0; }

double sd_m(const TurnEstimate& e) { return std::sqrt(e.covariance[0] + e.covariance[4]); }

TurnEstimate solveWith(SolveMethod method, const TurnRecord& record, const TurnContext& context,
                       std::uint64_t seed = 1)
{
    SolveOptions options;
    options.method = method;
    options.seed = seed;
    return solveTurn(record, context, options);
}

class EachMethod : public ::testing::TestWithParam<SolveMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, EachMethod, ::testing::Values(SolveMethod::Auto, SolveMethod::Fast),
                         [](const auto& method) { return std::string(toText(method.param)); });

TEST_P(EachMethod, GivesTheSameAnswerBitForBit)
{
    const TurnRecord record = ordinaryTurn().record;
    const TurnEstimate first = solveWith(GetParam(), record, largeField(), 5);
    const TurnEstimate second = solveWith(GetParam(), record, largeField(), 5);
    EXPECT_EQ(first.startPose, second.startPose);
    EXPECT_EQ(first.covariance, second.covariance);
    EXPECT_EQ(first.step, second.step);
    EXPECT_EQ(first.logEvidence, second.logEvidence);
}

TEST_P(EachMethod, FindsClockwiseTurnsWithoutBeingTold)
{
    for (int i = 0; i < 6; ++i) {
        TurnScenario scenario = studyScenario("A7_all");
        scenario.direction = -1;
        SplitMix64 random(4000u + static_cast<std::uint64_t>(i));
        const SimulatedTurn turn = simulateTurn(scenario, random);
        const TurnEstimate e = solveWith(GetParam(), turn.record, largeField());
        ASSERT_TRUE(e.valid);
        EXPECT_EQ(e.rotation, Rotation::Clockwise);
        EXPECT_GT(e.rotationLogOdds, 5.0);
        EXPECT_LT(errorOf(e.startPose, turn.truth.startPose).position_m, 0.012);
        EXPECT_NEAR(wrapAngle(e.pose.heading - (turn.truth.lastBearing - std::numbers::pi)), 0.0,
                    radFromDeg(12.0));
    }
}

TEST_P(EachMethod, FlagsATurnAgainstTheCommandedDirection)
{
    SimulatedTurn turn = ordinaryTurn();
    turn.record.rotation = Rotation::CounterClockwise;
    EXPECT_FALSE(has(solveWith(GetParam(), turn.record, largeField()), TurnFlag::WrongRotation));
    turn.record.rotation = Rotation::Clockwise;
    const TurnEstimate wrong = solveWith(GetParam(), turn.record, largeField());
    EXPECT_EQ(wrong.rotation, Rotation::CounterClockwise);
    EXPECT_TRUE(has(wrong, TurnFlag::WrongRotation));
}

/// Rotates and shifts the plant around the robot.
TurnContext moved(TurnContext context, double angle, Point2 shift)
{
    for (FloorTag& tag : context.tags)
        tag.position = fromVehicleFrame({shift, angle}, tag.position);
    return context;
}

TEST_P(EachMethod, FollowsARotatedAndShiftedField)
{
    const SimulatedTurn turn = ordinaryTurn(3);
    const TurnEstimate here = solveWith(GetParam(), turn.record, largeField());
    for (const double angle : {0.7, -2.5}) {
        const Point2 shift{12.0, -7.0};
        const TurnEstimate there = solveWith(GetParam(), turn.record, moved(largeField(), angle, shift));
        const Pose2 expected{fromVehicleFrame({shift, angle}, here.startPose.position),
                             wrapAngle(here.startPose.heading + angle)};
        const PoseError error = errorOf(there.startPose, expected);
        EXPECT_LT(error.position_m, 0.5 * sd_m(here));
        EXPECT_LT(std::abs(error.heading), 0.5 * std::sqrt(here.covariance[8]));
        EXPECT_NEAR(there.step, here.step, here.stepSd);
    }
}

TEST_P(EachMethod, HardlyChangesWhenEveryReadArrivesTwice)
{
    SimulatedTurn turn = ordinaryTurn(4);
    const TurnEstimate once = solveWith(GetParam(), turn.record, largeField());
    for (TurnStop& stop : turn.record.stops) {
        const auto reads = stop.reads;
        stop.reads.insert(stop.reads.end(), reads.begin(), reads.end());
    }
    const TurnEstimate twice = solveWith(GetParam(), turn.record, largeField());
    EXPECT_LT(errorOf(twice.startPose, once.startPose).position_m, sd_m(once));
    EXPECT_LT(sd_m(twice), 1.2 * sd_m(once));
}

TEST_P(EachMethod, TurnsTheHeadingWithTheMountingOfTheAntenna)
{
    const SimulatedTurn turn = ordinaryTurn(2);
    TurnContext context = largeField();
    const double back = solveWith(GetParam(), turn.record, context).startPose.heading;
    context.antenna = {0.0, 0.1}; // on the left
    const double left = solveWith(GetParam(), turn.record, context).startPose.heading;
    EXPECT_NEAR(wrapAngle(left - back - std::numbers::pi / 2), 0.0, 1e-9);
}

TEST_P(EachMethod, SuggestsTheTurnTimeOfATimedTurnOnly)
{
    SimulatedTurn turn = ordinaryTurn();
    turn.record.turnTime_s = 1.125;
    TurnEstimate e = solveWith(GetParam(), turn.record, largeField());
    ASSERT_TRUE(e.suggestedTurnTime_s);
    EXPECT_NEAR(*e.suggestedTurnTime_s, 1.125 * radFromDeg(45.0) / std::abs(turn.truth.step), 0.03);
    EXPECT_GT(e.suggestedTurnTimeSd_s, 0.0);
    turn.record.kind = TurnKind::Measured;
    EXPECT_FALSE(solveWith(GetParam(), turn.record, largeField()).suggestedTurnTime_s);
}

TEST_P(EachMethod, ReportsUnknownAndMisplacedTagsAndIsNotMisledByThem)
{
    SimulatedTurn turn = ordinaryTurn(6);
    const Point2 truth = turn.truth.startPose.position;
    turn.record.stops[1].reads.push_back({Time{}, TagUid{0xE004}, 5});
    const TagUid farTag = truth.x > 0.5 ? TagUid{1} : TagUid{121}; // in a corner of the field
    turn.record.stops[2].reads.push_back({Time{}, farTag, 5});
    const TurnEstimate e = solveWith(GetParam(), turn.record, largeField());
    EXPECT_EQ(e.stops[1].unknown, std::vector{TagUid{0xE004}});
    EXPECT_EQ(std::ranges::count(e.stops[2].misplaced, farTag), 1);
    EXPECT_LT(errorOf(e.startPose, turn.truth.startPose).position_m, 0.010);
}

TEST_P(EachMethod, ToleratesAStopWithoutReads)
{
    SimulatedTurn turn = ordinaryTurn(7);
    turn.record.stops[3].reads.clear();
    const TurnEstimate e = solveWith(GetParam(), turn.record, largeField());
    ASSERT_TRUE(e.valid);
    EXPECT_LT(errorOf(e.startPose, turn.truth.startPose).position_m, 0.010);
    EXPECT_TRUE(e.stops[3].seen.empty());
    EXPECT_FALSE(e.stops[3].missed.empty());
}

TEST_P(EachMethod, WorksOnTheWholePlantOfTags)
{
    SimulatedTurn turn = ordinaryTurn(1);
    TurnContext plant;
    plant.tags = tagGrid(31, 41, 0.1, {}, TagUid{1000});
    for (TurnStop& stop : turn.record.stops) // the same place in the larger grid: 41 tags a column, not 11
        for (TagRead& read : stop.reads)
            read.uid.value = 1000 + (read.uid.value - 1) / 11 * 41 + (read.uid.value - 1) % 11;
    const TurnEstimate e = solveWith(GetParam(), turn.record, plant);
    ASSERT_TRUE(e.valid);
    EXPECT_LT(errorOf(e.startPose, turn.truth.startPose).position_m, 0.010);
}

TEST_P(EachMethod, AnswersWithAStatusWhenThereIsNothingToSolve)
{
    const TurnContext context = largeField();
    const TurnEstimate empty = solveWith(GetParam(), {}, context);
    EXPECT_FALSE(empty.valid);
    TurnRecord record = ordinaryTurn().record;
    for (TurnStop& stop : record.stops)
        stop.reads.clear();
    const TurnEstimate silent = solveWith(GetParam(), record, context);
    EXPECT_FALSE(silent.valid);
    EXPECT_EQ(silent.status, "no_reads");
    EXPECT_TRUE(has(silent, TurnFlag::NoReads));
    EXPECT_EQ(silent.stops.size(), record.stops.size());

    record = ordinaryTurn().record;
    record.nominalStep = 0.0;
    EXPECT_EQ(solveWith(GetParam(), record, context).status, "step_out_of_range");
    record = ordinaryTurn().record;
    TurnContext centred = context;
    centred.antenna = {0.0, 0.0};
    EXPECT_EQ(solveWith(GetParam(), record, centred).status, "antenna_out_of_range");
    TurnContext noTable = context;
    noTable.rssiTable.clear();
    EXPECT_EQ(solveWith(GetParam(), record, noTable).status, "rssi_table_size");
    record.stops.resize(500);
    EXPECT_EQ(solveWith(GetParam(), record, context).status, "too_many_stops");
}

TEST_P(EachMethod, FlagsATurnWithHardlyAnyReads)
{
    TurnRecord record = ordinaryTurn().record;
    for (std::size_t k = 0; k < record.stops.size(); ++k)
        record.stops[k].reads.resize(k % 2);
    const TurnEstimate e = solveWith(GetParam(), record, largeField());
    EXPECT_TRUE(e.valid);
    EXPECT_TRUE(has(e, TurnFlag::FewReads));
}

TEST_P(EachMethod, StopsAtOnceWhenCancelled)
{
    std::stop_source source;
    source.request_stop();
    SolveOptions options;
    options.method = GetParam();
    options.stop = source.get_token();
    const TurnEstimate e = solveTurn(ordinaryTurn().record, largeField(), options);
    EXPECT_FALSE(e.valid);
    EXPECT_EQ(e.status, "cancelled");
}

/// Anything at all, well formed as far as the types go.
struct RandomInput {
    TurnRecord record;
    TurnContext context;
};

double oddNumber(SplitMix64& random)
{
    const double specials[] = {0.0,
                               -1.0,
                               1e300,
                               1e-300,
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()};
    return specials[random.next() % std::size(specials)];
}

RandomInput randomInput(std::uint64_t seed)
{
    SplitMix64 random(seed);
    RandomInput input{{}, largeField()};
    const auto rarely = [&] { return random.uniform() < 0.08; };
    input.record.nominalStep = rarely() ? oddNumber(random) : random.uniform(0.02, 2.0);
    const std::size_t stops = rarely() ? random.next() % 70 : random.next() % 10;
    const std::size_t most = rarely() ? 3000 : 12;
    const bool local = random.uniform() < 0.7;
    for (std::size_t k = 0; k < stops; ++k) {
        TurnStop stop;
        for (std::size_t i = random.next() % (most + 1); i > 0; --i) {
            const std::uint64_t tag = local ? 48 + random.next() % 30 : random.next() % 140;
            stop.reads.push_back({Time{}, TagUid{tag}, static_cast<int>(random.next() % 12) - 2});
        }
        if (rarely())
            stop.unknownIfUnseen.push_back(TagUid{random.next() % 121});
        input.record.stops.push_back(std::move(stop));
    }
    if (rarely())
        input.record.turnTime_s = oddNumber(random);
    if (rarely())
        input.record.rotation = Rotation::Clockwise;
    for (FloorTag& tag : input.context.tags)
        if (rarely())
            tag.position.x = rarely() ? oddNumber(random) : 0.5;
    if (rarely())
        input.context.antenna = {random.uniform(-0.3, 0.3), rarely() ? oddNumber(random) : 0.0};
    if (rarely())
        input.context.antennaSd_m = oddNumber(random);
    if (rarely())
        input.context.rssiTable.resize(1 + random.next() % 4);
    if (rarely())
        input.context.tags.insert(input.context.tags.end(), input.context.tags.begin(),
                                  input.context.tags.end());
    return input;
}

void expectSound(const TurnEstimate& e, std::uint64_t seed)
{
    if (!e.valid) {
        EXPECT_FALSE(e.status.empty()) << "input " << seed;
        return;
    }
    for (const double value :
         {e.startPose.position.x, e.startPose.position.y, e.startPose.heading, e.pose.heading, e.step,
          e.stepSd, e.radius_m, e.lastHeadingSd, e.rotationLogOdds, e.logEvidence,
          e.suggestedTurnTime_s.value_or(1.0), e.suggestedTurnTimeSd_s})
        EXPECT_TRUE(std::isfinite(value)) << "input " << seed;
    for (const double c : e.covariance)
        EXPECT_TRUE(std::isfinite(c)) << "input " << seed;
    EXPECT_GE(e.covariance[0], 0.0);
    EXPECT_GT(e.step, 0.0) << "input " << seed;
    EXPECT_GE(e.rotationLogOdds, 0.0) << "input " << seed;
    for (const StopReport& stop : e.stops)
        EXPECT_TRUE(std::isfinite(stop.antenna.x) && std::isfinite(stop.antennaSd_m)) << "input " << seed;
}

TEST_P(EachMethod, AlwaysEndsWithFiniteNumbersOrAStatus)
{
    const std::uint64_t inputs = GetParam() == SolveMethod::Fast ? 200 : 24;
    for (std::uint64_t seed = 0; seed < inputs; ++seed) {
        const RandomInput input = randomInput(seed);
        expectSound(solveWith(GetParam(), input.record, input.context), seed);
    }
}

TEST(AutoSolver, UsesSeveralReadsOfATag)
{
    // Ten reads of a tag, RSSI 4 and 5 by turns, place it between the two rings better than one of them.
    SimulatedTurn turn = studyTurn(studyScenario("A1_noise_miss10"), 8);
    const double before = sd_m(solveWith(SolveMethod::Auto, turn.record, largeField()));
    SplitMix64 random(3);
    for (TurnStop& stop : turn.record.stops) {
        const auto reads = stop.reads;
        for (const TagRead& read : reads)
            stop.reads.push_back({read.time, read.uid, read.rssi});
    }
    EXPECT_LT(sd_m(solveWith(SolveMethod::Auto, turn.record, largeField())), 1.05 * before);
}

TEST(AutoSolver, GetsBetterWithMoreStops)
{
    ErrorSample eight, seventeen;
    for (std::uint64_t i = 0; i < 6; ++i) {
        TurnScenario scenario = studyScenario("A7_all");
        SplitMix64 random(900 + i);
        eight.add(sd_m(solveWith(SolveMethod::Auto, simulateTurn(scenario, random).record, largeField())));
        scenario.stops = 17;
        scenario.nominalStep_deg = 22.5;
        SplitMix64 again(900 + i);
        const SimulatedTurn turn = simulateTurn(scenario, again);
        const TurnEstimate e = solveWith(SolveMethod::Auto, turn.record, largeField());
        EXPECT_LT(errorOf(e.startPose, turn.truth.startPose).position_m, 0.008);
        EXPECT_EQ(e.stops.size(), 17u);
        seventeen.add(sd_m(e));
    }
    EXPECT_LT(seventeen.mean(), eight.mean());
}

TEST(AutoSolver, ReturnsPromptlyWhenCancelledWhileWorking)
{
    std::stop_source source;
    SolveOptions options;
    options.stop = source.get_token();
    TurnEstimate estimate;
    std::jthread worker([&] { estimate = solveTurn(ordinaryTurn().record, largeField(), options); });
    source.request_stop();
    worker.join();
    EXPECT_EQ(estimate.status, "cancelled");
}

TEST(FastSolver, NeedsTwoStopsWithReads)
{
    TurnRecord record = ordinaryTurn().record;
    record.stops.resize(1);
    const TurnEstimate e = solveWith(SolveMethod::Fast, record, largeField());
    EXPECT_FALSE(e.valid);
    EXPECT_EQ(e.status, "too_few_stops");
}

TEST(FastSolver, IsAUsefulPreviewFromTheThirdStopOn)
{
    const SimulatedTurn turn = ordinaryTurn(9);
    for (std::size_t stops = 3; stops <= 8; ++stops) {
        TurnRecord record = turn.record;
        record.stops.resize(stops);
        const TurnEstimate e = solveWith(SolveMethod::Fast, record, largeField());
        ASSERT_TRUE(e.valid) << stops;
        EXPECT_LT(errorOf(e.startPose, turn.truth.startPose).position_m, 0.030) << stops;
    }
}

} // namespace
} // namespace agv::estimation::testing
