// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/anchor_pairs.h"

#include "core/text_file.h"
#include "estimation/uwb/anchor_survey.h"
#include "protocol/trek_samples.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

namespace agv::session {
namespace {

protocol::RangeSet rangeOf(int first, int second, double range_m, double time_s = 100.0,
                           RangeKind kind = RangeKind::AnchorAnchor)
{
    protocol::RangeSet ranges;
    ranges.add({.time_s = time_s, .range_m = range_m, .tag = first, .anchor = second, .kind = kind});
    return ranges;
}

TEST(AnchorPairs, giveMedianAndDeviationOfEachPair)
{
    AnchorPairs pairs;
    for (const double range_m : {4.1, 3.9, 9.0, 4.0, 4.2})
        pairs.add(rangeOf(0, 1, range_m));
    for (const double range_m : {6.0, 6.2})
        pairs.add(rangeOf(0, 2, range_m));
    pairs.add(rangeOf(1, 2, 5.0));
    const std::vector<AnchorPairSnapshot> known = pairs.snapshot(100.0);
    ASSERT_EQ(known.size(), 3U);
    EXPECT_EQ(known[0].first, 0);
    EXPECT_EQ(known[0].second, 1);
    EXPECT_EQ(known[0].count, 5);
    EXPECT_EQ(known[0].range_m, 4.1); // one gross error does not move it
    EXPECT_NEAR(known[1].range_m, 6.1, 1e-12);
    EXPECT_NEAR(known[1].sd_m, 0.2 / std::numbers::sqrt2, 1e-12);
    EXPECT_EQ(known[2].range_m, 5.0);
    EXPECT_EQ(known[2].sd_m, 0.0);
    EXPECT_EQ(known[2].count, 1);
}

TEST(AnchorPairs, areTheSameInBothDirections)
{
    AnchorPairs pairs;
    pairs.add(rangeOf(2, 0, 4.0));
    pairs.add(rangeOf(0, 2, 5.0));
    const std::vector<AnchorPairSnapshot> known = pairs.snapshot(100.0);
    ASSERT_EQ(known.size(), 1U);
    EXPECT_EQ(known[0].first, 0);
    EXPECT_EQ(known[0].second, 2);
    EXPECT_EQ(known[0].range_m, 4.5);
    EXPECT_EQ(known[0].count, 2);
}

TEST(AnchorPairs, rangesOfTagsAreLeftOut)
{
    AnchorPairs pairs;
    pairs.add(rangeOf(0, 1, 4.0, 100.0, RangeKind::TagAnchor));
    EXPECT_TRUE(pairs.snapshot(100.0).empty());
}

TEST(AnchorPairs, olderRangesMakeRoomForNewOnes)
{
    AnchorPairs pairs;
    for (std::size_t i = 0; i < 5 * AnchorPairs::rangesKept; ++i)
        pairs.add(rangeOf(0, 1, 4.0));
    for (std::size_t i = 0; i < AnchorPairs::rangesKept; ++i)
        pairs.add(rangeOf(0, 1, 4.5));
    const std::vector<AnchorPairSnapshot> known = pairs.snapshot(100.0);
    EXPECT_EQ(known[0].range_m, 4.5);
    EXPECT_EQ(known[0].sd_m, 0.0);
    EXPECT_EQ(known[0].count, static_cast<int>(AnchorPairs::rangesKept));
}

TEST(AnchorPairs, aPairThatIsSilentIsForgotten)
{
    AnchorPairs pairs;
    pairs.add(rangeOf(0, 1, 4.0, 100.0));
    pairs.add(rangeOf(0, 2, 6.0, 150.0));
    EXPECT_EQ(pairs.snapshot(100.0 + AnchorPairs::forgottenAfter_s).size(), 2U);
    const std::vector<AnchorPairSnapshot> later = pairs.snapshot(101.0 + AnchorPairs::forgottenAfter_s);
    ASSERT_EQ(later.size(), 1U);
    EXPECT_EQ(later[0].second, 2);
    // It may stand elsewhere when it is heard again.
    pairs.add(rangeOf(0, 1, 7.0, 200.0));
    EXPECT_EQ(pairs.snapshot(200.0)[0].range_m, 7.0);
    EXPECT_EQ(pairs.snapshot(200.0)[0].count, 1);
}

TEST(AnchorPairs, nothingIsLeftAfterClearing)
{
    AnchorPairs pairs;
    pairs.add(rangeOf(0, 1, 4.0));
    pairs.clear();
    EXPECT_TRUE(pairs.snapshot(100.0).empty());
}

TEST(AnchorPairs, ofAGenuineKitGiveATriangleWithItsRanges)
{
    const auto file = std::filesystem::path(AGV_RECORDINGS) / "trek_lines" / "trek1000_sample.txt";
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "the recordings are not here: " << file;
    const auto text = readTextFile(file, std::size_t{1} << 20U);
    ASSERT_TRUE(text.has_value());
    protocol::TrekRanges reader;
    AnchorPairs pairs;
    for (const protocol::TrekReport& report : protocol::samples::hear(*text).reports)
        pairs.add(reader.read(report));
    const std::vector<AnchorPairSnapshot> known = pairs.snapshot(0.0);
    ASSERT_EQ(known.size(), 3U);
    EXPECT_EQ(known[0].count, 3);
    EXPECT_EQ(known[0].range_m, 1.739); // of 1753, 1739 and 1734 mm
    const std::vector<UwbAnchor> level{
        {0, "A0", 0.0, 0.0, 0.0, true}, {1, "A1", 0.0, 0.0, 0.0, true}, {2, "A2", 0.0, 0.0, 0.0, true}};
    const AnchorSurvey survey = estimation::surveyAnchors(known, level, {.rangesNeeded = 3});
    ASSERT_EQ(survey.trouble, "");
    const auto apart = [&](std::size_t i, std::size_t k) {
        return distance(survey.anchors[i].position, survey.anchors[k].position);
    };
    EXPECT_NEAR(apart(0, 1), known[0].range_m, 1e-6);
    EXPECT_NEAR(apart(0, 2), known[1].range_m, 1e-6);
    EXPECT_NEAR(apart(1, 2), known[2].range_m, 1e-6);
}

} // namespace
} // namespace agv::session
