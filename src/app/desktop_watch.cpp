// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop_watch.h"

#include <QDBusConnection>

namespace agv::app {

DesktopWatch::DesktopWatch(QObject* parent) : QObject(parent)
{
    // Without an address Qt would start a bus of its own, to which no desktop belongs.
    const bool hasDesktop = qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS");
    const QString none = QStringLiteral("none");
    listen(hasDesktop ? QDBusConnection::sessionBus() : QDBusConnection(none), QDBusConnection::systemBus());
}

DesktopWatch::DesktopWatch(const QDBusConnection& session, const QDBusConnection& system, QObject* parent)
    : QObject(parent)
{
    listen(session, system);
}

void DesktopWatch::listen(QDBusConnection session, QDBusConnection system)
{
    // KDE, Xfce and most others; GNOME and those that came from it.
    for (const char* interface : {"org.freedesktop.ScreenSaver", "org.gnome.ScreenSaver",
                                  "org.cinnamon.ScreenSaver", "org.mate.ScreenSaver"})
        session.connect(QString(), QString(), QString::fromLatin1(interface), QStringLiteral("ActiveChanged"),
                        this, SLOT(onScreenSaver(bool)));
    system.connect(QString(), QString(), QStringLiteral("org.freedesktop.login1.Session"),
                   QStringLiteral("Lock"), this, SIGNAL(screenLocked()));
    system.connect(QString(), QString(), QStringLiteral("org.freedesktop.login1.Manager"),
                   QStringLiteral("PrepareForSleep"), this, SLOT(onPrepareForSleep(bool)));
}

void DesktopWatch::onScreenSaver(bool active)
{
    if (active)
        emit screenLocked();
}

void DesktopWatch::onPrepareForSleep(bool begins)
{
    if (begins)
        emit aboutToSleep();
}

} // namespace agv::app
