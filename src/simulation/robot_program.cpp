// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/robot_program.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace agv::simulation {
namespace {

constexpr double undockDistance_m = 0.25;
constexpr WheelSpeeds undockSpeeds{-0.10, -0.10};
constexpr double longestDocking_s = 30.0;

// Codes of the assert reports.
constexpr int segmentTouchedAgain = 1;
constexpr int segmentGap = 2;
constexpr int segmentsRanOut = 3;
constexpr int segmentBlocked = 4;

bool isZero(WheelSpeeds speeds) { return speeds == WheelSpeeds{}; }

/// Has `value` reached `limit`, counted in the limit's own direction? A limit of 0 is unused.
bool reached(double value, double limit)
{
    if (limit == 0.0)
        return false;
    return limit > 0.0 ? value >= limit : value <= limit;
}

template<typename... Visitors>
struct Overloaded : Visitors... {
    using Visitors::operator()...;
};
template<typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

} // namespace

void RobotProgram::receive(const protocol::RobotCommand& command)
{
    if (std::holds_alternative<protocol::Interrupt>(command)) {
        stop(RobotState::Idle);
        return;
    }
    if (m_state == RobotState::Error) {
        debug("command ignored: robot is in its error state", static_cast<std::int32_t>(command.index()));
        return;
    }
    std::visit(Overloaded{
                   [this](const protocol::AddSegments& segments) { addSegments(segments); },
                   [this](const protocol::DirectDrive& drive) {
                       stop(isZero(drive.speeds) ? RobotState::Idle : RobotState::DirectDriving);
                       m_target = drive.speeds;
                   },
                   [this](protocol::Dock) { stop(RobotState::StationDocking); },
                   [this](protocol::DockDemo) { stop(RobotState::DemoDocking); },
                   [this](protocol::Undock) {
                       stop(RobotState::StationUndocking);
                       m_target = undockSpeeds;
                   },
                   [](protocol::Interrupt) {},
               },
               command);
}

void RobotProgram::restartNumbering()
{
    if (m_state != RobotState::SegmentDriving && m_state != RobotState::SegmentWaiting)
        m_startedUpTo.reset();
}

void RobotProgram::addSegments(const protocol::AddSegments& command)
{
    const std::uint32_t first = command.firstNumber;
    if (m_startedUpTo && first <= *m_startedUpTo)
        return fail("segment sent again after it was started", segmentTouchedAgain);
    const bool onSegments = m_state == RobotState::SegmentDriving || m_state == RobotState::SegmentWaiting;
    if (onSegments) {
        if (first > m_nextNumber && first - m_nextNumber > m_queue.size())
            return fail("gap in the segment numbers", segmentGap);
        m_queue.resize(first > m_nextNumber ? first - m_nextNumber : 0);
        m_nextNumber = std::min(m_nextNumber, first);
    } else {
        stop(RobotState::SegmentWaiting);
        m_nextNumber = first;
    }
    m_queue.insert(m_queue.end(), command.segments.begin(), command.segments.end());
}

void RobotProgram::step(double seconds, WheelTravel encoder, WheelSpeeds speeds, std::uint64_t robotTime_ms)
{
    m_distance_m += 0.5 * (encoder.left + encoder.right);
    m_angle += (encoder.right - encoder.left) / m_track_m;
    switch (m_state) {
    case RobotState::SegmentWaiting:
        startNextSegment(robotTime_ms);
        break;
    case RobotState::SegmentDriving:
        if (segmentEnds(speeds)) {
            m_reports.push_back(protocol::SegmentDone{*m_startedUpTo, robotTime_ms});
            startNextSegment(robotTime_ms);
        }
        break;
    case RobotState::StationUndocking:
        if (m_distance_m <= -undockDistance_m)
            stop(RobotState::Idle);
        break;
    case RobotState::StationDocking:
    case RobotState::DemoDocking:
        m_dockingFor_s += seconds;
        break;
    default:
        break;
    }
}

bool RobotProgram::nextStandsStill() const { return m_queue.empty() || isZero(m_queue.front().speeds); }

bool RobotProgram::segmentEnds(WheelSpeeds speeds) const
{
    if (isZero(m_segment.speeds))
        return true;
    double distance = m_distance_m;
    double angle = m_angle;
    if (nextStandsStill()) { // brake in time: v^2 / 2a per wheel
        const double left = speeds.left * std::abs(speeds.left) / (2.0 * m_braking_m_s2);
        const double right = speeds.right * std::abs(speeds.right) / (2.0 * m_braking_m_s2);
        distance += 0.5 * (left + right);
        angle += (right - left) / m_track_m;
    }
    return reached(distance, m_segment.endDistance_m) || reached(angle, m_segment.endAngle);
}

void RobotProgram::startNextSegment(std::uint64_t robotTime_ms)
{
    while (!m_queue.empty()) {
        m_segment = m_queue.front();
        m_queue.pop_front();
        m_startedUpTo = m_nextNumber++;
        m_distance_m = 0.0;
        m_angle = 0.0;
        m_target = m_segment.speeds;
        if (!isZero(m_segment.speeds))
            return enter(RobotState::SegmentDriving);
        m_reports.push_back(protocol::SegmentDone{*m_startedUpTo, robotTime_ms});
        if (m_queue.empty())
            return stop(RobotState::Idle);
    }
    fail("ran out of segments", segmentsRanOut);
}

void RobotProgram::guide(std::optional<WheelSpeeds> speeds, bool arrived)
{
    const bool demo = m_state == RobotState::DemoDocking;
    if (arrived)
        return stop(demo ? RobotState::Idle : RobotState::StationDocked);
    if (!speeds || m_dockingFor_s > longestDocking_s) {
        debug(speeds ? "docking took too long" : "no dock in sight", demo ? 1 : 0);
        return stop(RobotState::Idle);
    }
    m_target = *speeds;
}

void RobotProgram::bump()
{
    const bool onSegments = m_state == RobotState::SegmentDriving || m_state == RobotState::SegmentWaiting;
    debug("bump", static_cast<std::int32_t>(m_state));
    if (onSegments)
        fail("bumped while driving a segment", segmentBlocked);
    else if (m_state != RobotState::Error)
        stop(RobotState::Idle);
}

void RobotProgram::fail(const std::string& text, int code)
{
    debug(text, code);
    m_reports.push_back(protocol::AssertReport{"simulated robot", code});
    stop(RobotState::Error);
}

void RobotProgram::clearError()
{
    if (m_state == RobotState::Error)
        stop(RobotState::Idle);
}

void RobotProgram::stop(RobotState state)
{
    m_queue.clear();
    m_target = {};
    m_distance_m = 0.0;
    m_angle = 0.0;
    m_dockingFor_s = 0.0;
    enter(state);
}

void RobotProgram::enter(RobotState state)
{
    if (std::exchange(m_state, state) != state)
        m_reports.push_back(protocol::StateUpdate{state});
}

void RobotProgram::debug(const std::string& text, std::int32_t value)
{
    m_reports.push_back(protocol::DebugReport{text, value});
}

std::vector<protocol::RobotReport> RobotProgram::takeReports() { return std::exchange(m_reports, {}); }

std::optional<protocol::SegmentUpdate> RobotProgram::segmentProgress(std::uint64_t robotTime_ms) const
{
    if (m_state != RobotState::SegmentDriving)
        return std::nullopt;
    return protocol::SegmentUpdate{*m_startedUpTo, robotTime_ms, m_distance_m, m_angle};
}

} // namespace agv::simulation
