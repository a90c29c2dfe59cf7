// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

#include <cstdint>
#include <optional>

namespace agv {

/// State the robot reports of itself (robot link, message stateUpdate); values are those of the wire.
enum class RobotState : std::uint8_t {
    Idle = 0,
    SegmentDriving = 1,
    SegmentWaiting = 2,
    DirectDriving = 3,
    StationDocking = 4,
    StationDocked = 5,
    StationUndocking = 6,
    DemoDocking = 7,
    Error = 8,
};

/// Charging state of the robot's battery (message sensorUpdate); values are those of the wire.
enum class ChargingState : std::uint8_t {
    NotCharging = 0,
    Reconditioning = 1,
    FullCharging = 2,
    Trickle = 3,
    Waiting = 4,
    Fault = 5,
};

struct BatteryStatus {
    ChargingState charging = ChargingState::NotCharging;
    double voltage_V = 0.0;
    double current_A = 0.0; ///< negative while discharging
    int temperature_degC = 0;
    double charge_Ah = 0.0;
    double capacity_Ah = 0.0;
    bool internalCharger = false; ///< charging source bit 0
    bool homeBase = false;        ///< charging source bit 1
    friend bool operator==(const BatteryStatus&, const BatteryStatus&) = default;
};

/// Speeds of the two wheels in m/s, positive forward. Turning counter-clockwise is left < 0 < right.
struct WheelSpeeds {
    double left = 0.0;
    double right = 0.0;
    friend bool operator==(const WheelSpeeds&, const WheelSpeeds&) = default;
};

/// A stretch of measured driving (robot link, command addSegments).
struct DriveSegment {
    WheelSpeeds speeds;
    double endDistance_m = 0.0; ///< 0: no distance limit
    double endAngle = 0.0;      ///< rad, positive counter-clockwise; 0: no angle limit
    friend bool operator==(const DriveSegment&, const DriveSegment&) = default;
};

} // namespace agv
