// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shift_calibration.h"

#include <algorithm>

namespace agv::model {
namespace {

bool runs(TurnPhase phase)
{
    return phase == TurnPhase::Settling || phase == TurnPhase::Reading || phase == TurnPhase::Turning ||
           phase == TurnPhase::Solving;
}

} // namespace

void ShiftCalibration::start(const std::vector<int>& robots, Time now)
{
    m_entries.clear();
    for (const int robot : robots)
        m_entries.push_back({robot, Outcome::Waiting, nullptr});
    m_current = 0;
    m_isAsked = false;
    m_began = m_askedAt = now;
    m_state = m_entries.empty() ? State::Over : State::Asking;
}

void ShiftCalibration::stop()
{
    if (isRunning())
        end(Outcome::Stopped);
}

void ShiftCalibration::end(Outcome outcome)
{
    m_entries[m_current].outcome = outcome;
    m_state = State::Over;
}

std::optional<int> ShiftCalibration::update(const PlantSnapshot& snapshot)
{
    if (!isRunning())
        return std::nullopt;
    Entry& entry = m_entries[m_current];
    const auto agv = std::ranges::find(snapshot.agvs, RobotId{entry.robot}, &AgvSnapshot::id);
    if (agv == snapshot.agvs.end()) {
        end(Outcome::NotStarted);
        return std::nullopt;
    }
    const TurnSnapshot& turn = agv->turn;
    if (!m_isAsked) {
        m_isAsked = true;
        m_askedAt = snapshot.time;
        m_before = turn.result;
        return entry.robot;
    }
    if (m_state == State::Asking && runs(turn.phase)) {
        m_state = State::Turning;
        entry.outcome = Outcome::Running;
    } else if (m_state == State::Asking && snapshot.time - m_askedAt > patience) {
        end(Outcome::NotStarted);
    } else if (m_state == State::Turning && !runs(turn.phase)) {
        if (turn.phase != TurnPhase::Finished || !turn.result || turn.result == m_before) {
            end(Outcome::Stopped);
            return std::nullopt;
        }
        entry.result = turn.result;
        entry.outcome = turn.result->valid ? Outcome::Found : Outcome::NotFound;
        return next(snapshot.time);
    }
    return std::nullopt;
}

std::optional<int> ShiftCalibration::next(Time now)
{
    if (++m_current == m_entries.size()) {
        --m_current;
        m_state = State::Over;
        return std::nullopt;
    }
    m_state = State::Asking;
    m_isAsked = false;
    m_askedAt = now;
    return std::nullopt;
}

bool ShiftCalibration::foundAll() const
{
    return m_state == State::Over && !m_entries.empty() &&
           std::ranges::all_of(m_entries, [](const Entry& entry) { return entry.outcome == Outcome::Found; });
}

} // namespace agv::model
