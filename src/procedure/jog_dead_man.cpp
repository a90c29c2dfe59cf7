// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/jog_dead_man.h"

#include <algorithm>

namespace agv::procedure {

JogReason JogDeadMan::refusal(const JogCommand& command, JogReason obstacle, Time now) const
{
    if (m_state == JogState::Latched)
        return JogReason::StopAll;
    if (obstacle != JogReason::None)
        return obstacle;
    if (isTooOld(command.input, now))
        return JogReason::InputOld;
    // A speed that is no number becomes zero (slowedTo()) before it comes here.
    return command.speeds == WheelSpeeds{} ? JogReason::BadSpeed : JogReason::None;
}

JogAction JogDeadMan::press(const JogCommand& command, JogReason obstacle, Time now)
{
    const bool drove = m_state == JogState::Driving;
    if (drove && !isTooOld(m_command.input, now) && command.source != m_command.source) {
        m_reason = JogReason::OtherSource;
        return JogAction::None;
    }
    m_reason = refusal(command, obstacle, now);
    m_command = command;
    m_letGo = false;
    if (m_reason != JogReason::None)
        return drove ? stopHeld(m_reason) : JogAction::None;
    m_state = JogState::Driving;
    m_next = now + m_parameters.interval;
    return JogAction::Drive;
}

JogAction JogDeadMan::hold(const JogCommand& command, Time now)
{
    if (m_state != JogState::Driving || !isOfThisPress(command))
        return JogAction::None;
    if (isTooOld(m_command.input, now) || isTooOld(command.input, now))
        return stopHeld(JogReason::InputOld);
    if (command.speeds == WheelSpeeds{})
        return stopHeld(JogReason::BadSpeed);
    m_command.speeds = command.speeds;
    m_command.input = std::max(m_command.input, command.input);
    return JogAction::None;
}

JogAction JogDeadMan::release(const JogCommand& command, JogReason why)
{
    if (!isOfThisPress(command))
        return JogAction::None;
    m_letGo = true;
    if (m_state == JogState::Spent) {
        m_state = JogState::Ready;
    } else if (m_state == JogState::Driving) {
        m_state = JogState::Ready;
        m_reason = why;
        return JogAction::Stop;
    }
    return JogAction::None;
}

JogAction JogDeadMan::obstruct(JogReason why)
{
    return m_state == JogState::Driving ? stopHeld(why) : JogAction::None;
}

void JogDeadMan::stopAll()
{
    m_state = JogState::Latched;
    m_reason = JogReason::StopAll;
}

void JogDeadMan::releaseLatch()
{
    if (m_state != JogState::Latched)
        return;
    m_state = m_letGo ? JogState::Ready : JogState::Spent;
    m_reason = JogReason::None;
}

JogAction JogDeadMan::onTimer(Time now)
{
    if (m_state != JogState::Driving)
        return JogAction::None;
    if (isTooOld(m_command.input, now))
        return stopHeld(JogReason::InputOld);
    if (now < m_next)
        return JogAction::None;
    m_next += m_parameters.interval;
    if (m_next <= now) // after a late timer the commands do not catch up in a rush
        m_next = now + m_parameters.interval;
    return JogAction::Drive;
}

std::optional<Time> JogDeadMan::deadline() const
{
    if (m_state != JogState::Driving)
        return std::nullopt;
    return std::min(m_next, m_command.input + m_parameters.longestSilence);
}

JogAction JogDeadMan::stopHeld(JogReason why)
{
    m_state = JogState::Spent;
    m_reason = why;
    return JogAction::Stop;
}

} // namespace agv::procedure
