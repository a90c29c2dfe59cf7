// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verdict_text.h"

#include "core/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace agv::app {
namespace {

TurnSnapshot solvedTurn()
{
    auto estimate = std::make_shared<TurnEstimate>();
    estimate->valid = true;
    estimate->status = "ok";
    estimate->pose = {{1.2041, 0.8729}, radFromDeg(92.2)};
    estimate->covariance = {1e-6, 0, 0, 0, 0.25e-6, 0, 0, 0, 1e-4};
    estimate->lastHeadingSd = radFromDeg(1.0);
    estimate->suggestedTurnTime_s = 1.1803;
    estimate->suggestedTurnTimeSd_s = 0.003;
    TurnSnapshot turn;
    turn.phase = TurnPhase::Finished;
    turn.result = estimate;
    return turn;
}

TEST(VerdictText, SaysPoseUncertaintyAndSleeptime)
{
    EXPECT_EQ(verdictText("AGV 1", solvedTurn()),
              "AGV 1 stands at 1,204 mm, 873 mm, facing 92 degrees; plus or minus 3 mm, 2 degrees. Suggested "
              "sleeptime: 1,180 ms, plus or minus 6 ms.");
}

TEST(VerdictText, SaysWhatToMind)
{
    TurnSnapshot turn = solvedTurn();
    auto estimate = std::make_shared<TurnEstimate>(*turn.result);
    estimate->flags = {TurnFlag::Ambiguous, TurnFlag::FewReads};
    turn.result = estimate;
    EXPECT_NE(verdictText("AGV 1", turn)
                  .find("Mind: a second pose explains the reads nearly as well; there were "
                        "few reads."),
              std::string::npos);
}

TEST(VerdictText, SaysWhyThereIsNoPose)
{
    TurnSnapshot turn;
    turn.phase = TurnPhase::Failed;
    turn.message = "The link to the robot was lost";
    EXPECT_EQ(verdictText("AGV 2", turn), "AGV 2: no pose. The link to the robot was lost.");
    turn = solvedTurn();
    auto estimate = std::make_shared<TurnEstimate>();
    estimate->status = "no_reads";
    estimate->flags = {TurnFlag::NoReads};
    turn.result = estimate;
    EXPECT_EQ(
        verdictText("AGV 2", turn),
        "AGV 2: no pose (no_reads). Mind: no floor tag was read. Check that the AGV stands on floor tags and "
        "read it again.");
}

TEST(VerdictText, PartsThousandsWithCommas)
{
    EXPECT_EQ(thousands(0.0), "0");
    EXPECT_EQ(thousands(-0.4), "0");
    EXPECT_EQ(thousands(999.6), "1,000");
    EXPECT_EQ(thousands(-1234567.0), "-1,234,567");
    EXPECT_EQ(thousands(-123.0), "-123");
}

TEST(VerdictText, TheUncertaintyIsThe95PercentEllipse)
{
    const Uncertainty uncertainty = uncertaintyOf(*solvedTurn().result);
    EXPECT_NEAR(uncertainty.position_m, 0.001 * std::sqrt(5.991), 1e-9);
    EXPECT_NEAR(uncertainty.heading, radFromDeg(1.96), 1e-9);
}

} // namespace
} // namespace agv::app
