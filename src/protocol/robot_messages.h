// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/robot_status.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// What console and robot say to each other, in SI units. The wire carries mm, mm/s, degrees, mV, mA and mAh
/// (robot_frame.h).
namespace agv::protocol {

/// Largest speed of a wheel, either way, m/s.
inline constexpr double maxWheelSpeed_m_s = 0.5;
/// As many segments as fit into one frame: (255 - 6) / 8.
inline constexpr std::size_t maxSegments = 31;

// --- console -> robot -------------------------------------------------------------------------------

/// Measured driving. The robot goes Idle at a segment of zero speed; to run out of segments otherwise, or to
/// replace one that has been started, is an error on the robot.
struct AddSegments {
    std::uint32_t firstNumber = 0;      ///< of segments[0]; the others count up from it
    std::vector<DriveSegment> segments; ///< 1 to maxSegments
    friend bool operator==(const AddSegments&, const AddSegments&) = default;
};
struct Dock {
    friend bool operator==(const Dock&, const Dock&) = default;
};
struct Undock {
    friend bool operator==(const Undock&, const Undock&) = default;
};
/// Stop what is running.
struct Interrupt {
    friend bool operator==(const Interrupt&, const Interrupt&) = default;
};
struct DirectDrive {
    WheelSpeeds speeds; ///< m/s, within +-maxWheelSpeed_m_s
    friend bool operator==(const DirectDrive&, const DirectDrive&) = default;
};
/// The base's own docking, to charge.
struct DockDemo {
    friend bool operator==(const DockDemo&, const DockDemo&) = default;
};
/// In the order of the command ids 0..5.
using RobotCommand = std::variant<AddSegments, Dock, Undock, Interrupt, DirectDrive, DockDemo>;

// --- robot -> console -------------------------------------------------------------------------------

struct AssertReport {
    std::string file; ///< ASCII without NUL, at most 251 characters
    int line = 0;     ///< 0..65535
    friend bool operator==(const AssertReport&, const AssertReport&) = default;
};
struct DebugReport {
    std::string text; ///< ASCII without NUL, at most 249 characters
    std::int32_t value = 0;
    friend bool operator==(const DebugReport&, const DebugReport&) = default;
};
struct SegmentDone {
    std::uint32_t number = 0;
    std::uint64_t robotTime_ms = 0; ///< the robot's clock
    friend bool operator==(const SegmentDone&, const SegmentDone&) = default;
};
/// On the wire: voltage 0..65535 mV, current -32768..32767 mA, temperature -128..127 degC, charge and
/// capacity 0..65535 mAh.
struct SensorUpdate {
    BatteryStatus battery;
    friend bool operator==(const SensorUpdate&, const SensorUpdate&) = default;
};
/// On the wire distance and angle are -32768..32767 mm and degrees.
struct SegmentUpdate {
    std::uint32_t number = 0;
    std::uint64_t robotTime_ms = 0; ///< the robot's clock
    double distance_m = 0.0;        ///< driven so far in this segment
    double angle = 0.0;             ///< rad turned so far in this segment, positive counter-clockwise
    friend bool operator==(const SegmentUpdate&, const SegmentUpdate&) = default;
};
struct StateUpdate {
    RobotState state = RobotState::Idle;
    friend bool operator==(const StateUpdate&, const StateUpdate&) = default;
};
/// In the order of the report ids 0..5.
using RobotReport =
    std::variant<AssertReport, DebugReport, SegmentDone, SensorUpdate, SegmentUpdate, StateUpdate>;

} // namespace agv::protocol
