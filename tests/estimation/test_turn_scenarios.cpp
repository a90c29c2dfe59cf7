// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/turn_scenarios.h"

#include <gtest/gtest.h>

namespace agv::estimation::testing {
namespace {

class EveryScenario : public ::testing::TestWithParam<TurnScenario> {};

/// The generator makes other turns of the same kind, so it must be the study's generator exactly.
TEST_P(EveryScenario, GeneratesTheTurnsOfItsFile)
{
    const auto turns = loadTurns(std::string(AGV_TEST_DATA "/vectors/rfid_") + GetParam().name + ".jsonl");
    ASSERT_EQ(turns.size(), 100u);
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const SimulatedTurn made = studyTurn(GetParam(), static_cast<int>(i));
        EXPECT_NEAR(made.truth.startPose.position.x, turns[i].truth.startPose.position.x, 1e-12);
        EXPECT_NEAR(made.truth.startPose.position.y, turns[i].truth.startPose.position.y, 1e-12);
        EXPECT_NEAR(wrapAngle(made.truth.startPose.heading - turns[i].truth.startPose.heading), 0.0, 1e-12);
        EXPECT_NEAR(made.truth.step, turns[i].truth.step, 1e-12);
        ASSERT_EQ(made.record.stops.size(), turns[i].record.stops.size());
        for (std::size_t k = 0; k < made.record.stops.size(); ++k)
            EXPECT_EQ(made.record.stops[k].reads, turns[i].record.stops[k].reads)
                << "turn " << i << " stop " << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Study, EveryScenario,
                         ::testing::ValuesIn(studyScenarios().begin(), studyScenarios().end()),
                         [](const auto& scenario) { return std::string(scenario.param.name); });

} // namespace
} // namespace agv::estimation::testing
