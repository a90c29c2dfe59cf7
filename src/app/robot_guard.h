// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSocketNotifier>
#include <QString>
#include <QTimer>

#include "app/guard_channel.h"
#include "link/connection_guard.h"

#include <map>
#include <memory>
#include <optional>
#include <sys/types.h>

namespace agv::app {

/// The console's end of its watchdog process (guard_process.h): starts it, hands it the connection of every
/// robot, shows it by beats that the session thread runs, and starts it again should it end. Lives in the
/// session thread. It never blocks, but
/// for the end of the watchdog on destruction.
class RobotGuard : public QObject, public link::ConnectionGuard {
    Q_OBJECT
public:
    RobotGuard();
    ~RobotGuard() override;

    void start();
    void guard(int robot, int descriptor) override;
    void release(int robot) override;

signals:
    /// This process did not run for a while, so the watchdog has stopped the robots.
    void robotsStopped();
    /// There is no watchdog now; it is tried again every few seconds, and said once a minute at most.
    void failed(const QString& reason);

private:
    void spawn();
    void reportFailure(const QString& reason);
    void end();
    void reap();
    void onReadable();
    void beat();
    void send(GuardMessage::Kind kind, int robot, std::optional<int> descriptor = std::nullopt);

    int m_channel = -1;
    pid_t m_process = -1;
    std::unique_ptr<QSocketNotifier> m_notifier;
    QTimer m_beat;
    QTimer m_respawn;
    QElapsedTimer m_lastReport;
    std::map<int, int> m_descriptors; ///< by robot
};

} // namespace agv::app
