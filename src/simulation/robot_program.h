// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/robot_frame.h"
#include "simulation/drive.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace agv::simulation {

/// The program on the robot's microcontroller: commands in, wheel speeds and reports out. It knows its
/// encoders only.
///
/// | state            | event                                    | next state |
/// |------------------|------------------------------------------|------------|
/// | any but Error    | directDrive, speed / zero                | DirectDriving / Idle |
/// | any but Error    | addSegments                              | SegmentWaiting |
/// | SegmentWaiting   | next control cycle                       | SegmentDriving |
/// | SegmentDriving   | end distance or angle reached, more left | SegmentDriving |
/// | SegmentDriving   | zero-speed segment was the last one      | Idle |
/// | SegmentDriving   | no segment left, the last had speed      | Error |
/// | Segment...       | a started or done segment sent again, or a gap in the numbers | Error |
/// | any but Error    | dock / dockDemo                          | StationDocking / DemoDocking |
/// | StationDocking   | arrived                                  | StationDocked |
/// | DemoDocking      | arrived                                  | Idle (charging) |
/// | ...Docking       | nothing in sight, or 30 s                | Idle, with a debug report |
/// | any but Error    | undock                                   | StationUndocking |
/// | StationUndocking | 250 mm backwards                         | Idle |
/// | driving          | bump                                     | Idle; Error while on segments |
/// | any              | interrupt                                | Idle |
///
/// There is no command time-out: a speed stays until another command changes it, whatever happens to the
/// connection.
class RobotProgram {
public:
    /// `braking_m_s2` is known to the program so that a turn ends where it should.
    RobotProgram(double track_m, double braking_m_s2) : m_track_m(track_m), m_braking_m_s2(braking_m_s2) {}

    void receive(const protocol::RobotCommand& command);
    /// A console has connected anew: segment numbers may start anywhere again.
    void restartNumbering();
    /// One control cycle. `encoder` is the travel since the last one, `speeds` what the encoders say now.
    void step(double seconds, WheelTravel encoder, WheelSpeeds speeds, std::uint64_t robotTime_ms);
    /// The bumper was pressed.
    void bump();
    void fail(const std::string& text, int code);
    void clearError();

    /// While docking the base follows the dock's infrared beam: the speeds it asks for, nothing when no dock
    /// is in sight.
    bool isDocking() const
    {
        return m_state == RobotState::StationDocking || m_state == RobotState::DemoDocking;
    }
    void guide(std::optional<WheelSpeeds> speeds, bool arrived);

    WheelSpeeds target() const { return m_target; }
    RobotState state() const { return m_state; }
    std::vector<protocol::RobotReport> takeReports();
    /// Progress of the running segment; nothing when none runs.
    std::optional<protocol::SegmentUpdate> segmentProgress(std::uint64_t robotTime_ms) const;

private:
    void enter(RobotState state);
    void stop(RobotState state);
    void debug(const std::string& text, std::int32_t value);
    void addSegments(const protocol::AddSegments& command);
    void startNextSegment(std::uint64_t robotTime_ms);
    bool segmentEnds(WheelSpeeds speeds) const;
    bool nextStandsStill() const;

    double m_track_m;
    double m_braking_m_s2;
    RobotState m_state = RobotState::Idle;
    WheelSpeeds m_target;
    std::vector<protocol::RobotReport> m_reports;

    std::deque<DriveSegment> m_queue;           ///< not started yet
    std::uint32_t m_nextNumber = 0;             ///< of m_queue's front
    std::optional<std::uint32_t> m_startedUpTo; ///< highest number started in this connection
    DriveSegment m_segment;                     ///< running
    double m_distance_m = 0.0;                  ///< within the running segment or manoeuvre
    double m_angle = 0.0;
    double m_dockingFor_s = 0.0;
};

} // namespace agv::simulation
