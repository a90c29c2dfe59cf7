// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "estimation/turn_solver.h"

#include <span>
#include <string>
#include <vector>

namespace agv::estimation::testing {

/// Disturbances of one scenario of initialisation turns (study, section A.1). Millimetres and degrees as
/// in the study; zero switches a disturbance off and draws no random numbers for it.
struct TurnScenario {
    const char* name = "";
    int tagsPerSide = 11;    ///< field of tags at 100 mm pitch, first tag at the origin
    double offByOne = 0.0;   ///< probability of RSSI +-1
    double missed = 0.0;     ///< probability that a tag in range is not read
    double stepError = 0.0;  ///< true step = nominal * (1 + uniform(+-this))
    double jitter_deg = 0.0; ///< sd of single steps
    double antenna_mm = 0.0; ///< sd of the radial and of the lateral antenna offset
    double tag_mm = 0.0;     ///< sd of the tag positions, per axis
    double stale = 0.0;      ///< probability that a tag of the previous stop is reported again
    double tableScale = 0.0; ///< sd of the relative error of the whole RSSI table
    double edge_mm = 0.0;    ///< sd of each edge of the RSSI table
    int stops = 8;
    double nominalStep_deg = 45.0;
    int direction = 1; ///< +1 counter-clockwise
};

/// The fourteen scenarios of the study, in its order (their trials are seeded by it).
std::span<const TurnScenario> studyScenarios();
/// Throws std::out_of_range for an unknown name.
const TurnScenario& studyScenario(const std::string& name);

struct TurnTruth {
    Pose2 startPose;
    double bearing = 0.0; ///< rad, centre to antenna at stop 0
    double lastBearing = 0.0;
    double step = 0.0; ///< rad, signed
};

struct SimulatedTurn {
    TurnRecord record; ///< rotation unknown, no turn time
    TurnTruth truth;
};

/// Tag numbers are their UIDs.
TurnContext contextOf(const TurnScenario& scenario);

/// One turn; the same random numbers in the same order as the study's generator.
SimulatedTurn simulateTurn(const TurnScenario& scenario, SplitMix64& random);

/// Trial `index` of a study scenario, as in rfid_<name>.jsonl.
SimulatedTurn studyTurn(const TurnScenario& scenario, int index);

/// The turns of rfid_<name>.jsonl in the test data.
std::vector<SimulatedTurn> loadTurns(const std::string& path);

/// A record from rows of (tag number, RSSI).
TurnRecord recordOf(const std::vector<std::vector<std::pair<int, int>>>& rows, double nominalStep_deg);

} // namespace agv::estimation::testing
