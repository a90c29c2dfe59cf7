// SPDX-License-Identifier: GPL-3.0-or-later
// The program itself on computers with and without a display.
#include <QProcess>
#include <QStandardPaths>
#include <QTest>

namespace agv::app {
namespace {

struct Outcome {
    int status = -1;
    QStringList errors; ///< lines of standard error
};

/// `variables` as NAME=value; of those that choose a display, the others are unset.
Outcome run(const QStringList& arguments, const QStringList& variables)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(name);
    for (const QString& variable : variables)
        environment.insert(variable.section('=', 0, 0), variable.section('=', 1));
    QProcess program;
    program.setProcessEnvironment(environment);
    program.start(AGV_PROGRAM, arguments);
    if (!program.waitForFinished(60'000) || program.exitStatus() != QProcess::NormalExit)
        return {};
    return {program.exitCode(),
            QString::fromLocal8Bit(program.readAllStandardError()).split('\n', Qt::SkipEmptyParts)};
}

/// A display number nobody uses: X servers count from 0.
constexpr auto staleDisplay = "DISPLAY=:4077";

} // namespace

class DisplayTest : public QObject {
    Q_OBJECT
private slots:
    void withoutADisplayHasDisplayAndTheWindowSayWhyInOneLine_data()
    {
        QTest::addColumn<QStringList>("variables");
        QTest::addColumn<QString>("reason");
        const QString none = "no display is set (DISPLAY and WAYLAND_DISPLAY are empty)";
        const QString unusable = " cannot be used: it is not there or refuses this user";
        QTest::newRow("unset") << QStringList() << none;
        QTest::newRow("empty") << QStringList{"DISPLAY=", "WAYLAND_DISPLAY=", "QT_QPA_PLATFORM="} << none;
        QTest::newRow("stale") << QStringList{staleDisplay} << "the display \":4077\" (DISPLAY)" + unusable;
        QTest::newRow("stale Wayland") << QStringList{"WAYLAND_DISPLAY=wayland-4077"}
                                       << "the display \"wayland-4077\" (WAYLAND_DISPLAY)" + unusable;
        QTest::newRow("no such platform") << QStringList{"QT_QPA_PLATFORM=nonsense"}
                                          << "the platform \"nonsense\" (QT_QPA_PLATFORM)" + unusable;
    }
    void withoutADisplayHasDisplayAndTheWindowSayWhyInOneLine()
    {
        QFETCH(QStringList, variables);
        QFETCH(QString, reason);
        const Outcome asked = run({"has-display"}, variables);
        QCOMPARE(asked.errors, QStringList("agv-console: " + reason));
        QCOMPARE(asked.status, 1);
        const Outcome started = run({"--simulate"}, variables);
        QCOMPARE(started.errors,
                 QStringList("agv-console: " + reason +
                             "; \"agv-console calibrate\" does the same job in the terminal"));
        QCOMPARE(started.status, 1);
    }
    void platformsWithoutAScreenNeedNoDisplay_data()
    {
        QTest::addColumn<QStringList>("variables");
        QTest::newRow("offscreen") << QStringList{"QT_QPA_PLATFORM=offscreen"};
        QTest::newRow("minimal") << QStringList{"QT_QPA_PLATFORM=minimal"};
        QTest::newRow("offscreen, stale") << QStringList{"QT_QPA_PLATFORM=offscreen", staleDisplay};
    }
    void platformsWithoutAScreenNeedNoDisplay()
    {
        QFETCH(QStringList, variables);
        const Outcome asked = run({"has-display"}, variables);
        QCOMPARE(asked.errors, QStringList());
        QCOMPARE(asked.status, 0);
    }
    void findsARunningXServer()
    {
        const QString program = QStandardPaths::findExecutable("Xvfb");
        if (program.isEmpty())
            QSKIP("Xvfb is not installed");
        QProcess server;
        server.start(program, {"-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp"});
        while (!server.canReadLine())
            QVERIFY(server.waitForReadyRead(20'000));
        const QString display = "DISPLAY=:" + QString::fromLatin1(server.readLine().trimmed());
        const Outcome asked = run({"has-display"}, {display});
        server.terminate();
        QVERIFY(server.waitForFinished(20'000));
        QCOMPARE(asked.errors, QStringList());
        QCOMPARE(asked.status, 0);
        QCOMPARE(run({"has-display"}, {display}).status, 1);
    }
    void helpAndUsageErrorsNeedNoDisplay()
    {
        QCOMPARE(run({"has-display", "--help"}, {}).status, 0);
        QCOMPARE(run({"has-display", "here"}, {}).status, 2);
        QCOMPARE(run({"--help"}, {}).status, 0);
    }
};

} // namespace agv::app

QTEST_GUILESS_MAIN(agv::app::DisplayTest)
#include "test_display.moc"
