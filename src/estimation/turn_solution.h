// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/turn_evidence.h"

#include <string>
#include <vector>

namespace agv::estimation {

/// A mode of the posterior: local frame of the evidence.
struct SolutionMode {
    Point2 centre;
    double bearing = 0.0; ///< rad, centre to antenna at stop 0
    double logOdds = 0.0; ///< how much less likely than the solution, >= 0
};

/// What `fast` and `auto` find, in the local frame of the evidence; toEstimate() makes the answer of it.
struct TurnSolution {
    Point2 centre;               ///< at stop 0, m
    Point2 drift;                ///< of the centre until the last stop, m
    PoseCovariance covariance{}; ///< of centre x, y and the bearing at stop 0; wide enough for the last stop
    double radius_m = 0.0;
    std::vector<double> bearings;    ///< rad, centre to antenna, per stop
    std::vector<double> antennaSd_m; ///< per axis, per stop
    double lastBearingSd = 0.0;      ///< rad
    double unevenness = 0.0;         ///< rad: sd of the steps around their mean
    Rotation rotation = Rotation::CounterClockwise;
    double rotationLogOdds = 0.0;
    double step = 0.0; ///< rad, positive
    double stepSd = 0.0;
    double tableScale = 1.0; ///< true distances / distances of the RSSI table
    NoiseModel noise;        ///< that describes the reader
    std::string profile;
    double logEvidence = 0.0;
    bool converged = true;
    bool split = false; ///< the posterior falls into parts
    std::optional<SolutionMode> alternative;

    /// Antenna position at a stop, local frame.
    Point2 antennaAt(std::size_t stop) const;
};

/// Fills in poses, covariance, flags, time suggestion and the reports of the stops.
TurnEstimate toEstimate(const TurnSolution& solution, const TurnEvidence& evidence, const TurnRecord& record,
                        const TurnContext& context);

/// An answer without a pose.
TurnEstimate noPose(SolveMethod method, std::string status, std::size_t stops);

} // namespace agv::estimation
