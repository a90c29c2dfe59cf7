// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/link_life.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <utility>

namespace agv::procedure {
namespace {

std::string secondsText(Duration duration)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g s", secondsFrom(duration));
    return text;
}

} // namespace

LinkAction LinkLife::open(Time now)
{
    if (m_state != LinkState::Down && m_state != LinkState::Failed && m_state != LinkState::Waiting)
        return LinkAction::None;
    m_failures = 0;
    m_mute = false;
    m_reason.clear();
    return beginOpening(now);
}

LinkAction LinkLife::close()
{
    if (m_state == LinkState::Down)
        return LinkAction::None;
    m_state = LinkState::Down;
    m_reason.clear();
    m_deadline.reset();
    m_failures = 0;
    m_mute = false;
    return LinkAction::Close;
}

LinkAction LinkLife::connected(Time now)
{
    if (m_state != LinkState::Opening)
        return LinkAction::None;
    if (m_mute) {
        m_state = LinkState::Silent;
        m_reason = "Connected again, but still nothing is heard: " + m_parameters.hints.stillSilent;
        m_deadline = now + m_parameters.muteLostAfter;
    } else {
        m_state = LinkState::Up;
        m_reason.clear();
        m_deadline = now + m_parameters.silentAfter;
    }
    return LinkAction::None;
}

LinkAction LinkLife::data(Time now)
{
    if (!isConnected())
        return LinkAction::None;
    m_state = LinkState::Up;
    m_reason.clear();
    m_lastData = now;
    m_deadline = now + m_parameters.silentAfter;
    m_failures = 0;
    m_mute = false;
    return LinkAction::None;
}

LinkAction LinkLife::failed(bool transient, std::string reason, Time now)
{
    if (m_state != LinkState::Opening && !isConnected())
        return LinkAction::None;
    m_mute = false;
    if (transient)
        return wait(std::move(reason), now);
    m_state = LinkState::Failed;
    m_reason = std::move(reason);
    m_deadline.reset();
    return LinkAction::Close;
}

LinkAction LinkLife::onTimer(Time now)
{
    if (!m_deadline || now < *m_deadline)
        return LinkAction::None;
    switch (m_state) {
    case LinkState::Opening:
        m_mute = false;
        return wait("No answer within " + secondsText(m_parameters.connectTimeout) + ": " +
                        m_parameters.hints.noAnswer,
                    now);
    case LinkState::Up:
        m_state = LinkState::Silent;
        m_reason = "Connected, but nothing heard for " + secondsText(m_parameters.silentAfter) + ": " +
                   m_parameters.hints.silent;
        m_deadline = *m_deadline + (m_parameters.lostAfter - m_parameters.silentAfter);
        return LinkAction::None;
    case LinkState::Silent: {
        const Duration patience = m_mute ? m_parameters.muteLostAfter : m_parameters.lostAfter;
        m_mute = true;
        m_failures = 0; // it did connect; the back-off is for peers that do not
        return wait("Nothing heard for " + secondsText(patience) + ": the connection is being made anew",
                    now);
    }
    case LinkState::Waiting:
        return beginOpening(now);
    case LinkState::Down:
    case LinkState::Failed:
        break;
    }
    return LinkAction::None;
}

std::optional<Time> LinkLife::retryAt() const
{
    return m_state == LinkState::Waiting ? m_deadline : std::nullopt;
}

LinkAction LinkLife::wait(std::string reason, Time now)
{
    const auto step = std::min(static_cast<std::size_t>(m_failures), m_parameters.backOff.size() - 1);
    ++m_failures;
    m_state = LinkState::Waiting;
    m_reason = std::move(reason);
    m_deadline = now + m_parameters.backOff[step];
    return LinkAction::Close;
}

LinkAction LinkLife::beginOpening(Time now)
{
    m_state = LinkState::Opening;
    m_deadline = now + m_parameters.connectTimeout;
    return LinkAction::Open;
}

} // namespace agv::procedure
