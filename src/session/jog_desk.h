// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/jog.h"

#include <map>

namespace agv::session {

class AgvLine;

/// Where hands reach the session: every press, hold and release for an AGV, the docks, and the release after
/// Stop all. Lives in the session thread; connect to it by queued signals. What is refused says why in
/// AgvSnapshot::jog. An AGV that is not in the plant file is ignored.
class JogDesk : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// `line` outlives the last event of this object.
    void add(int robot, AgvLine& line) { m_lines.emplace(robot, &line); }

public slots:
    void press(int robot, const agv::JogCommand& command);
    /// Every 50 ms while the hand holds.
    void hold(int robot, const agv::JogCommand& command);
    void release(int robot, const agv::JogCommand& command, agv::JogReason why);
    /// Whoever is driven by hand stops: the screen was locked, the computer goes to sleep.
    void endAll(agv::JogReason why);
    /// This AGV stops, whatever it does; never refused.
    void stop(int robot);
    void order(int robot, agv::DockOrder order);
    /// The operator looked around after Stop all; hands may drive again, with a fresh press.
    void releaseStopAll();

private:
    AgvLine* line(int robot) const;

    std::map<int, AgvLine*> m_lines;
};

} // namespace agv::session
