// SPDX-License-Identifier: GPL-3.0-or-later
// With a message bus of its own, on which the test is the desktop.
#include <QDBusConnection>
#include <QDBusMessage>
#include <QProcess>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include "app/desktop_watch.h"

using namespace agv::app;

class DesktopWatchTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        const QString daemon = QStandardPaths::findExecutable(QStringLiteral("dbus-daemon"));
        if (daemon.isEmpty())
            QSKIP("dbus-daemon is not installed");
        m_bus.start(daemon, {QStringLiteral("--session"), QStringLiteral("--nofork"),
                             QStringLiteral("--print-address")});
        QVERIFY(m_bus.waitForReadyRead(10000));
        m_address = QString::fromUtf8(m_bus.readLine()).trimmed();
    }
    void cleanupTestCase()
    {
        m_bus.terminate();
        if (m_bus.state() != QProcess::NotRunning)
            QVERIFY(m_bus.waitForFinished(10000));
    }
    void hearsThatTheScreenIsLocked_data()
    {
        QTest::addColumn<QString>("interface");
        for (const char* desktop : {"org.freedesktop.ScreenSaver", "org.gnome.ScreenSaver",
                                    "org.cinnamon.ScreenSaver", "org.mate.ScreenSaver"})
            QTest::newRow(desktop) << QString::fromLatin1(desktop);
    }
    void hearsThatTheScreenIsLocked()
    {
        QFETCH(QString, interface);
        DesktopWatch watch(bus("listens"), bus("listens"));
        QSignalSpy locked(&watch, &DesktopWatch::screenLocked);
        say(interface, QStringLiteral("ActiveChanged"), {false}); // unlocked
        say(interface, QStringLiteral("ActiveChanged"), {true});
        QTRY_COMPARE(locked.count(), 1);
    }
    void hearsThatTheSessionIsToBeLocked()
    {
        DesktopWatch watch(bus("listens"), bus("listens"));
        QSignalSpy locked(&watch, &DesktopWatch::screenLocked);
        say(QStringLiteral("org.freedesktop.login1.Session"), QStringLiteral("Lock"), {});
        QTRY_COMPARE(locked.count(), 1);
    }
    void hearsThatTheComputerGoesToSleepAndNotThatItWakes()
    {
        DesktopWatch watch(bus("listens"), bus("listens"));
        QSignalSpy asleep(&watch, &DesktopWatch::aboutToSleep);
        const QString manager = QStringLiteral("org.freedesktop.login1.Manager");
        say(manager, QStringLiteral("PrepareForSleep"), {false});
        say(manager, QStringLiteral("PrepareForSleep"), {true});
        QTRY_COMPARE(asleep.count(), 1);
    }
    void withoutABusItHearsNothingAndIsStillThere()
    {
        const QDBusConnection none(QStringLiteral("none"));
        DesktopWatch watch(none, none);
        QVERIFY(!none.isConnected());
    }

private:
    QDBusConnection bus(const char* name) const
    {
        return QDBusConnection::connectToBus(m_address, QString::fromLatin1(name));
    }
    void say(const QString& interface, const QString& signal, const QVariantList& arguments) const
    {
        QDBusMessage message = QDBusMessage::createSignal(QStringLiteral("/desktop"), interface, signal);
        message.setArguments(arguments);
        QVERIFY(bus("speaks").send(message));
    }

    QProcess m_bus;
    QString m_address;
};

QTEST_GUILESS_MAIN(DesktopWatchTest)
#include "test_desktop_watch.moc"
