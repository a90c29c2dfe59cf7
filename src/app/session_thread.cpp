// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session_thread.h"

#include <utility>

namespace agv::app {

namespace {

session::SessionOptions guarded(session::SessionOptions options, RobotGuard* guard)
{
    options.guard = guard;
    return options;
}

} // namespace

SessionThread::SessionThread(PlantLayout plant, session::SessionOptions options)
    : m_guard(new RobotGuard),
      m_session(new session::Session(std::move(plant), guarded(std::move(options), m_guard)))
{
    m_thread.setObjectName("session");
    m_guard->moveToThread(&m_thread);
    m_session->moveToThread(&m_thread);
    QObject::connect(m_guard, &RobotGuard::robotsStopped, m_session, [s = m_session] {
        s->stopAll("This program did not run for over a second, so its watchdog stopped every robot");
    });
    QObject::connect(m_guard, &RobotGuard::failed, m_session, [s = m_session](const QString& reason) {
        s->warn("There is no watchdog now (" + reason +
                "): if this program is killed, nothing stops the robots. A new one is being started");
    });
    // No robot is accepted before the watchdog is there, and the session leaves first.
    QObject::connect(&m_thread, &QThread::started, m_guard, &RobotGuard::start);
    QObject::connect(&m_thread, &QThread::started, m_session, &session::Session::start);
    QObject::connect(&m_thread, &QThread::finished, m_session, &QObject::deleteLater);
    QObject::connect(&m_thread, &QThread::finished, m_guard, &QObject::deleteLater);
}

SessionThread::~SessionThread()
{
    if (!m_thread.isRunning()) {
        delete m_session;
        delete m_guard;
        return;
    }
    m_thread.quit();
    m_thread.wait();
}

void SessionThread::start() { m_thread.start(QThread::TimeCriticalPriority); }

} // namespace agv::app
