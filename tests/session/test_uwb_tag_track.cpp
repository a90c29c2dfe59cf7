// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/uwb_tag_track.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace agv::session {
namespace {

const std::vector<UwbAnchor> corners{{0, "A0", 0.0, 0.0, 2.0, true},
                                     {1, "A1", 3.0, 0.0, 2.0, true},
                                     {2, "A2", 3.0, 4.0, 2.0, true},
                                     {3, "A3", 0.0, 4.0, 2.5, true}};
constexpr UwbTag tagFive() { return {.id = 5, .label = {}, .agv = {}, .z_m = 0.3, .mount = {}}; }

double trueRange(const UwbAnchor& anchor, Point2 at)
{
    return std::hypot(at.x - anchor.x, at.y - anchor.y, 0.3 - anchor.z);
}

protocol::RangeSet rangesAt(Point2 at, double time_s, const std::vector<double>& errors_m)
{
    protocol::RangeSet ranges;
    for (const UwbAnchor& anchor : corners)
        ranges.add({.time_s = time_s,
                    .range_m = trueRange(anchor, at) + errors_m[static_cast<std::size_t>(anchor.id)],
                    .tag = 5,
                    .anchor = anchor.id});
    return ranges;
}

/// Feeds `count` reports at 10 Hz from `from_s` on; the time after the last.
double feed(UwbTagTrack& track, int count, double from_s, const std::vector<double>& errors_m)
{
    for (int i = 0; i < count; ++i)
        track.take(rangesAt({1.0, 1.5}, from_s + 0.1 * i, errors_m), from_s + 0.1 * i);
    return from_s + 0.1 * count;
}

TEST(UwbTagTrack, ACorrectionIsAddedToTheRangesOfItsTagBeforeThePosition)
{
    const std::vector<double> errors{0.25, -0.15, 0.2, -0.3};
    std::vector<RangeCorrection> corrections;
    for (const UwbAnchor& anchor : corners) {
        corrections.push_back({anchor.id, 4, 9.0}); // of another tag
        corrections.push_back({anchor.id, 5, -errors[static_cast<std::size_t>(anchor.id)]});
    }
    UwbTagTrack track(tagFive(), corners, corrections);
    const double now = feed(track, 30, 10.0, errors);
    const UwbTagSnapshot tag = track.snapshot(now);
    ASSERT_TRUE(tag.position) << tag.reason;
    EXPECT_LT(distance(*tag.position, {1.0, 1.5}), 1e-3);
    for (const UwbRangeSnapshot& range : tag.ranges)
        EXPECT_NEAR(range.range_m, trueRange(corners[static_cast<std::size_t>(range.anchor)], {1.0, 1.5}),
                    1e-9);
}

TEST(UwbTagTrack, AnEditThatDoesNotTouchThePositionLeavesTheTrackRunning)
{
    UwbTagTrack track(tagFive(), corners);
    const double now = feed(track, 30, 10.0, {0, 0, 0, 0});
    UwbTag renamed = tagFive();
    renamed.label = "Front";
    renamed.agv = RobotId{2};
    std::vector<UwbAnchor> hidden = corners;
    hidden[1].shown = false;
    hidden[2].label = "Door";
    EXPECT_FALSE(track.setLayout(renamed, hidden, {{1, 4, 0.5}}));
    const UwbTagSnapshot tag = track.snapshot(now);
    EXPECT_TRUE(tag.position);
    EXPECT_TRUE(tag.r95_m);
    EXPECT_EQ(tag.label, "Front");
    EXPECT_EQ(tag.agv, RobotId{2});
}

TEST(UwbTagTrack, AnEditOfAnAnchorACorrectionOrTheHeightStartsThePositionAnew)
{
    const auto isAnew = [](const UwbTag& tag, const std::vector<UwbAnchor>& anchors,
                           const std::vector<RangeCorrection>& corrections) {
        UwbTagTrack track(tagFive(), corners);
        const double now = feed(track, 30, 10.0, {0, 0, 0, 0});
        const bool isChanged = track.setLayout(tag, anchors, corrections);
        EXPECT_EQ(track.snapshot(now).position.has_value(), !isChanged);
        EXPECT_EQ(track.shown().empty(), isChanged);
        return isChanged;
    };
    UwbTag higher = tagFive();
    higher.z_m = 0.4;
    std::vector<UwbAnchor> moved = corners;
    moved[3].y += 0.1;
    EXPECT_TRUE(isAnew(higher, corners, {}));
    EXPECT_TRUE(isAnew(tagFive(), moved, {}));
    EXPECT_TRUE(isAnew(tagFive(), {corners[0], corners[1], corners[2]}, {}));
    EXPECT_TRUE(isAnew(tagFive(), corners, {{1, 5, 0.1}}));
    EXPECT_FALSE(isAnew(tagFive(), corners, {}));
}

TEST(UwbTagTrack, AMovedAnchorInTheListMovesThePositionWithTheNextReport)
{
    std::vector<UwbAnchor> wrong = corners;
    for (UwbAnchor& anchor : wrong)
        anchor.x += 2.0;
    UwbTagTrack track(tagFive(), wrong);
    double now = feed(track, 30, 10.0, {0, 0, 0, 0});
    EXPECT_LT(distance(track.snapshot(now).position.value(), {3.0, 1.5}), 0.01);
    track.setLayout(tagFive(), corners, {});
    now = feed(track, 1, now, {0, 0, 0, 0});
    EXPECT_LT(distance(track.snapshot(now).position.value(), {1.0, 1.5}), 0.01);
}

TEST(UwbTagTrack, R95IsTheRadiusAboutTheMeanThatHolds95PercentOfThePositions)
{
    estimation::PositionSpread spread;
    for (std::size_t i = 0; i < 1000; ++i)
        spread.add({50.0, 50.0}); // long ago
    SplitMix64 random(7);
    for (std::size_t i = 0; i < estimation::PositionSpread::kept; ++i)
        spread.add({3.0 + 0.02 * random.normal(), -1.0 + 0.02 * random.normal()});
    EXPECT_NEAR(spread.r95_m().value(), 0.02 * 2.448, 0.008); // of a circular normal distribution
}

TEST(UwbTagTrack, R95NeedsTwentyPositionsAndIsForgottenWithThem)
{
    UwbTagTrack track(tagFive(), corners);
    double now = feed(track, 19, 10.0, {0, 0, 0, 0});
    EXPECT_TRUE(track.snapshot(now).position);
    EXPECT_FALSE(track.snapshot(now).r95_m);
    now = feed(track, 1, now, {0, 0, 0, 0});
    ASSERT_TRUE(track.snapshot(now).r95_m);
    EXPECT_LT(*track.snapshot(now).r95_m, 1e-3);
    now = feed(track, 5, now + 10.0, {0, 0, 0, 0}); // a silence: the tag may have been carried elsewhere
    EXPECT_TRUE(track.snapshot(now).position);
    EXPECT_FALSE(track.snapshot(now).r95_m);
}

} // namespace
} // namespace agv::session
