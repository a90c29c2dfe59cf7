// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/error_metrics.h"
#include "estimation/turn_scenarios.h"

#include <gtest/gtest.h>

namespace agv::estimation::testing {
namespace {

constexpr int kTurns = 32; ///< per scenario; bench_turn_solver runs all of them and any number of others

/// Bounds of the study's section D for 100 turns, position in mm, angles in degrees. The quantile of 32
/// turns is their second largest error, so it is compared with 1.3 times the bound.
struct Goal {
    const char* scenario;
    double meanPosition, p95Position, meanHeading, p95Heading, stepRms;
};

std::ostream& operator<<(std::ostream& out, const Goal& goal) { return out << goal.scenario; }

class SolverAccuracy : public ::testing::TestWithParam<Goal> {};

TEST_P(SolverAccuracy, MeetsTheGoalsOfTheStudyAndKnowsItsUncertainty)
{
    const Goal& goal = GetParam();
    const TurnScenario scenario = studyScenario(goal.scenario);
    const TurnContext context = contextOf(scenario);
    const bool veryWrongTable = std::string(goal.scenario).starts_with("A9");
    ErrorSample position, heading, step, sd;
    int hits = 0;
    for (int i = 0; i < kTurns; ++i) {
        const SimulatedTurn turn = studyTurn(scenario, i);
        const TurnEstimate estimate = solveTurn(turn.record, context);
        ASSERT_TRUE(estimate.valid) << estimate.status;
        EXPECT_EQ(signOf(estimate.rotation), turn.truth.step > 0.0 ? 1 : -1) << "turn " << i;
        const PoseError error = errorOf(estimate.startPose, turn.truth.startPose);
        position.add(mmFromMetres(error.position_m));
        heading.add(degFromRad(error.heading));
        step.add(degFromRad(estimate.step - std::abs(turn.truth.step)));
        sd.add(mmFromMetres(std::sqrt(estimate.covariance[0] + estimate.covariance[4])));
        hits += normalisedPositionError2(estimate.startPose, estimate.covariance, turn.truth.startPose) <
                kChiSquared2At95;
        if (error.position_m > 0.020 || std::abs(degFromRad(error.heading)) > 15.0) {
            EXPECT_TRUE(veryWrongTable || !estimate.flags.empty())
                << "turn " << i << " is wrong and not flagged";
        }
    }
    EXPECT_LE(position.mean(), goal.meanPosition);
    EXPECT_LE(position.quantile(0.95), 1.3 * goal.p95Position);
    EXPECT_LE(heading.mean(), goal.meanHeading);
    EXPECT_LE(heading.quantile(0.95), 1.3 * goal.p95Heading);
    EXPECT_LE(step.rms(), 1.2 * goal.stepRms);
    EXPECT_GE(hits, veryWrongTable ? 23 : 27); // of 32; 0.80 and 0.88 of many
    EXPECT_LE(sd.mean(), 3.0 * position.rms());
}

INSTANTIATE_TEST_SUITE_P(Study, SolverAccuracy,
                         ::testing::Values(Goal{"A0_clean", 1.0, 2.0, 0.8, 1.8, 0.30},
                                           Goal{"A1_noise_miss10", 1.9, 4.0, 1.4, 3.5, 0.5},
                                           Goal{"A2_noise_miss30", 3.0, 6.5, 2.3, 6.0, 0.8},
                                           Goal{"A3_step5", 1.0, 2.0, 0.8, 1.8, 0.30},
                                           Goal{"A4_step20", 1.0, 2.0, 0.8, 1.8, 0.30},
                                           Goal{"A5_step10_jit1_noise_miss10", 2.2, 5.0, 1.6, 4.0, 0.7},
                                           Goal{"A6_offset_tags", 2.4, 5.2, 2.1, 5.0, 0.5},
                                           Goal{"A7_all", 3.3, 7.0, 2.3, 6.0, 0.95},
                                           Goal{"A8_table_wrong", 3.3, 6.5, 2.5, 6.5, 0.9},
                                           Goal{"A9_table_very_wrong", 6.5, 15.0, 5.0, 16.0, 2.0},
                                           Goal{"B0_3x3_clean", 1.0, 2.0, 0.8, 1.8, 0.30},
                                           Goal{"B1_3x3_noise_miss10", 3.0, 7.0, 2.1, 6.0, 0.7},
                                           Goal{"B5_3x3_step10", 3.1, 6.0, 2.1, 5.2, 0.8},
                                           Goal{"B7_3x3_all", 3.6, 7.5, 2.8, 7.0, 1.15}),
                         [](const auto& goal) { return std::string(goal.param.scenario); });

} // namespace
} // namespace agv::estimation::testing
