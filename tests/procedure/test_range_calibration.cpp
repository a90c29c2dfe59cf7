// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/range_calibration.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace agv::procedure {
namespace {

using namespace std::chrono_literals;

constexpr Time calibrationBegin{1000s};
constexpr CalibrationPlace place{1.0, 2.0, 0.3};
const std::vector<UwbAnchor> anchors{
    {4, "A4", 0.0, 0.0, 2.0, true}, {1, "A1", 6.0, 0.0, 2.0, true}, {2, "A2", 6.0, 5.0, 2.5, true}};

double trueDistance(const UwbAnchor& anchor)
{
    return std::hypot(anchor.x - place.x, anchor.y - place.y, anchor.z - place.z);
}

RangeMeasurement rangeOf(int tag, int anchor, double range_m)
{
    RangeMeasurement range;
    range.range_m = range_m;
    range.tag = tag;
    range.anchor = anchor;
    return range;
}

/// A calibration of tag 3 over 30 s that is told what a test wants.
struct Calibration {
    Calibration()
    {
        calibration.start(3, place, anchors, RangeCalibration::usualDuration_s, calibrationBegin);
    }

    /// One range of each anchor every 100 ms for `seconds`; what they are too long by, m.
    template<typename Error>
    void run(double seconds, Error errorOf)
    {
        for (const Time end = now + durationFromSeconds(seconds); now < end; now += 100ms)
            for (const UwbAnchor& anchor : anchors)
                calibration.add(rangeOf(3, anchor.id, trueDistance(anchor) + errorOf(anchor.id)), now);
        calibration.onTimer(now);
    }
    RangeCalibrationSnapshot snapshot() const { return calibration.snapshot(now); }

    RangeCalibration calibration;
    Time now = calibrationBegin;
    SplitMix64 random{5};
};

double errorOfAnchor(int anchor) { return anchor == 1 ? 0.21 : -0.05; }

TEST(RangeCalibration, IsIdleAtFirst)
{
    EXPECT_EQ(RangeCalibration().snapshot(calibrationBegin), RangeCalibrationSnapshot{});
}

TEST(RangeCalibration, TheOffsetIsTheTrueDistanceMinusTheMedianRange)
{
    Calibration c;
    c.run(31.0, [&](int anchor) { return errorOfAnchor(anchor) + 0.03 * c.random.normal(); });
    const RangeCalibrationSnapshot result = c.snapshot();
    EXPECT_EQ(result.state, RangeCalibrationState::Finished);
    EXPECT_EQ(result.reason, "");
    EXPECT_EQ(result.tag, 3);
    EXPECT_EQ(result.progress, 1.0);
    ASSERT_EQ(result.rows.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const RangeCalibrationRow& row = result.rows[i];
        EXPECT_EQ(row.anchor, anchors[i].id);
        EXPECT_EQ(row.count, 300);
        EXPECT_NEAR(row.offset_m.value(), -errorOfAnchor(row.anchor), 0.01);
        EXPECT_NEAR(row.spread_m, 0.03, 0.006);
    }
}

TEST(RangeCalibration, AnObstructionOfATenthOfTheTimeHardlyChangesTheOffset)
{
    Calibration c;
    c.run(3.0, [&](int) { return 0.9 + 0.03 * c.random.normal(); });
    c.run(27.0, [&](int) { return 0.03 * c.random.normal(); });
    EXPECT_EQ(c.snapshot().state, RangeCalibrationState::Finished);
    EXPECT_EQ(c.snapshot().reason, "");
    for (const RangeCalibrationRow& row : c.snapshot().rows)
        EXPECT_NEAR(row.offset_m.value(), 0.0, 0.015);
}

TEST(RangeCalibration, AnAnchorThatIsHiddenLongIsNamed)
{
    Calibration c;
    c.run(12.0, [&](int anchor) { return (anchor == 2 ? 0.6 : 0.0) + 0.03 * c.random.normal(); });
    c.run(18.0, [&](int) { return 0.03 * c.random.normal(); });
    EXPECT_EQ(c.snapshot().state, RangeCalibrationState::Finished);
    EXPECT_TRUE(c.snapshot().reason.starts_with("The ranges of anchor 2 scatter by 3"))
        << c.snapshot().reason;
}

TEST(RangeCalibration, AnOffsetOfMoreThanAMetreIsDoubted)
{
    Calibration c;
    c.run(30.0, [](int anchor) { return anchor == 1 ? -1.5 : 0.0; });
    EXPECT_EQ(c.snapshot().state, RangeCalibrationState::Finished);
    EXPECT_EQ(c.snapshot().reason,
              "The ranges of anchor 1 are wrong by 1500 mm: check the places of the tag and "
              "the anchor before you use the offset");
    EXPECT_NEAR(c.snapshot().rows[1].offset_m.value(), 1.5, 1e-9);
}

TEST(RangeCalibration, AnAnchorWithFewRangesGetsNoOffset)
{
    Calibration c;
    for (int i = 0; i < 100; ++i) {
        c.calibration.add(rangeOf(3, 1, 5.0), calibrationBegin);
        if (i < 19)
            c.calibration.add(rangeOf(3, 2, 5.0), calibrationBegin);
    }
    c.calibration.onTimer(calibrationBegin + 30s);
    const RangeCalibrationSnapshot result = c.calibration.snapshot(calibrationBegin + 30s);
    EXPECT_EQ(result.state, RangeCalibrationState::Finished);
    EXPECT_TRUE(result.rows[1].offset_m);
    EXPECT_FALSE(result.rows[2].offset_m);
    EXPECT_EQ(result.rows[2].count, 19);
    EXPECT_EQ(result.reason,
              "Anchors without an offset, because they measured the tag fewer than 20 times: 4, 2");
}

TEST(RangeCalibration, FailsWhenTheTagIsNotHeard)
{
    Calibration c;
    for (int i = 0; i < 100; ++i) {
        c.calibration.add(rangeOf(4, 1, 5.0), calibrationBegin); // another tag
        c.calibration.add(rangeOf(3, 9, 5.0), calibrationBegin); // an anchor that is not in the list
        RangeMeasurement between = rangeOf(3, 1, 5.0);
        between.kind = RangeKind::AnchorAnchor;
        c.calibration.add(between, calibrationBegin);
    }
    c.calibration.onTimer(calibrationBegin + 29s);
    EXPECT_EQ(c.calibration.state(), RangeCalibrationState::Collecting);
    c.calibration.onTimer(calibrationBegin + 30s);
    EXPECT_EQ(c.calibration.state(), RangeCalibrationState::Failed);
    EXPECT_TRUE(
        c.calibration.snapshot(calibrationBegin).reason.starts_with("Tag 3 was not heard: switch it on"));
}

TEST(RangeCalibration, FailsWhenNoAnchorMeasuredTheTagOftenEnough)
{
    Calibration c;
    for (int i = 0; i < 19; ++i)
        c.calibration.add(rangeOf(3, 1, 5.0), calibrationBegin);
    c.calibration.onTimer(calibrationBegin + 30s);
    EXPECT_EQ(c.calibration.state(), RangeCalibrationState::Failed);
    EXPECT_TRUE(
        c.calibration.snapshot(calibrationBegin).reason.starts_with("No anchor measured tag 3 20 times"));
}

TEST(RangeCalibration, ShowsHowFarItIsAndWhatItHasSoFar)
{
    Calibration c;
    c.run(7.5, [](int) { return 0.1; });
    EXPECT_EQ(c.snapshot().state, RangeCalibrationState::Collecting);
    EXPECT_NEAR(c.snapshot().progress, 0.25, 1e-9);
    EXPECT_EQ(c.snapshot().rows[0].count, 75);
    EXPECT_NEAR(c.snapshot().rows[0].offset_m.value(), -0.1, 1e-9);
}

TEST(RangeCalibration, TakesNothingAfterItsTimeEvenWhenNoTimerCame)
{
    Calibration c;
    c.run(29.9, [](int) { return 0.0; });
    for (int i = 0; i < 1000; ++i)
        c.calibration.add(rangeOf(3, 1, 50.0), calibrationBegin + 31s);
    EXPECT_EQ(c.calibration.state(), RangeCalibrationState::Finished);
    EXPECT_NEAR(c.snapshot().rows[1].offset_m.value(), 0.0, 1e-9);
}

TEST(RangeCalibration, ASecondOneBeginsFromNothingAlsoWhileTheFirstIsRunning)
{
    Calibration c;
    c.run(10.0, [](int) { return 5.0; });
    c.calibration.start(3, place, anchors, 10.0, c.now);
    EXPECT_EQ(c.snapshot().rows[0].count, 0);
    c.run(10.0, [](int) { return 0.0; });
    EXPECT_EQ(c.snapshot().state, RangeCalibrationState::Finished);
    EXPECT_NEAR(c.snapshot().rows[0].offset_m.value(), 0.0, 1e-9);
}

TEST(RangeCalibration, CancelForgetsEverythingInEveryState)
{
    for (const double seconds : {0.0, 10.0, 30.0}) {
        Calibration c;
        c.run(seconds, [](int) { return 0.0; });
        c.calibration.cancel();
        EXPECT_EQ(c.snapshot(), RangeCalibrationSnapshot{});
        c.calibration.add(rangeOf(3, 1, 5.0), c.now);
        EXPECT_EQ(c.snapshot(), RangeCalibrationSnapshot{});
    }
}

TEST(RangeCalibration, AbortEndsOnlyOneThatIsCollecting)
{
    Calibration c;
    c.run(1.0, [](int) { return 0.0; });
    c.calibration.abort("The anchors were moved");
    EXPECT_EQ(c.snapshot().state, RangeCalibrationState::Failed);
    EXPECT_EQ(c.snapshot().reason, "The anchors were moved");
    Calibration finished;
    finished.run(30.0, [](int) { return 0.0; });
    finished.calibration.abort("The anchors were moved");
    EXPECT_EQ(finished.snapshot().state, RangeCalibrationState::Finished);
}

TEST(RangeCalibration, FailsAtOnceWhenItsValuesAreOfNoUse)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto reasonFor = [](CalibrationPlace where, const std::vector<UwbAnchor>& list, double seconds) {
        RangeCalibration calibration;
        calibration.start(3, where, list, seconds, calibrationBegin);
        EXPECT_EQ(calibration.state(), RangeCalibrationState::Failed);
        calibration.add(rangeOf(3, 1, 5.0), calibrationBegin);
        return calibration.snapshot(calibrationBegin).reason;
    };
    EXPECT_TRUE(reasonFor(place, {}, 30.0).starts_with("There is no anchor"));
    EXPECT_TRUE(reasonFor({nan, 0.0, 0.0}, anchors, 30.0).starts_with("The place of the tag is not known"));
    for (const double seconds : {-1.0, 0.9, 601.0, nan})
        EXPECT_TRUE(reasonFor(place, anchors, seconds)
                        .starts_with("The time of a calibration must lie between 1 and 600 s"));
}

} // namespace
} // namespace agv::procedure
