// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QDBusConnection;

namespace agv::app {

/// Hears from the desktop that the screen is locked and from the system that the computer goes to sleep, over
/// D-Bus; without a bus it hears nothing. A locker need not take the keyboard from a window before it locks,
/// and a clock that stands while the computer sleeps cannot tell that it slept. Lives in the GUI thread,
/// never waits for an answer.
class DesktopWatch : public QObject {
    Q_OBJECT
public:
    explicit DesktopWatch(QObject* parent = nullptr);
    /// With other buses than the desktop's own, for tests.
    DesktopWatch(const QDBusConnection& session, const QDBusConnection& system, QObject* parent = nullptr);

signals:
    void screenLocked();
    void aboutToSleep();

private slots:
    void onScreenSaver(bool active);
    void onPrepareForSleep(bool begins);

private:
    void listen(QDBusConnection session, QDBusConnection system);
};

} // namespace agv::app
