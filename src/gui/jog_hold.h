// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "core/jog.h"

#include <functional>

namespace agv::gui {

/// Says for the hand that it holds: once at the press, then every 50 ms, and once at the end. When the window
/// hangs, nothing is said, which is what the dead-man of the session waits for.
/// After the event loop stood still for 250 ms, presses are refused for as long again: the window system
/// delivers what it kept meanwhile, and nobody knows how old that is. GUI thread.
class JogHold : public QObject {
    Q_OBJECT
public:
    using Clock = std::function<Time()>;
    explicit JogHold(QObject* parent, Clock clock = [] { return std::chrono::steady_clock::now(); });

    /// False: refused, because the window has just not reacted.
    bool begin(JogSource source, const WheelSpeeds& speeds);
    void setSpeeds(const WheelSpeeds& speeds) { m_command.speeds = speeds; }
    void end(JogReason why);
    bool isHeld() const { return m_isHeld; }
    /// While nobody can press, the event loop need not be watched.
    void setWatching(bool watching);
    /// Every 50 ms, by a timer of its own.
    void beat();

signals:
    void pressed(const agv::JogCommand& command);
    void held(const agv::JogCommand& command);
    void released(const agv::JogCommand& command, agv::JogReason why);
    /// The hold was ended here, because the window did not react.
    void stalled();

private:
    bool hasStalled(Time now) const;

    Clock m_clock;
    QTimer m_beat;
    JogCommand m_command;
    bool m_isHeld = false;
    Time m_lastBeat;
    Time m_distrustUntil;
};

} // namespace agv::gui
