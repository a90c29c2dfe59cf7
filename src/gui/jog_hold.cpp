// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/jog_hold.h"

#include <utility>

namespace agv::gui {
namespace {

constexpr std::chrono::milliseconds beatEvery(50);
constexpr Duration longestStall = std::chrono::milliseconds(250);

} // namespace

JogHold::JogHold(QObject* parent, Clock clock) : QObject(parent), m_clock(std::move(clock))
{
    m_beat.setTimerType(Qt::PreciseTimer);
    m_beat.setInterval(beatEvery);
    connect(&m_beat, &QTimer::timeout, this, &JogHold::beat);
}

void JogHold::setWatching(bool watching)
{
    if (!watching) {
        m_beat.stop();
    } else if (!m_beat.isActive()) {
        m_lastBeat = m_clock();
        m_beat.start();
    }
}

bool JogHold::hasStalled(Time now) const { return m_beat.isActive() && now - m_lastBeat >= longestStall; }

bool JogHold::begin(JogSource source, const WheelSpeeds& speeds)
{
    const Time now = m_clock();
    if (hasStalled(now) || now < m_distrustUntil)
        return false;
    m_command = {source, m_command.press + 1, speeds, now};
    m_isHeld = true;
    emit pressed(m_command);
    return true;
}

void JogHold::end(JogReason why)
{
    if (std::exchange(m_isHeld, false))
        emit released(m_command, why);
}

void JogHold::beat()
{
    const Time now = m_clock();
    const bool stood = hasStalled(now);
    m_lastBeat = now;
    if (stood) {
        m_distrustUntil = now + longestStall;
        if (m_isHeld)
            emit stalled();
        return;
    }
    if (!m_isHeld)
        return;
    m_command.input = now;
    emit held(m_command);
}

} // namespace agv::gui
