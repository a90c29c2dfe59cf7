// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/anchor_survey.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace agv::estimation {
namespace {

/// Corners and two sides of a hall, in two heights.
const std::vector<UwbAnchor> hall{{0, "A0", 0.0, 0.0, 1.3, true}, {1, "A1", 5.0, 0.2, 2.3, true},
                                  {2, "A2", 0.3, 7.0, 2.3, true}, {3, "A3", 5.2, 7.1, 1.3, true},
                                  {4, "A4", 2.6, 0.0, 1.3, true}, {5, "A5", 5.0, 3.4, 2.0, true}};

double slant(const UwbAnchor& a, const UwbAnchor& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

AnchorPairSnapshot pairOf(const UwbAnchor& a, const UwbAnchor& b, double error_m = 0.0)
{
    return {.first = a.id, .second = b.id, .range_m = slant(a, b) + error_m, .sd_m = 0.03, .count = 100};
}

/// Ranges between the first `count` anchors of the hall; errors normal with `sd_m`.
std::vector<AnchorPairSnapshot> allPairs(std::size_t count, double sd_m = 0.0, std::uint64_t seed = 1)
{
    SplitMix64 random(seed);
    std::vector<AnchorPairSnapshot> pairs;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = i + 1; k < count; ++k)
            pairs.push_back(pairOf(hall[i], hall[k], sd_m * random.normal()));
    return pairs;
}

void drop(std::vector<AnchorPairSnapshot>& pairs, int first, int second)
{
    std::erase_if(
        pairs, [=](const AnchorPairSnapshot& pair) { return pair.first == first && pair.second == second; });
}

/// Largest distance between a surveyed anchor and where it really is, after the survey is laid on `list`.
double largestError_m(const AnchorSurvey& survey, const std::vector<UwbAnchor>& truth = hall)
{
    const auto anchors = placed(survey, closestFrame(survey, truth), truth);
    double largest = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        largest = std::max(largest, std::hypot(anchors[i].x - truth[i].x, anchors[i].y - truth[i].y));
    return largest;
}

std::vector<UwbAnchor> first(std::size_t count)
{
    return {hall.begin(), hall.begin() + std::ptrdiff_t(count)};
}

TEST(SurveyAnchors, threeAnchorsGiveTheirTriangleInItsOwnFrame)
{
    const AnchorSurvey survey = surveyAnchors(allPairs(3), first(3));
    ASSERT_EQ(survey.trouble, "");
    ASSERT_EQ(survey.anchors.size(), 3U);
    EXPECT_EQ(survey.anchors[0].position, Point2{});
    EXPECT_NEAR(survey.anchors[1].position.x, std::hypot(5.0, 0.2), 1e-6);
    EXPECT_NEAR(survey.anchors[1].position.y, 0.0, 1e-6);
    EXPECT_GT(survey.anchors[2].position.y, 6.0);
    EXPECT_LT(largestError_m(survey, first(3)), 1e-6);
    EXPECT_TRUE(survey.notes.empty());
    EXPECT_NEAR(survey.residual_m, 0.0, 1e-6);
}

TEST(SurveyAnchors, anyNumberOfAnchorsIsPlaced)
{
    for (std::size_t count = 3; count <= hall.size(); ++count) {
        const AnchorSurvey survey = surveyAnchors(allPairs(count), first(count));
        ASSERT_EQ(survey.trouble, "") << count;
        EXPECT_EQ(survey.anchors.size(), count);
        EXPECT_LT(largestError_m(survey, first(count)), 1e-6) << count;
        EXPECT_TRUE(survey.notes.empty()) << survey.notes.front();
    }
}

TEST(SurveyAnchors, theirScaleIsRightWithinTheNoise)
{
    double sum = 0.0;
    constexpr int trials = 200;
    for (int trial = 0; trial < trials; ++trial) {
        const AnchorSurvey survey = surveyAnchors(allPairs(6, 0.03, std::uint64_t(trial) + 1), hall);
        ASSERT_EQ(survey.trouble, "");
        double size = 0.0;
        double trueSize = 0.0;
        for (const SurveyedAnchor& a : survey.anchors)
            for (const SurveyedAnchor& b : survey.anchors) {
                size += distance(a.position, b.position);
                const UwbAnchor& trueA = hall[std::size_t(a.id)];
                const UwbAnchor& trueB = hall[std::size_t(b.id)];
                trueSize += std::hypot(trueA.x - trueB.x, trueA.y - trueB.y);
            }
        sum += size / trueSize;
    }
    EXPECT_NEAR(sum / trials, 1.0, 0.001);
}

TEST(SurveyAnchors, rangesAreNotTakenForDistancesOnTheFloor)
{
    // 4 m apart on the floor and 1.2 m in height: 4.176 m along the slope, 4.4 % more.
    const std::vector<UwbAnchor> slope{
        {0, "A0", 0.0, 0.0, 1.0, true}, {1, "A1", 4.0, 0.0, 2.2, true}, {2, "A2", 0.0, 4.0, 2.2, true}};
    const std::vector<AnchorPairSnapshot> pairs{pairOf(slope[0], slope[1]), pairOf(slope[0], slope[2]),
                                                pairOf(slope[1], slope[2])};
    EXPECT_NEAR(surveyAnchors(pairs, slope).anchors[1].position.x, 4.0, 1e-6);
    std::vector<UwbAnchor> level = slope;
    for (UwbAnchor& anchor : level)
        anchor.z = 0.0;
    EXPECT_NEAR(surveyAnchors(pairs, level).anchors[1].position.x, 4.176, 1e-3);
}

TEST(SurveyAnchors, theirSdIsTheErrorThatRepeatedSurveysHave)
{
    double errors = 0.0;
    double variances = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const AnchorSurvey survey = surveyAnchors(allPairs(6, 0.03, seed), hall);
        const auto anchors = placed(survey, closestFrame(survey, hall), hall);
        for (std::size_t i = 0; i < hall.size(); ++i) {
            errors += std::pow(anchors[i].x - hall[i].x, 2) + std::pow(anchors[i].y - hall[i].y, 2);
            variances += survey.anchors[i].sd_m * survey.anchors[i].sd_m;
            ++count;
        }
    }
    // The sd is of the worst direction, the error has two.
    EXPECT_GT(errors / count, variances / count * 0.8);
    EXPECT_LT(errors / count, variances / count * 2.0);
}

TEST(SurveyAnchors, pairsMayBeMissingWhileTheRestIsRigid)
{
    std::vector<AnchorPairSnapshot> pairs = allPairs(6);
    drop(pairs, 0, 3);
    drop(pairs, 1, 2);
    drop(pairs, 2, 4);
    drop(pairs, 0, 5);
    const AnchorSurvey survey = surveyAnchors(pairs, hall);
    ASSERT_EQ(survey.trouble, "");
    EXPECT_EQ(survey.anchors.size(), 6U);
    EXPECT_LT(largestError_m(survey), 1e-6);
}

TEST(SurveyAnchors, ofTwoArrangementsTheOneNearerToTheListIsTakenAndNoted)
{
    std::vector<AnchorPairSnapshot> pairs = allPairs(4);
    drop(pairs, 0, 3);
    std::vector<UwbAnchor> list = first(4);
    list[3].x += 0.5; // the list is rough
    const AnchorSurvey survey = surveyAnchors(pairs, list);
    ASSERT_EQ(survey.trouble, "");
    EXPECT_LT(largestError_m(survey, first(4)), 1e-6);
    EXPECT_EQ(survey.notes,
              (std::vector<std::string>{
                  "More than one arrangement fits the ranges and the one nearest to the list was taken: look "
                  "whether it is right, the range between anchors 0 and 3 would tell"}));
}

TEST(SurveyAnchors, anAnchorPlacedLaterTellsOfTwoPlacesTheRightOne)
{
    // Anchor 3 ranges with two of the triangle 0, 1, 2, anchor 4 with two of it and with 3.
    std::vector<UwbAnchor> truth = first(5);
    truth[4].x = -2.0;
    truth[4].y = 4.0;
    std::vector<AnchorPairSnapshot> pairs = allPairs(3, 0.01);
    for (const auto& [i, k] : {std::pair{1U, 3U}, {2U, 3U}, {0U, 4U}, {2U, 4U}, {3U, 4U}})
        pairs.push_back(pairOf(truth[i], truth[k]));
    std::vector<UwbAnchor> list = truth;
    list[3].x = 0.1; // the list is wrong: it has anchor 3 on the other side
    list[3].y = 0.2;
    const AnchorSurvey survey = surveyAnchors(pairs, list);
    ASSERT_EQ(survey.trouble, "");
    EXPECT_LT(largestError_m(survey, truth), 0.1);
    EXPECT_TRUE(survey.notes.empty()) << survey.notes.front();
}

TEST(SurveyAnchors, aNetworkThatOnlyItsLastAnchorMakesRigidIsPlacedRight)
{
    // A row of triangles, each folded out of the one before; the last anchor ranges with the first ones too.
    const std::vector<UwbAnchor> row{{0, "A0", 0.0, 0.0, 2.0, true}, {1, "A1", 1.0, 3.0, 2.0, true},
                                     {2, "A2", 3.0, 0.5, 2.0, true}, {3, "A3", 4.5, 3.5, 2.0, true},
                                     {4, "A4", 6.0, 0.0, 2.0, true}, {5, "A5", 8.0, 3.0, 2.0, true}};
    std::vector<AnchorPairSnapshot> pairs;
    for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t k = i + 1; k < row.size(); ++k)
            if (k - i <= 2)
                pairs.push_back(pairOf(row[i], row[k]));
    std::vector<UwbAnchor> unknown = row;
    for (UwbAnchor& anchor : unknown)
        anchor.x = anchor.y = 0.0;
    EXPECT_EQ(surveyAnchors(pairs, unknown).notes.size(), 1U); // it could be folded anywhere
    for (const auto& [i, k] : {std::pair{0U, 5U}, {0U, 3U}, {1U, 4U}, {2U, 5U}})
        pairs.push_back(pairOf(row[i], row[k]));
    const AnchorSurvey survey = surveyAnchors(pairs, unknown);
    ASSERT_EQ(survey.trouble, "");
    EXPECT_TRUE(survey.notes.empty()) << survey.notes.front();
    EXPECT_LT(largestError_m(survey, row), 1e-6);
}

TEST(SurveyAnchors, anchorsThatCannotBePlacedAreNamed)
{
    std::vector<AnchorPairSnapshot> pairs = allPairs(4);
    pairs.push_back(pairOf(hall[0], hall[4]));
    const AnchorSurvey survey = surveyAnchors(pairs, hall);
    ASSERT_EQ(survey.trouble, "");
    EXPECT_EQ(survey.anchors.size(), 4U);
    EXPECT_EQ(survey.notes,
              (std::vector<std::string>{
                  "Anchor 5 has no ranges to the others and stays where it is",
                  "Anchor 4 has too few ranges to the others to be placed and stays where it is"}));
}

TEST(SurveyAnchors, anchorsThatAreNotInTheListAreNamed)
{
    const AnchorSurvey survey = surveyAnchors(allPairs(5), first(4));
    ASSERT_EQ(survey.trouble, "");
    EXPECT_EQ(survey.anchors.size(), 4U);
    EXPECT_EQ(survey.notes,
              (std::vector<std::string>{"Anchor 4 is not in the list: enter its height to have it placed"}));
}

TEST(SurveyAnchors, aRangeThatDoesNotFitIsNoted)
{
    std::vector<AnchorPairSnapshot> pairs = allPairs(6);
    pairs[1].range_m += 0.8; // 0 and 2
    const AnchorSurvey survey = surveyAnchors(pairs, hall);
    ASSERT_EQ(survey.trouble, "");
    ASSERT_FALSE(survey.notes.empty());
    EXPECT_TRUE(survey.notes[0].starts_with("The range between anchors 0 and 2 is "));
    EXPECT_NE(survey.notes[0].find(" mm too long: look for what stands between them"), std::string::npos);
    EXPECT_GT(survey.residual_m, 0.05);
}

TEST(SurveyAnchors, rangesThatFitNoArrangementAreATrouble)
{
    std::vector<AnchorPairSnapshot> pairs = allPairs(4);
    pairs[2].range_m += 6.0; // 0 and 3
    const AnchorSurvey survey = surveyAnchors(pairs, first(4));
    EXPECT_TRUE(survey.trouble.starts_with("The ranges between the anchors fit no arrangement"));
    EXPECT_TRUE(survey.anchors.empty());
}

TEST(SurveyAnchors, sparseNetworksAreRightWithinTheirSdsOrSayThatTheyCouldBeTwo)
{
    // Six anchors anywhere, a fifth of the pairs missing, the list 0.3 m off.
    int right = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SplitMix64 random(seed);
        std::vector<UwbAnchor> truth;
        for (int id = 0; id < 6; ++id)
            truth.push_back({id, "A", random.uniform(0.0, 10.0), random.uniform(0.0, 8.0),
                             random.uniform(1.0, 3.0), true});
        std::vector<AnchorPairSnapshot> pairs;
        for (std::size_t i = 0; i < truth.size(); ++i)
            for (std::size_t k = i + 1; k < truth.size(); ++k)
                if (random.uniform() > 0.2)
                    pairs.push_back(pairOf(truth[i], truth[k], 0.03 * random.normal()));
        std::vector<UwbAnchor> list = truth;
        for (UwbAnchor& anchor : list)
            anchor.x += 0.3 * random.normal();
        const AnchorSurvey survey = surveyAnchors(pairs, list);
        if (!survey.trouble.empty())
            continue;
        const bool isNoted = std::ranges::any_of(
            survey.notes, [](const std::string& note) { return note.starts_with("More than one"); });
        const double worstSd_m = std::ranges::max(survey.anchors, {}, &SurveyedAnchor::sd_m).sd_m;
        const bool isRight = largestError_m(survey, truth) < 0.1 + 6.0 * worstSd_m;
        EXPECT_TRUE(isNoted || isRight) << seed;
        right += isRight && !isNoted ? 1 : 0;
    }
    EXPECT_GT(right, 30);
}

TEST(SurveyAnchors, withoutRangesThereIsATrouble)
{
    EXPECT_TRUE(surveyAnchors({}, hall).trouble.starts_with("No ranges between the anchors were heard"));
    std::vector<AnchorPairSnapshot> few = allPairs(3);
    for (AnchorPairSnapshot& pair : few)
        pair.count = 4;
    EXPECT_TRUE(surveyAnchors(few, hall).trouble.starts_with("No ranges between the anchors were heard"));
    EXPECT_EQ(surveyAnchors(allPairs(3), {}).trouble,
              "There is no anchor in the list: enter the anchors with their heights first");
    // Anchor 9 alone is in the list.
    EXPECT_TRUE(surveyAnchors(allPairs(3), {{9, "A9", 0.0, 0.0, 2.0, true}})
                    .trouble.starts_with("No ranges between the anchors were heard"));
}

TEST(SurveyAnchors, aChainOfPairsIsTooFew)
{
    const std::vector<AnchorPairSnapshot> chain{pairOf(hall[0], hall[1]), pairOf(hall[1], hall[2]),
                                                pairOf(hall[2], hall[3])};
    const AnchorSurvey survey = surveyAnchors(chain, hall);
    EXPECT_TRUE(survey.trouble.starts_with("Too few pairs of anchors range with each other"));
    EXPECT_TRUE(survey.anchors.empty());
}

TEST(SurveyAnchors, anchorsOnOneLineAreATrouble)
{
    std::vector<UwbAnchor> line = first(3);
    for (UwbAnchor& anchor : line)
        anchor.y = 0.02 * anchor.id;
    line[2].x = 9.0;
    for (const double error_m : {0.0, 0.05, -0.05}) { // the triangle may not even close
        const std::vector<AnchorPairSnapshot> pairs{
            pairOf(line[0], line[1]), pairOf(line[0], line[2], error_m), pairOf(line[1], line[2])};
        EXPECT_TRUE(surveyAnchors(pairs, line).trouble.starts_with("The anchors stand nearly on one line"))
            << error_m;
    }
}

TEST(SurveyAnchors, aRangeShorterThanTheDifferenceOfTheHeightsIsATrouble)
{
    std::vector<AnchorPairSnapshot> pairs = allPairs(3);
    pairs[0].range_m = 0.6;
    EXPECT_EQ(surveyAnchors(pairs, hall).trouble,
              "The range between anchors 0 and 1 (600 mm) is shorter than the difference of their heights "
              "(1000 mm): correct the heights in the list");
}

TEST(SurveyAnchors, theSameRangesGiveTheSameAnswerInAnyOrder)
{
    std::vector<AnchorPairSnapshot> pairs = allPairs(6, 0.05);
    const AnchorSurvey one = surveyAnchors(pairs, hall);
    std::ranges::reverse(pairs);
    const AnchorSurvey other = surveyAnchors(pairs, hall);
    EXPECT_EQ(one, other);
}

} // namespace
} // namespace agv::estimation
