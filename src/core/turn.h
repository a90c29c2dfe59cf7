// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tag_read.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace agv {

/// Which way the robot turns, seen from above.
enum class Rotation { CounterClockwise, Clockwise };

/// +1 counter-clockwise, -1 clockwise.
constexpr int signOf(Rotation rotation) { return rotation == Rotation::CounterClockwise ? 1 : -1; }

/// How the robot knows that a step is done: after a time, or from its wheel encoders.
enum class TurnKind { Timed, Measured };

enum class SolveMethod { Auto, Fast, Classic };

// What a sleeptime (time of a 45 degree turn), a wheel speed while turning (m/s) and the time at a stop may
// be: one range each for the plant file, the procedure, the command line and the window. The greatest speed
// is the manual reduced speed of ISO 10218-1.
inline constexpr int leastSleeptime_ms = 100;
inline constexpr int mostSleeptime_ms = 10'000;
inline constexpr double leastTurnSpeed = 0.010;
inline constexpr double mostTurnSpeed = 0.250;
inline constexpr double leastDwell_s = 0.05;
inline constexpr double mostDwell_s = 10.0;

/// What the operator sets before a turn. SI; the ranges are those above and of procedure::validate().
struct TurnParameters {
    TurnKind kind = TurnKind::Timed;
    Rotation rotation = Rotation::CounterClockwise;
    int stopsPerTurn = 8;      ///< 8, 12 or 16; a closing reading is added
    double turnTime_s = 1.125; ///< sleeptime: time of a 45 degree turn; scaled for other steps
    double wheelSpeed_m_s = 0.100;
    double settle_s = 0.2;     ///< standing still before reads count
    double minDwell_s = 0.3;   ///< a stop is left no earlier ...
    double maxDwell_s = 2.0;   ///< ... and no later
    bool adaptiveDwell = true; ///< false: always maxDwell_s
    friend bool operator==(const TurnParameters&, const TurnParameters&) = default;
};

/// What is known of one stop of an initialisation turn.
struct TurnStop {
    std::vector<TagRead> reads;          ///< complete reads while standing, in order of time
    std::vector<TagRead> movingReads;    ///< reads that arrived while turning: kept, not used
    std::vector<TagUid> unknownIfUnseen; ///< tags whose absence means nothing (old recordings lose some)
};

/// One initialisation turn as recorded: the input of every solver. Stops in order of time; stop k stands
/// k steps after stop 0. A turn of 8 stops of 45 degrees usually carries a closing 9th reading.
struct TurnRecord {
    std::vector<TurnStop> stops;
    double nominalStep = 0.0;         ///< rad, positive; what the turn aimed at
    std::optional<Rotation> rotation; ///< as commanded; empty: unknown, the solver finds out
    std::optional<double> turnTime_s; ///< sleeptime of a timed turn; empty: unknown or measured turn
    TurnKind kind = TurnKind::Timed;
};

/// Why a result must not be trusted blindly. An empty list means: trust it within its uncertainty.
enum class TurnFlag {
    Weak,          ///< the uncertainty is too large for driving
    Ambiguous,     ///< a second pose explains the reads nearly as well
    FewReads,      ///< fewer reads than a turn needs
    WrongRotation, ///< the robot turned against the commanded direction
    UnevenSteps,   ///< the steps differ more than a healthy robot's
    PoorFit,       ///< the reads contradict the map or the RSSI table
    NoReads,       ///< nothing to work with; there is no pose
    NotConverged,  ///< the search ran out of its budget
};

/// Short stable word for files: "weak", "ambiguous", ...
const char* toText(TurnFlag flag);
const char* toText(SolveMethod method);
const char* toText(Rotation rotation);

/// How one stop fits the result.
struct StopReport {
    Point2 antenna;              ///< where the antenna stood, m
    double antennaBearing = 0.0; ///< rad, centre to antenna
    double antennaSd_m = 0.0;
    std::vector<TagUid> seen;      ///< read and expected or possible there
    std::vector<TagUid> expected;  ///< should have been read with more than even odds
    std::vector<TagUid> missed;    ///< expected, not read
    std::vector<TagUid> unknown;   ///< read, but not in the plant file
    std::vector<TagUid> misplaced; ///< read, in the plant file, but far from here
};

/// A second explanation of the reads.
struct AlternativePose {
    Pose2 pose;
    double logOdds = 0.0; ///< log of how much less likely it is than the result; >= 0
};

/// The answer of a solver. The robot turns on the spot, so both poses nearly share the centre: `startPose`
/// has the heading at stop 0 (what recordings are compared with), `pose` the one at the last stop (where the
/// robot stands now).
struct TurnEstimate {
    bool valid = false; ///< false: no pose; `status` says why
    std::string status; ///< one word: "ok", "no_reads", "cancelled", or a classic solver's failure
    SolveMethod method = SolveMethod::Auto;
    Pose2 startPose; ///< at stop 0
    Pose2 pose;      ///< now: at the last stop
    PoseCovariance
        covariance{}; ///< of `startPose`; includes what one turn cannot see (lateral antenna offset)
    double lastHeadingSd = 0.0; ///< rad, of pose.heading
    double radius_m = 0.0;      ///< antenna to centre of rotation, estimated
    Rotation rotation = Rotation::CounterClockwise;
    double rotationLogOdds = 0.0; ///< evidence for `rotation` against the other one
    double step = 0.0;            ///< rad, positive: mean angle of a step
    double stepSd = 0.0;
    std::optional<double> suggestedTurnTime_s; ///< turnTime * nominalStep / step (timed turns)
    double suggestedTurnTimeSd_s = 0.0;
    std::string profile; ///< noise profile chosen by evidence
    double logEvidence = 0.0;
    std::vector<TurnFlag> flags;
    std::optional<AlternativePose> alternative;
    std::vector<StopReport> stops;
    double elapsed_s = 0.0; ///< computing time
};

} // namespace agv
