// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "simulation/battery.h"
#include "simulation/drive.h"
#include "simulation/robot_program.h"

#include <functional>

namespace agv::simulation {

/// One AGV: base, battery and program, and the wire bytes it sends.
class Robot {
public:
    /// Clearance (m) of the robot's disc at a place; negative: it would overlap something.
    using Clearance = std::function<double(Point2 centre)>;

    Robot(const AgvConfig& config, const PlantSettings& settings, const Pose2& pose, SplitMix64 random);

    /// One step of `seconds`; `robotTime` counts from the start of the plant.
    void step(double seconds, Duration robotTime, const PlantLayout& plant, const Clearance& clearance);

    /// Bytes of the console's TCP connection, split anywhere.
    void receive(std::span<const std::uint8_t> bytes);
    void consoleConnected();
    /// TCP: state changes, state twice a second, segmentDone, debug, assert.
    protocol::Bytes takeFrames();
    /// UDP: sensorUpdate once a second, segmentUpdate ten times a second while driving a segment.
    std::vector<protocol::Bytes> takeDatagrams();
    /// Did the bumper touch something since the last call?
    bool takeBump();

    const AgvConfig& config() const { return m_config; }
    const Pose2& pose() const { return m_pose; }
    WheelSpeeds speeds() const { return m_drive.speeds(); }
    WheelSpeeds commanded() const { return m_program.target(); }
    RobotState state() const { return m_program.state(); }
    double charge() const { return m_battery.charge(); }
    bool isCharging() const { return m_onHomeBase; }

    void place(const Pose2& pose);
    void setCharge(double charge) { m_battery.setCharge(charge); }
    void setSlip(double share) { m_drive.setSlip(share); }
    void fail();
    void restore();

private:
    void move(WheelTravel travel, const Clearance& clearance);
    void followDock(const PlantLayout& plant);
    void send(const protocol::RobotReport& report);
    void sendPeriodic(Duration robotTime);

    AgvConfig m_config;
    Pose2 m_pose;
    Battery m_battery;
    DriveModel m_driveModel;
    Drive m_drive;
    RobotProgram m_program;
    protocol::CommandStream m_commands;
    std::uint64_t m_bootTime_ms; ///< robot clock at the start of the plant
    Duration m_nextState{};
    Duration m_nextSensors{};
    Duration m_nextProgress{};
    bool m_onHomeBase = false;
    bool m_touching = false;
    bool m_bumped = false;
    protocol::Bytes m_frames;
    std::vector<protocol::Bytes> m_datagrams;
};

} // namespace agv::simulation
