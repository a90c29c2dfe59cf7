// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QThread>

#include "app/robot_guard.h"
#include "session/session.h"

namespace agv::app {

/// A session in a thread of its own, with a watchdog process for its robots. Connect to session() by queued
/// signals, then start(). Its destruction ends the session, which stops every robot, and waits for it.
class SessionThread {
public:
    SessionThread(PlantLayout plant, session::SessionOptions options);
    ~SessionThread();
    SessionThread(const SessionThread&) = delete;
    SessionThread& operator=(const SessionThread&) = delete;

    void start();
    session::Session* session() const { return m_session; }

private:
    QThread m_thread;
    RobotGuard* m_guard;         ///< lives in m_thread, deleted at its end, after the session
    session::Session* m_session; ///< lives in m_thread, deleted at its end
};

} // namespace agv::app
