// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/turn_harness.h"

#include <algorithm>

namespace agv::procedure {

using namespace std::chrono_literals;

TurnHarness::TurnHarness(TurnParameters parameters, ReaderModel readerModel, std::uint32_t seed)
    : reader(readerModel),
      m_turn(parameters),
      m_nextRead(m_now),
      m_stepTime(TurnPlan(parameters).stepTime()),
      m_random(seed)
{}

void TurnHarness::perform(const TurnActions& actions)
{
    for (const TurnAction& action : actions) {
        m_emitted.push_back({m_now, m_turn.phase(), action});
        if (const auto* segments = std::get_if<DriveSegments>(&action); segments && robotAnswers) {
            m_segment = segments->firstNumber;
            m_segmentDoneAt = m_now + m_stepTime;
        }
        if (std::holds_alternative<InterruptRobot>(action))
            m_segmentDoneAt.reset();
        if (std::holds_alternative<SolveResult>(action) && solveTime)
            m_solvedAt = m_now + *solveTime;
    }
}

Time TurnHarness::nextEvent() const
{
    Time next = m_nextRead;
    for (const std::optional<Time>& other : {m_turn.deadline(), m_solvedAt, m_segmentDoneAt}) {
        if (other)
            next = std::min(next, *other);
    }
    return next;
}

void TurnHarness::serve()
{
    m_now = std::max(m_now, nextEvent());
    if (m_segmentDoneAt && *m_segmentDoneAt <= m_now) {
        m_segmentDoneAt.reset();
        perform(m_turn.onSegmentDone(m_segment, m_now));
    }
    if (m_solvedAt && *m_solvedAt <= m_now) {
        m_solvedAt.reset();
        perform(m_turn.solved(m_now));
    }
    if (m_nextRead <= m_now)
        readOne();
    if (m_turn.deadline() && *m_turn.deadline() <= m_now)
        perform(m_turn.onTimer(m_now));
}

void TurnHarness::readOne()
{
    m_nextRead = m_now + std::chrono::microseconds(std::uniform_int_distribution(30'000, 35'000)(m_random));
    m_tag = reader.tagsInRange > 0 ? m_tag % reader.tagsInRange + 1 : 0;
    const bool missed = std::bernoulli_distribution(reader.missRate)(m_random);
    if (reader.silent || missed || reader.tagsInRange == 0)
        return;
    const auto stop = static_cast<unsigned>(m_turn.record().stops.size() + 1);
    perform(m_turn.onTagRead({m_now, TagUid{16 * stop + static_cast<unsigned>(m_tag)}, m_tag % 8}));
}

bool TurnHarness::runUntil(const std::function<bool()>& done, Duration limit)
{
    const Time end = m_now + limit;
    while (!done()) {
        if (nextEvent() > end)
            return false;
        serve();
    }
    return true;
}

bool TurnHarness::runUntilPhase(TurnPhase phase)
{
    return runUntil([&] { return m_turn.phase() == phase; });
}

void TurnHarness::drain()
{
    runUntil([] { return false; }, 2s);
}

int TurnHarness::motionsStarted() const
{
    int count = 0;
    for (const DriveWheels& drive : all<DriveWheels>())
        count += drive.speeds == WheelSpeeds{} ? 0 : 1;
    return count + static_cast<int>(all<DriveSegments>().size());
}

} // namespace agv::procedure
