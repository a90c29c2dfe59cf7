// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/units.h"
#include "model/survey_placement.h"

#include <cmath>

namespace agv::model {
namespace {

AnchorSurvey rectangle()
{
    AnchorSurvey survey;
    survey.anchors = {{0, {0.0, 0.0}, 0.01}, {1, {3.0, 0.0}, 0.01}, {2, {3.0, 4.0}, 0.01}};
    return survey;
}

std::vector<UwbAnchor> listed()
{
    return {{0, "A0", 1.0, 2.0, 2.0, true}, {1, "A1", 1.0, 5.0, 2.0, true}, {2, "A2", -3.0, 5.0, 2.0, true}};
}

void expectAt(const UwbAnchor& anchor, double x, double y)
{
    EXPECT_NEAR(anchor.x, x, 1e-9) << anchor.label;
    EXPECT_NEAR(anchor.y, y, 1e-9) << anchor.label;
}

std::vector<UwbAnchor> places(const SurveyPlacement& placement)
{
    return placed(rectangle(), frameOf(rectangle(), listed(), placement), listed());
}

TEST(SurveyPlacement, ByDefaultTheSurveyLiesOnTheList)
{
    const std::vector<UwbAnchor> anchors = places({});
    for (std::size_t i = 0; i < anchors.size(); ++i)
        expectAt(anchors[i], listed()[i].x, listed()[i].y);
}

TEST(SurveyPlacement, TheOriginAnchorLiesAtZeroAndTheNextOneOnPlusX)
{
    const std::vector<UwbAnchor> first = places({.originAnchor = 0, .flipped = false, .rotation = 0.0});
    expectAt(first[0], 0.0, 0.0);
    expectAt(first[1], 3.0, 0.0);
    expectAt(first[2], 3.0, 4.0);
    const std::vector<UwbAnchor> second = places({.originAnchor = 1, .flipped = false, .rotation = 0.0});
    expectAt(second[1], 0.0, 0.0);
    expectAt(second[2], 4.0, 0.0);
    expectAt(second[0], 0.0, 3.0);
}

TEST(SurveyPlacement, AFlipExchangesEastAndWestAboutTheOriginAnchor)
{
    const std::vector<UwbAnchor> anchors = places({.originAnchor = 0, .flipped = true, .rotation = 0.0});
    expectAt(anchors[0], 0.0, 0.0);
    expectAt(anchors[1], -3.0, 0.0);
    expectAt(anchors[2], -3.0, 4.0);
}

TEST(SurveyPlacement, AFlipOfTheClosestFrameKeepsTheMeanAndTheRows)
{
    const std::vector<UwbAnchor> anchors = places({.originAnchor = {}, .flipped = true, .rotation = 0.0});
    const double mean = -1.0 / 3.0;
    for (std::size_t i = 0; i < anchors.size(); ++i)
        expectAt(anchors[i], 2.0 * mean - listed()[i].x, listed()[i].y);
}

TEST(SurveyPlacement, ARotationIsCounterClockwiseAboutTheOriginAnchor)
{
    const std::vector<UwbAnchor> anchors =
        places({.originAnchor = 0, .flipped = false, .rotation = radFromDeg(90.0)});
    expectAt(anchors[0], 0.0, 0.0);
    expectAt(anchors[1], 0.0, 3.0);
    expectAt(anchors[2], -4.0, 3.0);
}

TEST(SurveyPlacement, ARotationAfterAFlipIsStillCounterClockwise)
{
    const std::vector<UwbAnchor> anchors =
        places({.originAnchor = 0, .flipped = true, .rotation = radFromDeg(90.0)});
    expectAt(anchors[1], 0.0, -3.0);
    expectAt(anchors[2], -4.0, -3.0);
}

TEST(SurveyPlacement, AnUnknownOriginAnchorLeavesTheSurveysOwnFrame)
{
    const SurveyFrame frame =
        frameOf(rectangle(), listed(), {.originAnchor = 9, .flipped = false, .rotation = 0.0});
    EXPECT_EQ(frame, SurveyFrame{});
}

TEST(SurveyPlacement, AnEmptySurveyHasAFrameWithoutNans)
{
    const SurveyFrame frame = frameOf({}, listed(), {.originAnchor = {}, .flipped = true, .rotation = 1.0});
    EXPECT_TRUE(std::isfinite(frame.origin.x) && std::isfinite(frame.origin.y) && std::isfinite(frame.angle));
}

} // namespace
} // namespace agv::model
