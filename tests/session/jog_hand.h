// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "session/jog_desk.h"
#include "session/scripted_plant.h"

namespace agv::session {

/// The operator's hand: presses, says every 50 ms that it still holds, lets go.
class Hand : public QObject {
public:
    Hand(ScriptedPlant& plant, JogSource source) : m_plant(plant), m_source(source)
    {
        m_beat.setTimerType(Qt::PreciseTimer);
        connect(&m_beat, &QTimer::timeout, this, [this] { desk().hold(1, command()); });
    }
    void press(const WheelSpeeds& speeds = {0.1, 0.1})
    {
        ++m_press;
        m_speeds = speeds;
        desk().press(1, command());
        m_beat.start(50);
    }
    void turnTo(const WheelSpeeds& speeds) { m_speeds = speeds; }
    void letGo(JogReason why = JogReason::Released)
    {
        m_beat.stop();
        desk().release(1, command(), why);
    }
    /// The window hangs: no more words, not even of a release.
    void freeze() { m_beat.stop(); }
    void thaw() { m_beat.start(50); }
    Time lastWord() const { return m_lastWord; }

private:
    JogDesk& desk() const { return *m_plant.session->jogDesk(); }
    JogCommand command()
    {
        m_lastWord = std::chrono::steady_clock::now();
        return {m_source, m_press, m_speeds, m_lastWord};
    }

    ScriptedPlant& m_plant;
    JogSource m_source;
    std::uint32_t m_press = 0;
    WheelSpeeds m_speeds;
    Time m_lastWord;
    QTimer m_beat;
};

} // namespace agv::session
