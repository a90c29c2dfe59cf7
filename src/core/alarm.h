// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace agv {

/// What an operator has to act on; everything else is an event of the log.
enum class AlarmKind : std::uint8_t {
    MayBeMoving,  ///< connection lost while the wheels were turning
    RobotError,   ///< the robot reports its error state
    NotListening, ///< no robot can connect
    RobotLink,    ///< a robot that was connected is not
    ReaderLink,   ///< an RFID reader that was connected is not
    UwbLink,      ///< the UWB unit that was connected is not
    PoseDoubted,  ///< what is measured contradicts the pose
    BatteryLow,
    AnchorMoved,   ///< a UWB anchor does not stand where the list says
    PosePredicted, ///< nothing was measured for some way
    TagsMissing,   ///< a turn should have read floor tags that it did not
    TagsUnknown,   ///< a turn read floor tags that the plant file does not name
    Stranger,      ///< a peer that is not in the plant file was refused
};

/// In order of weight, after ISA-18.2.
enum class AlarmPriority : std::uint8_t { Low, Medium, High };

enum class AlarmState : std::uint8_t {
    Unacknowledged, ///< holds, nobody has said that he knows
    Acknowledged,   ///< holds
    Returned,       ///< no longer holds, nobody has said that he knows
    Shelved,        ///< put aside by the operator until a moment
};

/// An alarm is told apart by its kind and what it is about.
struct AlarmKey {
    AlarmKind kind = AlarmKind::RobotError;
    int subject = 0; ///< number of the AGV or of the anchor; 0: the plant or the UWB unit
    friend auto operator<=>(const AlarmKey&, const AlarmKey&) = default;
};

struct AlarmSnapshot {
    AlarmKey key;
    AlarmPriority priority = AlarmPriority::Low;
    AlarmState state = AlarmState::Unacknowledged;
    bool holds = false;                 ///< the condition is there now
    bool heldBack = false;              ///< came in a flood and waits for its end; listed, but not counted
    std::string detail;                 ///< what is known of the cause; plain English; may be empty
    std::int64_t raised_utc_ms = 0;     ///< wall clock of the last time it came
    int occurrences = 1;                ///< since it was last off the list
    std::optional<double> shelvedFor_s; ///< left while it is Shelved
    friend bool operator==(const AlarmSnapshot&, const AlarmSnapshot&) = default;
};

} // namespace agv
