// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/classic_solver.h"

#include "estimation/classic/turn_vectors.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

namespace agv::estimation {
namespace {

TurnContext contextOf(const std::string& field)
{
    TurnContext context;
    context.tags = test::fieldOf(field);
    return context;
}

/// What the reader would see, without noise.
TurnRecord cleanTurn(const TurnContext& context, Pose2 start, double step, std::size_t stops,
                     Rotation rotation)
{
    TurnRecord record;
    record.nominalStep = step;
    for (std::size_t k = 0; k < stops; ++k) {
        const Pose2 pose{start.position, start.heading + signOf(rotation) * static_cast<double>(k) * step};
        const Point2 antenna = fromVehicleFrame(pose, context.antenna);
        TurnStop stop;
        for (const FloorTag& tag : context.tags) {
            if (const auto rssi = rssiAt(context.rssiTable, distance(tag.position, antenna)))
                stop.reads.push_back({Time{}, tag.uid, *rssi});
        }
        record.stops.push_back(stop);
    }
    return record;
}

bool has(const TurnEstimate& estimate, TurnFlag flag)
{
    return std::ranges::find(estimate.flags, flag) != estimate.flags.end();
}

double headingError_deg(const TurnEstimate& estimate, double expected_deg)
{
    return std::abs(degFromRad(wrapAngle(estimate.startPose.heading - radFromDeg(expected_deg))));
}

/// The study's repair keeps seven tags a stop and takes nearly parallel lines; where neither matters, the
/// results are the same.
TEST(ClassicSolver, equalsTheRepairedReferenceSolver)
{
    const std::set<std::size_t> nearlyParallel{11};
    const std::set<std::size_t> eightTags{15};
    const auto cases = test::readVector("seed_solver.json")["cases"];
    int compared = 0;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        if (nearlyParallel.contains(k) || eightTags.contains(k))
            continue;
        const auto& expected = cases[k]["repaired"];
        TurnRecord record = test::turnOf(cases[k]["rows"]);
        if (k != 17)
            record.rotation = Rotation::CounterClockwise;
        const TurnEstimate estimate = solveClassic(record, contextOf(cases[k]["field"].get<std::string>()));
        ASSERT_TRUE(estimate.valid) << k << " " << estimate.status;
        EXPECT_NEAR(mmFromMetres(estimate.startPose.position.x), expected["x"].get<double>(), 1e-6) << k;
        EXPECT_NEAR(mmFromMetres(estimate.startPose.position.y), expected["y"].get<double>(), 1e-6) << k;
        EXPECT_LT(headingError_deg(estimate, expected["angle"].get<double>()), 1e-6) << k;
        ++compared;
    }
    EXPECT_EQ(compared, 16);
}

TEST(ClassicSolver, passesOverLinesThatAreNearlyParallel)
{
    const auto vector = test::readVector("seed_solver.json")["cases"][11];
    const TurnEstimate estimate = solveClassic(test::turnOf(vector["rows"]), contextOf("11x11"));
    ASSERT_TRUE(estimate.valid);
    const Point2 truth{metresFromMm(vector["truth"]["x"].get<double>()),
                       metresFromMm(vector["truth"]["y"].get<double>())};
    const Point2 reference{metresFromMm(vector["repaired"]["x"].get<double>()),
                           metresFromMm(vector["repaired"]["y"].get<double>())};
    EXPECT_GT(distance(reference, truth), 0.15);
    EXPECT_LT(distance(estimate.startPose.position, truth), 0.06);
}

TEST(ClassicSolver, usesMoreThanSevenTagsAtAStop)
{
    const auto vector = test::readVector("seed_solver.json")["cases"][15];
    const TurnEstimate estimate = solveClassic(test::turnOf(vector["rows"]), contextOf("11x11"));
    ASSERT_TRUE(estimate.valid);
    EXPECT_EQ(estimate.stops.front().seen.size(), 8U);
}

TEST(ClassicSolver, followsBothDirectionsOfRotationAndAnyNumberOfStops)
{
    const TurnContext context = contextOf("11x11");
    for (const Rotation rotation : {Rotation::CounterClockwise, Rotation::Clockwise}) {
        for (const std::size_t stopsPerTurn : {8U, 12U, 16U}) {
            for (const double heading_deg : {0.0, 77.0, -140.0}) {
                const double step = 2.0 * std::numbers::pi / static_cast<double>(stopsPerTurn);
                const Pose2 start{{0.512, 0.467}, radFromDeg(heading_deg)};
                const TurnRecord record = cleanTurn(context, start, step, stopsPerTurn + 1, rotation);
                const TurnEstimate estimate = solveClassic(record, context);
                ASSERT_TRUE(estimate.valid);
                EXPECT_EQ(estimate.rotation, rotation) << stopsPerTurn << " " << heading_deg;
                EXPECT_LT(distance(estimate.startPose.position, start.position), 0.07);
                EXPECT_LT(headingError_deg(estimate, heading_deg), 20.0);
                // After a whole turn the robot looks where it looked before.
                EXPECT_LT(std::abs(wrapAngle(estimate.pose.heading - start.heading)), radFromDeg(25.0));
                EXPECT_EQ(estimate.stops.size(), stopsPerTurn + 1);
            }
        }
    }
}

TEST(ClassicSolver, keepsTheHeadingOfStopZeroWhenTheFirstPairComesLater)
{
    const TurnContext context = contextOf("11x11");
    const Pose2 start{{0.512, 0.467}, radFromDeg(30.0)};
    for (const Rotation rotation : {Rotation::CounterClockwise, Rotation::Clockwise}) {
        TurnRecord record = cleanTurn(context, start, radFromDeg(45.0), 8, rotation);
        record.stops[0].reads.clear();
        record.stops[1].reads.clear();
        const TurnEstimate estimate = solveClassic(record, context);
        ASSERT_TRUE(estimate.valid);
        EXPECT_EQ(estimate.rotation, rotation);
        EXPECT_LT(headingError_deg(estimate, 30.0), 20.0);
    }
}

TEST(ClassicSolver, saysWhenTheRobotTurnedAgainstTheCommand)
{
    const TurnContext context = contextOf("11x11");
    TurnRecord record = cleanTurn(context, {{0.5, 0.5}, 0.3}, radFromDeg(45.0), 8, Rotation::Clockwise);
    record.rotation = Rotation::CounterClockwise;
    const TurnEstimate estimate = solveClassic(record, context);
    EXPECT_EQ(estimate.rotation, Rotation::Clockwise);
    EXPECT_TRUE(has(estimate, TurnFlag::WrongRotation));
    record.rotation = Rotation::Clockwise;
    EXPECT_FALSE(has(solveClassic(record, context), TurnFlag::WrongRotation));
}

TEST(ClassicSolver, doesNotPretendToHaveMeasuredTheStep)
{
    const TurnContext context = contextOf("11x11");
    TurnRecord record =
        cleanTurn(context, {{0.5, 0.5}, 0.3}, radFromDeg(40.0), 8, Rotation::CounterClockwise);
    record.nominalStep = radFromDeg(45.0);
    record.turnTime_s = 1.125;
    const TurnEstimate estimate = solveClassic(record, context);
    EXPECT_DOUBLE_EQ(estimate.step, radFromDeg(45.0));
    EXPECT_GT(estimate.stepSd, radFromDeg(5.0));
    EXPECT_FALSE(estimate.suggestedTurnTime_s.has_value());
}

TEST(ClassicSolver, answersEveryUnusableTurnWithAStatus)
{
    const TurnContext context = contextOf("11x11");
    const TurnRecord good = cleanTurn(context, {{0.5, 0.5}, 0.3}, radFromDeg(45.0), 8, Rotation::Clockwise);

    TurnEstimate estimate = solveClassic({}, context);
    EXPECT_EQ(estimate.status, "no_reads");
    EXPECT_TRUE(has(estimate, TurnFlag::NoReads));

    TurnRecord foreign = good;
    for (TurnStop& stop : foreign.stops) {
        for (TagRead& read : stop.reads)
            read.uid = TagUid{7};
    }
    estimate = solveClassic(foreign, context);
    EXPECT_EQ(estimate.status, "no_reads");
    EXPECT_EQ(estimate.stops.front().unknown, std::vector{TagUid{7}});

    for (const double step : {0.0, -1.0, std::nan(""), 1e-9, 0.7, 10.0}) {
        TurnRecord badStep = good;
        badStep.nominalStep = step;
        EXPECT_EQ(solveClassic(badStep, context).status, "bad_step") << step;
    }

    TurnRecord half = good;
    half.stops.resize(5);
    EXPECT_EQ(solveClassic(half, context).status, "no_solution");

    // Twice the same stop: every line runs through the same two points.
    TurnRecord still = good;
    for (std::size_t k = 0; k < 4; ++k) {
        still.stops[k] = good.stops[0];
        still.stops[k + 4] = good.stops[4];
    }
    EXPECT_EQ(solveClassic(still, context).status, "parallel");

    TurnRecord badRssi = good;
    for (TurnStop& stop : badRssi.stops) {
        for (TagRead& read : stop.reads)
            read.rssi = 99;
    }
    EXPECT_EQ(solveClassic(badRssi, context).status, "no_solution");
    EXPECT_FALSE(solveClassic(badRssi, context).valid);
}

TEST(ClassicSolver, reportsTagsThatAreMissedUnknownAndMisplaced)
{
    const TurnContext context = contextOf("11x11");
    TurnRecord record = cleanTurn(context, {{0.5, 0.5}, 0.3}, radFromDeg(45.0), 8, Rotation::Clockwise);
    const TagUid lost = record.stops[2].reads.front().uid;
    std::erase_if(record.stops[2].reads, [=](const TagRead& read) { return read.uid == lost; });
    record.stops[2].reads.push_back({Time{}, TagUid{1}, 3});
    record.stops[2].reads.push_back({Time{}, test::uidOf(1), 0});
    const StopReport report = solveClassic(record, context).stops.at(2);
    EXPECT_EQ(report.missed, std::vector{lost});
    EXPECT_EQ(report.unknown, std::vector{TagUid{1}});
    EXPECT_EQ(report.misplaced, std::vector{test::uidOf(1)});

    record.stops[2].unknownIfUnseen = {lost};
    EXPECT_TRUE(solveClassic(record, context).stops.at(2).missed.empty());
}

TEST(ClassicSolver, takesTheMostFrequentRssiOfATag)
{
    const TurnContext context = contextOf("11x11");
    const TurnRecord once = cleanTurn(context, {{0.5, 0.5}, 0.3}, radFromDeg(45.0), 8, Rotation::Clockwise);
    TurnRecord often = once;
    for (TurnStop& stop : often.stops) {
        const std::vector<TagRead> reads = stop.reads;
        for (TagRead read : reads) {
            stop.reads.push_back(read);
            read.rssi = 7 - read.rssi;
            stop.reads.push_back(read);
        }
    }
    EXPECT_EQ(solveClassic(often, context).startPose, solveClassic(once, context).startPose);
}

} // namespace
} // namespace agv::estimation
