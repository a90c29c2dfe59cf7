// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedure/initialisation_turn.h"
#include "protocol/reader_stream.h"
#include "simulation/plant.h"

namespace agv::simulation {

/// An initialisation turn driven over a simulated plant in virtual time, bytes on the wire and all.
struct VirtualTurn {
    TurnPhase end = TurnPhase::Idle; ///< Finished, or why not
    std::string message;
    TurnRecord record;
    RobotTruth first; ///< when the turn started
    RobotTruth last;  ///< when it ended
    double duration_s = 0.0;
    double meanStep = 0.0; ///< rad, positive: true turn per step
    std::uint32_t nextSegment = 0;
};

/// The robot must be idle; afterwards it is again.
VirtualTurn driveTurn(Plant& plant, RobotId robot, const TurnParameters& parameters,
                      std::uint32_t firstSegment = 0);

} // namespace agv::simulation
