// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/robot_frame.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace agv::protocol::samples {

inline DriveSegment segment(double left_mm_s, double right_mm_s, double end_mm, double end_deg)
{
    return {{metresFromMm(left_mm_s), metresFromMm(right_mm_s)}, metresFromMm(end_mm), radFromDeg(end_deg)};
}

/// Every command, at the extremes of its fields.
inline std::vector<RobotCommand> commands()
{
    constexpr auto lastNumber = std::numeric_limits<std::uint32_t>::max();
    return {
        AddSegments{0, {segment(-100, 100, 0, 45), segment(0, 0, 0, 0)}},
        AddSegments{lastNumber, {segment(-500, 500, -32768, 32767)}},
        AddSegments{lastNumber - 30, std::vector<DriveSegment>(31, segment(500, -500, 32767, -32768))},
        Dock{},
        Undock{},
        Interrupt{},
        DirectDrive{{0.0, 0.0}},
        DirectDrive{{-0.5, 0.5}},
        DirectDrive{{0.5, -0.5}},
        DirectDrive{{metresFromMm(-1), metresFromMm(1)}},
        DockDemo{},
    };
}

inline SensorUpdate sensorUpdate(ChargingState charging, double mV, double mA, int degC, double charge_mAh,
                                 double capacity_mAh, bool internalCharger, bool homeBase)
{
    return {{charging, mV * 1e-3, mA * 1e-3, degC, charge_mAh * 1e-3, capacity_mAh * 1e-3, internalCharger,
             homeBase}};
}

/// Every report, at the extremes of its fields.
inline std::vector<RobotReport> reports()
{
    constexpr auto last32 = std::numeric_limits<std::uint32_t>::max();
    constexpr auto last64 = std::numeric_limits<std::uint64_t>::max();
    std::vector<RobotReport> all = {
        AssertReport{"", 0},
        AssertReport{"drive.c", 65535},
        AssertReport{std::string(251, 'f'), 1},
        DebugReport{"", std::numeric_limits<std::int32_t>::min()},
        DebugReport{std::string(249, '~'), std::numeric_limits<std::int32_t>::max()},
        DebugReport{"tab\there", -1},
        SegmentDone{0, 0},
        SegmentDone{last32, last64},
        sensorUpdate(ChargingState::NotCharging, 0, -32768, -128, 0, 0, false, false),
        sensorUpdate(ChargingState::Fault, 65535, 32767, 127, 65535, 65535, true, true),
        sensorUpdate(ChargingState::Trickle, 16400, -350, 24, 2100, 2696, false, true),
        sensorUpdate(ChargingState::FullCharging, 17000, 1200, 31, 1500, 2696, true, false),
        SegmentUpdate{0, 0, metresFromMm(-32768), radFromDeg(32767)},
        SegmentUpdate{last32, last64, metresFromMm(32767), radFromDeg(-32768)},
    };
    for (int state = 0; state <= static_cast<int>(RobotState::Error); ++state)
        all.emplace_back(StateUpdate{static_cast<RobotState>(state)});
    return all;
}

} // namespace agv::protocol::samples
