// SPDX-License-Identifier: GPL-3.0-or-later
// Ends the program itself at different moments of a turn and reads the wire of a robot.
#include "session/scripted_plant.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRandomGenerator>
#include <QSet>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <csignal>
#include <unistd.h>
#include <utility>

namespace agv::session {
namespace {

/// Below the range from which the system takes the ports of outgoing connections: one of those, such as
/// another robot's knock, might hold the port by the time the program listens.
quint16 freePort()
{
    static QSet<quint16> given;
    for (;;) {
        const auto port = static_cast<quint16>(QRandomGenerator::global()->bounded(20000, 32000));
        QTcpServer server;
        if (!given.contains(port) && server.listen(QHostAddress::LocalHost, port)) {
            given.insert(port);
            return port;
        }
    }
}

QByteArray plantText(quint16 listen, quint16 telemetry, quint16 reader)
{
    return QStringLiteral(R"({
  "format": "agv-plant", "version": 1, "name": "Scripted",
  "size": {"width_mm": 1000, "height_mm": 1000},
  "floor_tags": {"radius_mm": 15, "grid": {"columns": 5, "rows": 5, "pitch_mm": 100, "origin_mm": [300, 300],
                 "first_uid": "E004000000000001"}},
  "agvs": [{"id": 1, "name": "AGV 1", "robot_host": "127.0.0.2", "reader": "127.0.0.1:%3"}],
  "listen": {"robots": "127.0.0.1:%1", "telemetry_port": %2}
})")
        .arg(listen)
        .arg(telemetry)
        .arg(reader)
        .toUtf8();
}

/// Dead, but not reaped by its new parent, counts as ended.
bool isAlive(pid_t process)
{
    QFile commandLine(QStringLiteral("/proc/%1/cmdline").arg(process));
    return commandLine.open(QIODevice::ReadOnly) && !commandLine.readAll().isEmpty();
}

enum class Moment { BeforeTheTurn, FirstStop, Turning, Settling, Reading, TurningAgain, ClosingStop };

/// A calibration by the program itself, with a reader and a robot of its own; the robot keeps knocking until
/// the console listens.
class Calibration {
public:
    explicit Calibration(const QStringList& more)
    {
        const quint16 port = freePort();
        QFile file(m_folder.filePath("plant.json"));
        if (!file.open(QIODevice::WriteOnly))
            return;
        file.write(plantText(port, freePort(), reader.port()));
        file.close();
        QObject::connect(&program, &QProcess::readyReadStandardError,
                         [this] { errors += program.readAllStandardError(); });
        program.start(AGV_PROGRAM, QStringList{"calibrate", "--plant", file.fileName(), "--out",
                                               m_folder.filePath("out"), "--method", "fast"} +
                                       more);
        QObject::connect(&m_knock, &QTimer::timeout, [this, port] {
            if (!robot.isConnected())
                robot.connectTo(port);
            else
                m_knock.stop();
        });
        m_knock.start(200);
    }
    ~Calibration()
    {
        if (program.state() != QProcess::NotRunning) {
            program.kill();
            program.waitForFinished();
        }
    }

    /// Plays the robot up to the moment; true when the turn is there.
    bool isAt(Moment moment)
    {
        if (robot.zerosAfter(0) < 5)
            return false;
        if (moment == Moment::BeforeTheTurn) // it waits for the robot's state
            return true;
        if (!std::exchange(m_reported, true))
            robot.report(protocol::StateUpdate{RobotState::Idle});
        if (moment == Moment::FirstStop)
            return robot.zerosAfter(0) >= 6;
        const int motions = moment == Moment::ClosingStop ? 8 : moment == Moment::TurningAgain ? 2 : 1;
        if (robot.motionsAfter(0) < motions)
            return false;
        if (moment == Moment::Turning || moment == Moment::TurningAgain)
            return true;
        reader.setMute(moment == Moment::Reading); // a stop without reads is read for 2 s
        // A measured step ends with the robot's own word.
        if (robot.segmentsDone() < motions && robot.zerosAfter(robot.behindLastMotion()) < 1)
            return false;
        if (!m_stopped.isValid())
            m_stopped.start();
        return moment != Moment::Reading || m_stopped.elapsed() > 250;
    }
    bool reach(Moment moment)
    {
        return QTest::qWaitFor([this, moment] { return isAt(moment); }, 30000);
    }
    /// Sends the signal at that moment.
    void arm(Moment moment, int number)
    {
        QObject::connect(&m_fuse, &QTimer::timeout, [this, moment, number] {
            if (!isAt(moment))
                return;
            m_fuse.stop();
            cut = robot.wire().size();
            signal(number);
        });
        m_fuse.start(5);
    }

    bool hasEnded() const { return program.state() == QProcess::NotRunning; }
    void signal(int number) const { ::kill(static_cast<pid_t>(program.processId()), number); }
    /// The watchdog process; 0: there is none.
    pid_t watchdog() const
    {
        const QString process = QStringLiteral("/proc/%1/task").arg(program.processId());
        for (const QString& thread : QDir(process).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            QFile children(process + '/' + thread + "/children");
            if (!children.open(QIODevice::ReadOnly))
                continue;
            for (const QByteArray& child : children.readAll().simplified().split(' ')) {
                QFile name("/proc/" + child + "/comm");
                if (name.open(QIODevice::ReadOnly) && name.readAll().trimmed() == "agv-guard")
                    return child.toInt();
            }
        }
        return 0;
    }

    ScriptedReader reader;
    ScriptedRobot robot{"127.0.0.2"};
    QProcess program;
    QByteArray errors;
    std::size_t cut = 0; ///< length of the wire when the armed signal was sent

private:
    QTemporaryDir m_folder;
    QTimer m_knock;
    QTimer m_fuse;
    QElapsedTimer m_stopped;
    bool m_reported = false;
};

/// Steps of 400 ms, so that there is time to hit one.
const QStringList slowSteps{"--turn-time", "400"};

} // namespace

class ProgramSafetyTest : public QObject {
    Q_OBJECT
private:
    static bool isInterrupted(const ScriptedRobot& robot, std::size_t from)
    {
        return std::find(robot.wire().begin() + std::ptrdiff_t(from), robot.wire().end(),
                         protocol::RobotCommand(protocol::Interrupt{})) != robot.wire().end();
    }

private slots:
    // Cutting the process: every signal that ends or stops it, at every moment, on the wire of a robot.
    void zeroIsTheLastWordHoweverTheProgramEnds_data()
    {
        QTest::addColumn<Moment>("moment");
        QTest::addColumn<bool>("measured");
        const std::pair<const char*, Moment> moments[] = {
            {"before the turn", Moment::BeforeTheTurn},
            {"at the first stop", Moment::FirstStop},
            {"turning", Moment::Turning},
            {"settling", Moment::Settling},
            {"reading", Moment::Reading},
            {"turning again", Moment::TurningAgain},
            {"at the closing stop", Moment::ClosingStop},
        };
        for (const bool measured : {false, true})
            for (const auto& [name, moment] : moments)
                QTest::newRow(qPrintable(QString(measured ? "measured, " : "timed, ") + name))
                    << moment << measured;
    }
    void zeroIsTheLastWordHoweverTheProgramEnds()
    {
        QFETCH(Moment, moment);
        QFETCH(bool, measured);
        const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGKILL, SIGABRT};
        std::vector<std::unique_ptr<Calibration>> runs; // at the same time, to save some
        for (const int number : numbers) {
            runs.push_back(std::make_unique<Calibration>(
                QStringList{measured ? "--measured" : "--timed"} +
                (moment == Moment::ClosingStop ? QStringList{"--turn-time", "100"} : slowSteps)));
            runs.back()->arm(moment, number);
        }
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const Calibration& run = *runs[i];
            const int number = numbers[i];
            QTRY_VERIFY2_WITH_TIMEOUT(run.hasEnded(), run.errors, 30000);
            const bool orderly = number != SIGKILL && number != SIGABRT;
            QCOMPARE(run.program.exitStatus(), orderly ? QProcess::NormalExit : QProcess::CrashExit);
            if (orderly)
                QVERIFY2(run.program.exitCode() == 128 + number,
                         "exit code " + QByteArray::number(run.program.exitCode()) + ": " + run.errors);
            QTRY_VERIFY_WITH_TIMEOUT(!run.robot.isConnected(), patience_ms);
            const std::size_t from = std::max(run.cut, run.robot.behindLastMotion());
            QVERIFY(isInterrupted(run.robot, from));
            QVERIFY(run.robot.zerosAfter(from) >= 5);
            QCOMPARE(run.robot.wire().back(), protocol::RobotCommand(protocol::DirectDrive{}));
        }
    }
    // Ctrl-Z, a debugger, a hang: the program is there, but does not run.
    void aProgramThatStandsStillHasItsRobotStoppedAndEndsTheTurnWhenItRunsAgain()
    {
        Calibration run(QStringList{"--timed", "--turn-time", "9000"});
        QVERIFY2(run.reach(Moment::Turning), run.errors);
        const std::size_t cut = run.robot.wire().size();
        run.signal(SIGSTOP);
        QTRY_VERIFY_WITH_TIMEOUT(run.robot.zerosAfter(cut) >= 5, patience_ms);
        QVERIFY(isInterrupted(run.robot, cut));
        QVERIFY(run.robot.isConnected());
        run.signal(SIGCONT);
        QTRY_VERIFY_WITH_TIMEOUT(run.hasEnded(), patience_ms);
        QCOMPARE(run.program.exitCode(), 1);
        QVERIFY2(run.errors.contains("its watchdog stopped every robot"), run.errors);
        QCOMPARE(run.robot.motionsAfter(cut), 0);
    }
    void aWatchdogThatEndsIsReplacedAndTheNewOneStopsTheRobot()
    {
        Calibration run(QStringList{"--timed", "--turn-time", "9000"});
        QVERIFY2(run.reach(Moment::Turning), run.errors);
        QTRY_VERIFY_WITH_TIMEOUT(run.watchdog() > 0, patience_ms);
        const pid_t first = run.watchdog();
        ::kill(first, SIGKILL);
        QTRY_VERIFY_WITH_TIMEOUT(run.watchdog() > 0 && run.watchdog() != first, patience_ms);
        QVERIFY2(run.errors.contains("There is no watchdog now"), run.errors);
        const std::size_t cut = run.robot.wire().size();
        run.signal(SIGKILL);
        QTRY_VERIFY_WITH_TIMEOUT(run.robot.zerosAfter(cut) >= 5, patience_ms);
    }
    void theWatchdogEndsWithTheProgram()
    {
        for (const int number : {SIGTERM, SIGKILL}) {
            Calibration run(slowSteps);
            QVERIFY2(run.reach(Moment::FirstStop), run.errors);
            QTRY_VERIFY_WITH_TIMEOUT(run.watchdog() > 0, patience_ms);
            const pid_t watchdog = run.watchdog();
            run.signal(number);
            QTRY_VERIFY_WITH_TIMEOUT(run.hasEnded() && !isAlive(watchdog), patience_ms);
        }
    }
    void aWatchdogOutlivesWhatEndsTheProgram()
    {
        Calibration run(slowSteps);
        QVERIFY2(run.reach(Moment::FirstStop), run.errors);
        QTRY_VERIFY_WITH_TIMEOUT(run.watchdog() > 0, patience_ms);
        const pid_t watchdog = run.watchdog();
        QVERIFY(::getsid(watchdog) == watchdog);
        for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP})
            QCOMPARE(::kill(watchdog, number), 0);
        run.signal(SIGKILL);
        QTRY_VERIFY_WITH_TIMEOUT(run.hasEnded(), patience_ms);
        const std::size_t from = 5; // of the greeting
        QTRY_VERIFY_WITH_TIMEOUT(run.robot.zerosAfter(from) >= 5 && !run.robot.isConnected(), patience_ms);
        QVERIFY(isInterrupted(run.robot, from));
    }
    void cuttingTheReaderEndsTheTurnWithZeroAndStatusOne()
    {
        Calibration run(slowSteps);
        QVERIFY2(run.reach(Moment::Turning), run.errors);
        const std::size_t cut = run.robot.wire().size();
        run.reader.cut();
        QTRY_VERIFY_WITH_TIMEOUT(run.hasEnded(), patience_ms);
        QCOMPARE(run.program.exitCode(), 1);
        QVERIFY(run.program.readAllStandardOutput().contains(
            "AGV 1: no pose. The link to the RFID reader was lost"));
        QTRY_VERIFY_WITH_TIMEOUT(!run.robot.isConnected(), patience_ms);
        QVERIFY(run.robot.zerosAfter(std::max(cut, run.robot.behindLastMotion())) >= 5);
    }
    void aPortInUseIsSaidAndEndsWithStatusOne()
    {
        QTemporaryDir folder;
        QTcpServer occupant;
        QVERIFY(occupant.listen(QHostAddress::LocalHost));
        QFile file(folder.filePath("plant.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(plantText(occupant.serverPort(), freePort(), 8883));
        file.close();
        QProcess program;
        program.start(AGV_PROGRAM,
                      {"calibrate", "--plant", file.fileName(), "--out", folder.filePath("out")});
        QVERIFY(program.waitForFinished(20000));
        QCOMPARE(program.exitCode(), 1);
        QVERIFY(program.readAllStandardError().contains("is in use"));
    }
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::ProgramSafetyTest)
#include "test_program_safety.moc"
