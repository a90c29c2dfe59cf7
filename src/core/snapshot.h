// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarm.h"
#include "core/jog.h"
#include "core/link_snapshot.h"
#include "core/plant_layout.h"
#include "core/recording_snapshot.h"
#include "core/robot_status.h"
#include "core/tracked_pose.h"
#include "core/turn.h"
#include "core/uwb_snapshot.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace agv {

/// Phases of the initialisation turn as the operator sees them.
enum class TurnPhase { Idle, Settling, Reading, Turning, Solving, Finished, Aborted, Failed };

/// One row of the operator's table of stops.
struct StopRow {
    int stop = 0;                             ///< 1-based
    std::vector<std::pair<TagUid, int>> tags; ///< tag and its (most frequent) RSSI, in order of first read
    int reads = 0;
    bool done = false;
    friend bool operator==(const StopRow&, const StopRow&) = default;
};

struct TurnSnapshot {
    TurnPhase phase = TurnPhase::Idle;
    int stop = 0;                ///< 1-based number of the current stop
    int stopCount = 0;           ///< readings in all, the closing one included
    double wheelSpeed_m_s = 0.1; ///< while turning
    double progress = 0.0;       ///< 0..1
    double timeLeft_s = 0.0;     ///< expected
    std::string message;         ///< why it was aborted or failed; plain English
    std::vector<StopRow> table;
    std::shared_ptr<const TurnEstimate> preview; ///< after each stop from the third on; null before
    std::shared_ptr<const TurnEstimate> result;  ///< null until solved
    friend bool operator==(const TurnSnapshot&, const TurnSnapshot&) = default;
};

struct AgvSnapshot {
    RobotId id;
    std::string name;
    LinkSnapshot readerLink;
    LinkSnapshot robotLink;
    std::optional<BatteryStatus> battery;
    std::optional<RobotState> robotState;
    WheelSpeeds commanded;    ///< last wheel speeds sent
    bool mayBeMoving = false; ///< connection lost while the last command was not zero
    JogSnapshot jog;
    double turnTime_s = 1.125;  ///< sleeptime in use
    double turnSpeed_m_s = 0.1; ///< wheel speed of the next turn; the sleeptime is for this one
    std::optional<Pose2> pose;  ///< of now; empty before the first turn
    PoseCovariance covariance{};
    PoseHealth poseHealth = PoseHealth::None;
    std::string poseNote;             ///< why the pose is predicted or doubted, and what to do; plain English
    std::vector<TagRead> recentReads; ///< last second
    TurnSnapshot turn;
};

/// Everything the screen shows, one coherent value; made by the session, 30 times a second at most.
struct PlantSnapshot {
    Time time;
    std::vector<AgvSnapshot> agvs;
    std::optional<UwbSnapshot> uwb; ///< empty: the plant has no UWB anchors
    RecordingSnapshot recording;
    std::vector<std::string> refusedPeers; ///< addresses that tried to connect and are not in the plant file
    std::string listening;                 ///< "127.0.0.1:2001 (TCP), 2000 (UDP)" or why not
    std::vector<AlarmSnapshot> alarms;     ///< by weight, then the newest first
    bool alarmFlood = false;               ///< so many came that those of low priority wait
    bool simulated = false;
};

/// In order of weight.
enum class EventLevel {
    Detail, ///< what follows from the console's own commands; the window shows it on demand
    Info,
    Warning,
    Error,
};

/// One line of the event log.
struct EventEntry {
    std::int64_t utc_ms = 0; ///< wall clock
    EventLevel level = EventLevel::Info;
    std::string source; ///< "AGV 1", "RFID reader 2", "Console"
    std::string text;
};

} // namespace agv
