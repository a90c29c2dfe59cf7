// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/ids.h"
#include "core/range_measurement.h"
#include "core/robot_status.h"
#include "core/snapshot.h"
#include "core/tag_read.h"
#include "core/tracked_pose.h"
#include "core/uwb_snapshot.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace agv::recording {

// What a run holds, one struct for each kind of row. Times are of the monotonic clock and SI units hold, as
// everywhere inside; docs/manual/runs.md has the columns.

/// Bytes of a link exactly as one read or write gave them.
struct RunChunk {
    Time time;
    std::string link; ///< "reader 1", "robot 1", "robot 1 sent", "telemetry 1", "uwb"
    std::string bytes;
    friend bool operator==(const RunChunk&, const RunChunk&) = default;
};

/// A complete read of a floor tag.
struct TagReadRow {
    RobotId agv;
    TagRead read;
};

/// A range as a UWB unit reported it, and what the track of the tag made of it.
struct RangeRow {
    Time arrival;
    RangeMeasurement range;           ///< as measured, not corrected
    std::optional<double> residual_m; ///< corrected range minus expected; empty: no position then
    bool rejected = false;            ///< held for obstructed
};

/// Position of a UWB tag after a report.
struct TagPositionRow {
    Time arrival;            ///< of the report
    double measured_s = 0.0; ///< when the ranges were measured and the tag stood there, as RangeMeasurement
    int tag = 0;
    Point2 position;
    PositionCovariance covariance;
};

/// The pose of an AGV as the console followed it.
struct PoseRow {
    Time time;
    RobotId agv;
    Pose2 pose;
    PoseCovariance covariance{};
    PoseHealth health = PoseHealth::None;
};

/// Wheel speeds that the console told a robot.
struct WheelCommandRow {
    Time time;
    RobotId agv;
    WheelSpeeds speeds;
};

struct RobotStateRow {
    Time time;
    RobotId agv;
    RobotState state = RobotState::Idle;
};

struct BatteryRow {
    Time time;
    RobotId agv;
    BatteryStatus battery;
};

/// An initialisation turn went on.
struct TurnStepRow {
    Time time;
    RobotId agv;
    TurnPhase phase = TurnPhase::Idle;
    int stop = 0; ///< 1-based
};

/// What an initialisation turn found.
struct TurnResultRow {
    Time time;
    RobotId agv;
    TurnPhase phase = TurnPhase::Finished; ///< or Aborted, Failed
    std::optional<Pose2> pose;             ///< where the AGV stands now; empty: none was found
    PoseCovariance covariance{};
    std::string note; ///< why there is no pose, or the solver's word; plain English
};

/// A line of the event log.
struct EventRow {
    Time time;
    EventEntry event;
};

/// Something the operator asked for.
struct OperatorActionRow {
    Time time;
    std::string action;         ///< "start turn", "stop all", ...
    std::optional<RobotId> agv; ///< empty: the plant
    std::string detail;         ///< its parameters; may be empty
};

using RunRow = std::variant<TagReadRow, RangeRow, TagPositionRow, PoseRow, WheelCommandRow, RobotStateRow,
                            BatteryRow, TurnStepRow, TurnResultRow, EventRow, OperatorActionRow>;

/// The two clocks at one moment.
struct ClockPair {
    Time time;
    std::int64_t utc_us = 0; ///< microseconds since 1970, UTC
};

/// What happened since the last batch; written as a whole or not at all.
struct RunBatch {
    ClockPair clocks; ///< when the batch was handed over
    std::vector<RunChunk> chunks;
    std::vector<RunRow> rows;

    bool empty() const { return chunks.empty() && rows.empty(); }
    /// Estimate of the memory it holds.
    std::size_t bytes = 0;
};

} // namespace agv::recording
