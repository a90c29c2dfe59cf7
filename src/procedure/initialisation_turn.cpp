// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/initialisation_turn.h"

#include "procedure/stop_table.h"
#include "procedure/turn_progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace agv::procedure {
namespace {

/// 25 ms are one degree at the seed's 1125 ms for 45 degrees.
constexpr Duration lateStep = std::chrono::milliseconds(25);
constexpr int firstPreview = 3;

bool cannotTurn(RobotState state)
{
    return state == RobotState::Error || state == RobotState::StationDocking ||
           state == RobotState::StationDocked || state == RobotState::StationUndocking ||
           state == RobotState::DemoDocking;
}

Rotation opposite(Rotation rotation)
{
    return rotation == Rotation::Clockwise ? Rotation::CounterClockwise : Rotation::Clockwise;
}

} // namespace

InitialisationTurn::InitialisationTurn(TurnParameters parameters, std::uint32_t firstSegment)
    : m_parameters(parameters),
      m_plan(parameters),
      m_dwell(parameters),
      m_nextSegment(firstSegment)
{
    m_record.nominalStep = m_plan.stepAngle();
    m_record.rotation = parameters.rotation;
    m_record.kind = parameters.kind;
    if (parameters.kind == TurnKind::Timed)
        m_record.turnTime_s = parameters.turnTime_s;
}

TurnActions InitialisationTurn::start(Time now)
{
    TurnActions actions;
    if (m_phase != TurnPhase::Idle)
        return actions;
    m_lastRead = now;
    sendZero(now, actions);
    enterSettling(now);
    return actions;
}

TurnActions InitialisationTurn::retake(int stop, Time now)
{
    TurnActions actions;
    if (m_phase != TurnPhase::Finished || stop < 0 || stop >= m_plan.stopCount())
        return actions;
    m_retaking = true;
    m_stop = stop;
    m_current = {};
    m_leftAt.reset();
    m_lastRead = now;
    m_stepsToGo = stop - m_standing;
    if (m_parameters.kind == TurnKind::Measured) {
        const int wholeTurn = m_parameters.stopsPerTurn;
        const int shortest = (m_stepsToGo % wholeTurn + wholeTurn) % wholeTurn;
        m_stepsToGo = 2 * shortest > wholeTurn ? shortest - wholeTurn : shortest;
    }
    actions.emplace_back(Report{EventLevel::Info, "Stop " + std::to_string(stop + 1) + " is read again"});
    if (m_stepsToGo != 0) {
        driveStep(now, actions);
    } else {
        sendZero(now, actions);
        enterSettling(now);
    }
    return actions;
}

TurnActions InitialisationTurn::abort(Time now, std::string reason)
{
    if (!isActive()) {
        TurnActions actions;
        sendZero(now, actions);
        return actions;
    }
    return stop(TurnPhase::Aborted, std::move(reason), EventLevel::Warning, now);
}

TurnActions InitialisationTurn::onTimer(Time now)
{
    TurnActions actions;
    if (m_zeros.onTimer(now))
        actions.emplace_back(DriveWheels{});
    if (const std::optional<Time> silent = silenceDeadline(); silent && now >= *silent) {
        char text[160];
        std::snprintf(
            text, sizeof text,
            "No floor tag was read for %.0f s: check the RFID reader and that the AGV stands on tags",
            secondsFrom(now - m_lastRead));
        TurnActions end = stop(TurnPhase::Failed, text, EventLevel::Error, now);
        actions.insert(actions.end(), end.begin(), end.end());
        return actions;
    }
    const std::optional<Time> end = m_phase == TurnPhase::Reading ? m_dwell.leaveAt() : m_phaseEnd;
    if (isActive() && end && now >= *end)
        onPhaseEnd(now, actions);
    return actions;
}

void InitialisationTurn::onPhaseEnd(Time now, TurnActions& actions)
{
    switch (m_phase) {
    case TurnPhase::Settling:
        if (m_stepsToGo != 0)
            driveStep(now, actions);
        else
            enterReading(now);
        break;
    case TurnPhase::Reading:
        leaveStop(now, actions);
        break;
    case TurnPhase::Turning:
        if (m_parameters.kind == TurnKind::Timed) {
            sendZero(now, actions);
            warnIfLate(now, actions);
            endStep(now);
        } else {
            TurnActions failed = stop(TurnPhase::Failed,
                                      "The robot did not report the end of its turn in time: check that its "
                                      "wheels are free",
                                      EventLevel::Error, now);
            actions.insert(actions.end(), failed.begin(), failed.end());
        }
        break;
    case TurnPhase::Solving: {
        TurnActions failed = stop(TurnPhase::Failed, "The solver gave no answer", EventLevel::Error, now);
        actions.insert(actions.end(), failed.begin(), failed.end());
        break;
    }
    case TurnPhase::Idle:
    case TurnPhase::Finished:
    case TurnPhase::Aborted:
    case TurnPhase::Failed:
        break;
    }
}

TurnActions InitialisationTurn::onTagRead(const TagRead& read)
{
    if (!isActive() || m_phase == TurnPhase::Solving)
        return {};
    m_lastRead = std::max(m_lastRead, read.time);
    if (m_phase == TurnPhase::Reading && read.time >= m_phaseBegin) {
        m_current.reads.push_back(read);
        m_dwell.add(read);
    } else if (m_leftAt && read.time <= *m_leftAt && m_phase != TurnPhase::Reading) {
        m_record.stops.back().reads.push_back(read);
    } else {
        m_current.movingReads.push_back(read);
    }
    return {};
}

TurnActions InitialisationTurn::onSegmentDone(std::uint32_t number, Time now)
{
    // The zero segment that follows carries the next number; its report proves the same.
    if (m_phase == TurnPhase::Turning && m_parameters.kind == TurnKind::Measured &&
        (number == m_awaitedSegment || number == m_awaitedSegment + 1)) {
        endStep(now);
    }
    return {};
}

TurnActions InitialisationTurn::onRobotState(RobotState state, Time now)
{
    if (!isActive())
        return {};
    if (cannotTurn(state)) {
        return stop(TurnPhase::Failed,
                    state == RobotState::Error
                        ? "The robot reports an error: look at the robot, then switch it off and on"
                        : "The robot is docking or docked: undock it first",
                    EventLevel::Error, now);
    }
    if (m_phase != TurnPhase::Turning)
        return {};
    if (state == RobotState::DirectDriving || state == RobotState::SegmentDriving)
        m_sawItDrive = true;
    if (state != RobotState::Idle || !m_sawItDrive)
        return {};
    return stop(TurnPhase::Failed, "The robot stopped in the middle of a turn: look for what it bumped into",
                EventLevel::Error, now);
}

TurnActions InitialisationTurn::onRobotLost(Time now, std::string reason)
{
    if (!isActive())
        return {};
    return stop(TurnPhase::Failed, "The link to the robot was lost: " + std::move(reason), EventLevel::Error,
                now);
}

TurnActions InitialisationTurn::onReaderLost(Time now, std::string reason)
{
    if (!isActive() || m_phase == TurnPhase::Solving)
        return {};
    return stop(TurnPhase::Failed, "The link to the RFID reader was lost: " + std::move(reason),
                EventLevel::Error, now);
}

TurnActions InitialisationTurn::solved(Time now)
{
    if (m_phase == TurnPhase::Solving) {
        m_phase = TurnPhase::Finished;
        m_phaseBegin = now;
        m_phaseEnd.reset();
    }
    return {};
}

std::optional<Time> InitialisationTurn::deadline() const
{
    std::optional<Time> next = m_zeros.deadline();
    const auto take = [&next](std::optional<Time> other) {
        if (other && (!next || *other < *next))
            next = other;
    };
    if (isActive())
        take(m_phase == TurnPhase::Reading ? m_dwell.leaveAt() : m_phaseEnd);
    take(silenceDeadline());
    return next;
}

bool InitialisationTurn::isActive() const
{
    return m_phase == TurnPhase::Settling || m_phase == TurnPhase::Reading || m_phase == TurnPhase::Turning ||
           m_phase == TurnPhase::Solving;
}

std::optional<Time> InitialisationTurn::silenceDeadline() const
{
    if (!isActive() || m_phase == TurnPhase::Solving)
        return std::nullopt;
    return m_lastRead + m_plan.silenceLimit();
}

void InitialisationTurn::enterSettling(Time now)
{
    m_phase = TurnPhase::Settling;
    m_phaseBegin = now;
    m_phaseEnd = now + m_plan.settleTime();
}

void InitialisationTurn::enterReading(Time now)
{
    m_phase = TurnPhase::Reading;
    m_phaseBegin = now;
    m_phaseEnd.reset();
    m_leftAt.reset();
    m_dwell.begin(now);
}

void InitialisationTurn::leaveStop(Time now, TurnActions& actions)
{
    if (m_current.reads.empty()) {
        actions.emplace_back(
            Report{EventLevel::Warning, "No floor tag was read at stop " + std::to_string(m_stop + 1)});
    }
    keepStop();
    const int stopsDone = static_cast<int>(m_record.stops.size());
    if (m_retaking || stopsDone == m_plan.stopCount()) {
        m_retaking = false;
        sendZero(now, actions);
        m_phase = TurnPhase::Solving;
        m_phaseBegin = now;
        m_phaseEnd = now + m_plan.solveLimit();
        actions.emplace_back(SolveResult{});
        return;
    }
    m_leftAt = now;
    ++m_stop;
    m_stepsToGo = 1;
    driveStep(now, actions);
    if (stopsDone >= firstPreview)
        actions.emplace_back(SolvePreview{stopsDone});
}

void InitialisationTurn::keepStop()
{
    const auto index = static_cast<std::size_t>(m_stop);
    if (index < m_record.stops.size())
        m_record.stops[index] = std::move(m_current);
    else
        m_record.stops.push_back(std::move(m_current));
    m_current = {};
}

void InitialisationTurn::driveStep(Time now, TurnActions& actions)
{
    const Rotation rotation = m_stepsToGo > 0 ? m_parameters.rotation : opposite(m_parameters.rotation);
    m_zeros.cancel();
    m_sawItDrive = false;
    m_phase = TurnPhase::Turning;
    m_phaseBegin = now;
    if (m_parameters.kind == TurnKind::Timed) {
        actions.emplace_back(DriveWheels{m_plan.wheelSpeeds(rotation)});
        m_phaseEnd = now + m_plan.stepTime();
        return;
    }
    // A robot goes idle only when the last segment it processes has zero speed.
    const int nextStop = m_standing + (m_stepsToGo > 0 ? 1 : -1);
    actions.emplace_back(
        DriveSegments{m_nextSegment, {m_plan.segment(m_standing, nextStop), DriveSegment{}}});
    m_awaitedSegment = m_nextSegment;
    m_nextSegment += 2;
    m_phaseEnd = now + m_plan.stepLimit();
}

void InitialisationTurn::endStep(Time now)
{
    const int direction = m_stepsToGo > 0 ? 1 : -1;
    m_stepsToGo -= direction;
    m_standing += direction;
    enterSettling(now);
}

void InitialisationTurn::warnIfLate(Time now, TurnActions& actions) const
{
    const Duration late = now - (m_phaseBegin + m_plan.stepTime());
    if (late < lateStep)
        return;
    char text[160];
    std::snprintf(
        text, sizeof text,
        "The robot was stopped %.0f ms late: this computer was busy, the step is about %.1f degrees "
        "too long",
        secondsFrom(late) * 1e3,
        degFromRad(m_plan.stepAngle()) * secondsFrom(late) / secondsFrom(m_plan.stepTime()));
    actions.emplace_back(Report{EventLevel::Warning, text});
}

void InitialisationTurn::sendZero(Time now, TurnActions& actions)
{
    actions.emplace_back(DriveWheels{});
    m_zeros.begin(now);
}

TurnActions InitialisationTurn::stop(TurnPhase end, std::string reason, EventLevel level, Time now)
{
    TurnActions actions;
    if (m_parameters.kind == TurnKind::Measured)
        actions.emplace_back(InterruptRobot{});
    sendZero(now, actions);
    m_phase = end;
    m_phaseBegin = now;
    m_phaseEnd.reset();
    m_stepsToGo = 0;
    m_retaking = false;
    m_message = std::move(reason);
    actions.emplace_back(Report{level, m_message});
    return actions;
}

TurnSnapshot InitialisationTurn::snapshot(Time now) const
{
    TurnSnapshot result;
    result.phase = m_phase;
    result.stopCount = m_plan.stopCount();
    result.wheelSpeed_m_s = m_plan.wheelSpeed();
    result.message = m_message;
    if (m_phase == TurnPhase::Idle)
        return result;
    result.stop = m_stop + 1;
    if (isActive()) {
        const TurnProgress progress = progressOf(m_plan, {m_phase, m_stop, std::abs(m_stepsToGo), m_retaking,
                                                          std::max(now - m_phaseBegin, Duration::zero())});
        result.progress = progress.share;
        result.timeLeft_s = secondsFrom(progress.timeLeft);
    } else if (m_phase == TurnPhase::Finished) {
        result.progress = 1.0;
    }
    for (int stop = 0; stop < m_plan.stopCount(); ++stop) {
        const auto index = static_cast<std::size_t>(stop);
        const bool current = stop == m_stop && m_phase != TurnPhase::Solving && isActive();
        if (current)
            result.table.push_back(stopRow(stop + 1, m_current, false));
        else if (index < m_record.stops.size())
            result.table.push_back(stopRow(stop + 1, m_record.stops[index], true));
        else
            result.table.push_back(stopRow(stop + 1, {}, false));
    }
    return result;
}

} // namespace agv::procedure
