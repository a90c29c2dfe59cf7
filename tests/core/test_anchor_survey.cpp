// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anchor_survey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace agv {
namespace {

constexpr double exact = 1e-12;

const std::vector<UwbAnchor> listedAnchors{
    {0, "A0", 1.0, 2.0, 2.0, true}, {1, "A1", 1.0, 6.0, 2.1, true}, {2, "A2", -2.0, 2.0, 2.2, false}};

/// The anchors of the list in the survey's own frame: turned by 90 degrees, not mirrored.
AnchorSurvey surveyOfTheList()
{
    AnchorSurvey survey;
    survey.anchors = {{0, {0.0, 0.0}, 0.0}, {1, {4.0, 0.0}, 0.0}, {2, {0.0, 3.0}, 0.0}};
    return survey;
}

void expectAt(const UwbAnchor& anchor, double x, double y)
{
    EXPECT_NEAR(anchor.x, x, exact) << anchor.label;
    EXPECT_NEAR(anchor.y, y, exact) << anchor.label;
}

TEST(AnchorSurveyFrame, liesOnTheAnchorsOfTheList)
{
    const SurveyFrame frame = closestFrame(surveyOfTheList(), listedAnchors);
    EXPECT_NEAR(frame.origin.x, 1.0, exact);
    EXPECT_NEAR(frame.origin.y, 2.0, exact);
    EXPECT_NEAR(frame.angle, std::numbers::pi / 2, exact);
    EXPECT_FALSE(frame.mirrored);
    const auto anchors = placed(surveyOfTheList(), frame, listedAnchors);
    for (std::size_t i = 0; i < anchors.size(); ++i)
        expectAt(anchors[i], listedAnchors[i].x, listedAnchors[i].y);
}

TEST(AnchorSurveyFrame, isMirroredWhenTheThirdAnchorLiesToTheRight)
{
    std::vector<UwbAnchor> anchors = listedAnchors;
    anchors[2].x = 4.0;
    const SurveyFrame frame = closestFrame(surveyOfTheList(), anchors);
    EXPECT_TRUE(frame.mirrored);
    expectAt(placed(surveyOfTheList(), frame, anchors)[2], 4.0, 2.0);
}

TEST(AnchorSurveyFrame, keepsTheScaleOfTheSurvey)
{
    AnchorSurvey survey = surveyOfTheList();
    for (SurveyedAnchor& anchor : survey.anchors)
        anchor.position = 0.9 * anchor.position;
    const auto anchors = placed(survey, closestFrame(survey, listedAnchors), listedAnchors);
    EXPECT_NEAR(distance(Point2{anchors[0].x, anchors[0].y}, Point2{anchors[1].x, anchors[1].y}), 3.6, exact);
    // The mean stays where it was.
    EXPECT_NEAR(anchors[0].x + anchors[1].x + anchors[2].x, 0.0, exact);
    EXPECT_NEAR(anchors[0].y + anchors[1].y + anchors[2].y, 10.0, exact);
}

TEST(AnchorSurveyFrame, isTheOneWithTheLeastSumOfSquares)
{
    AnchorSurvey survey = surveyOfTheList();
    survey.anchors[1].position = {4.3, 0.4};
    survey.anchors[2].position = {-0.2, 2.7};
    const SurveyFrame best = closestFrame(survey, listedAnchors);
    const auto misfit = [&](const SurveyFrame& frame) {
        const auto anchors = placed(survey, frame, listedAnchors);
        double sum = 0.0;
        for (std::size_t i = 0; i < anchors.size(); ++i)
            sum += std::pow(anchors[i].x - listedAnchors[i].x, 2) +
                   std::pow(anchors[i].y - listedAnchors[i].y, 2);
        return sum;
    };
    for (const double step : {-1e-3, 1e-3}) {
        EXPECT_GT(misfit({best.origin + Point2{step, 0.0}, best.angle, false}), misfit(best));
        EXPECT_GT(misfit({best.origin + Point2{0.0, step}, best.angle, false}), misfit(best));
        EXPECT_GT(misfit({best.origin, best.angle + step, false}), misfit(best));
    }
}

TEST(AnchorSurveyFrame, isTheSurveysOwnWithFewerThanTwoAnchorsInCommon)
{
    EXPECT_EQ(closestFrame(surveyOfTheList(), {}), SurveyFrame{});
    EXPECT_EQ(closestFrame(surveyOfTheList(), {listedAnchors[1]}), SurveyFrame{});
    EXPECT_EQ(closestFrame({}, listedAnchors), SurveyFrame{});
}

TEST(PlacedAnchors, movesTheSurveyedOnesAndLeavesTheRest)
{
    std::vector<UwbAnchor> anchors = listedAnchors;
    anchors.push_back({9, "A9", 7.0, 8.0, 1.0, true});
    const SurveyFrame frame{{10.0, 20.0}, std::numbers::pi, true};
    const auto moved = placed(surveyOfTheList(), frame, anchors);
    ASSERT_EQ(moved.size(), 4U);
    expectAt(moved[0], 10.0, 20.0);
    expectAt(moved[1], 6.0, 20.0);
    expectAt(moved[2], 10.0, 23.0);
    EXPECT_EQ(moved[3], anchors[3]);
    EXPECT_EQ(moved[2].z, 2.2); // heights, labels and what is shown are not surveyed
    EXPECT_EQ(moved[2].label, "A2");
    EXPECT_FALSE(moved[2].shown);
}

} // namespace
} // namespace agv
