// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/simulate.h"

#include <array>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

using namespace agv;
using namespace agv::app;

namespace {

struct Outcome {
    int status = -1;
    QList<QJsonObject> lines; ///< of standard output, those that are JSON
    QByteArray output;
    QByteArray errors;
};

/// Standard input, output and error of this process, exchanged for the life of the object.
class Redirected {
public:
    Redirected(int descriptor, int replacement) : m_descriptor(descriptor), m_saved(::dup(descriptor))
    {
        ::dup2(replacement, descriptor);
        ::close(replacement);
    }
    ~Redirected()
    {
        ::dup2(m_saved, m_descriptor);
        ::close(m_saved);
    }
    Redirected(const Redirected&) = delete;
    Redirected& operator=(const Redirected&) = delete;

private:
    int m_descriptor;
    int m_saved;
};

int openFor(const QString& path)
{
    return ::open(path.toLocal8Bit().constData(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Runs the command with `input` on a pipe that then ends, which ends the command.
Outcome run(const SimulateArguments& arguments, const QByteArray& input = {})
{
    const QTemporaryDir folder;
    const QString output = folder.filePath("out");
    const QString errors = folder.filePath("err");
    Outcome outcome;
    {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0 ||
            ::write(ends[1], input.data(), input.size()) != input.size())
            return outcome;
        ::close(ends[1]);
        const Redirected in(STDIN_FILENO, ends[0]);
        const Redirected out(STDOUT_FILENO, openFor(output));
        const Redirected err(STDERR_FILENO, openFor(errors));
        outcome.status = runSimulate(arguments);
        std::fflush(stdout);
    }
    outcome.output = contentOf(output);
    outcome.errors = contentOf(errors);
    for (const QByteArray& line : outcome.output.split('\n'))
        if (const QJsonDocument json = QJsonDocument::fromJson(line); json.isObject())
            outcome.lines.append(json.object());
    return outcome;
}

} // namespace

class TestSimulateCommand : public QObject {
    Q_OBJECT

private slots:
    void saysWhenItIsReadyAndEndsWithItsInput();
    void answersEachCommandWithOneLine();
    void quitsWhenAskedTo();
    void sameSeedGivesTheSameStart();
    void batteryIsThatOfTheArgument();
    void smallFieldHasOneRobot();
    void badPlantFileIsNamed();
    void portInUseEndsIt();
    void truthLogIsWritten();
    void truthLogThatCannotBeWrittenEndsIt();
    void emulatorFilesAreWritten();
    void emulatorFolderThatCannotBeMadeIsNamed();
};

void TestSimulateCommand::saysWhenItIsReadyAndEndsWithItsInput()
{
    const Outcome outcome = run({});
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.errors, QByteArray());
    QCOMPARE(outcome.lines.size(), 1);
    const QJsonObject& ready = outcome.lines[0];
    QVERIFY(ready["ready"].toBool());
    QCOMPARE(ready["seed"].toInt(), 1);
    QCOMPARE(ready["readers"].toArray().size(), 4);
    QCOMPARE(ready["robots"].toArray().size(), 4);
    QCOMPARE(ready["truth"].toArray().size(), 4);
    QCOMPARE(ready["readers"].toArray()[0].toObject()["host"].toString(), QStringLiteral("127.0.0.2"));
}

void TestSimulateCommand::answersEachCommandWithOneLine()
{
    const Outcome outcome = run({}, "help\ntruth\nfly\nbattery 1 50\nbattery 7 50\nslip 1 10");
    QCOMPARE(outcome.lines.size(), 7);
    QVERIFY(outcome.lines[1]["help"].isArray());
    QCOMPARE(outcome.lines[2]["truth"].toArray().size(), 4);
    QVERIFY(outcome.lines[3]["error"].toString().contains("'fly'"));
    QVERIFY(outcome.lines[4]["ok"].toBool());
    QVERIFY(outcome.lines[5]["error"].toString().contains("no robot 7"));
    QVERIFY(outcome.lines[6]["ok"].toBool());
}

void TestSimulateCommand::quitsWhenAskedTo()
{
    SimulateArguments arguments;
    const Outcome outcome = run(arguments, "quit\n");
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.lines.size(), 2);
    QCOMPARE(outcome.lines[1]["command"].toString(), QStringLiteral("quit"));
}

void TestSimulateCommand::sameSeedGivesTheSameStart()
{
    SimulateArguments arguments;
    arguments.seed = 5;
    const QJsonValue first = run(arguments).lines[0]["truth"];
    QCOMPARE(run(arguments).lines[0]["truth"], first);
    arguments.seed = 6;
    QVERIFY(run(arguments).lines[0]["truth"] != first);
}

void TestSimulateCommand::batteryIsThatOfTheArgument()
{
    SimulateArguments arguments;
    arguments.batteryPercent = 35.0;
    for (const QJsonValue& truth : run(arguments).lines[0]["truth"].toArray())
        QCOMPARE(truth.toObject()["charge_percent"].toDouble(), 35.0);
}

void TestSimulateCommand::smallFieldHasOneRobot()
{
    SimulateArguments arguments;
    arguments.smallField = true;
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.lines[0]["robots"].toArray().size(), 1);
}

void TestSimulateCommand::badPlantFileIsNamed()
{
    SimulateArguments arguments;
    arguments.plantFile = "/no/such/plant.json";
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.status, 1);
    QVERIFY(outcome.errors.contains("/no/such/plant.json"));
    QCOMPARE(outcome.output, QByteArray());
}

void TestSimulateCommand::portInUseEndsIt()
{
    QTcpServer other;
    QVERIFY(other.listen(QHostAddress(QStringLiteral("127.0.0.2")), 8883));
    SimulateArguments arguments;
    arguments.fixedReaderPorts = true;
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.status, 1);
    QVERIFY(outcome.errors.contains("127.0.0.2:8883"));
}

void TestSimulateCommand::truthLogIsWritten()
{
    const QTemporaryDir folder;
    SimulateArguments arguments;
    arguments.truthLog = folder.filePath("truth.csv").toStdString();
    std::array<int, 2> ends{};
    // The command runs until its truth log has rows: the input ends only then.
    QCOMPARE(::pipe2(ends.data(), O_CLOEXEC), 0);
    QTimer poll;
    connect(&poll, &QTimer::timeout, [&] {
        if (contentOf(folder.filePath("truth.csv")).count('\n') > 9) {
            poll.stop();
            ::close(ends[1]);
        }
    });
    poll.start(20);
    int status = -1;
    {
        const Redirected in(STDIN_FILENO, ends[0]);
        const Redirected out(STDOUT_FILENO, openFor(folder.filePath("out")));
        status = runSimulate(arguments);
    }
    QCOMPARE(status, 0);
    const QList<QByteArray> rows = contentOf(folder.filePath("truth.csv")).split('\n');
    QVERIFY(rows[0].startsWith("time_s,robot,x_mm"));
    QCOMPARE(rows[1].split(',').size(), rows[0].split(',').size());
}

void TestSimulateCommand::truthLogThatCannotBeWrittenEndsIt()
{
    SimulateArguments arguments;
    arguments.truthLog = "/no/such/folder/truth.csv";
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.status, 1);
    QVERIFY(outcome.errors.contains("/no/such/folder/truth.csv"));
}

void TestSimulateCommand::emulatorFilesAreWritten()
{
    const QTemporaryDir folder;
    SimulateArguments arguments;
    arguments.emulatorFolder = folder.path().toStdString();
    arguments.emulator.readerLike = true;
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.status, 0);
    const QList<QByteArray> paths = outcome.output.trimmed().split('\n');
    QCOMPARE(paths.size(), 2);
    QVERIFY(contentOf(paths[0]).startsWith("0 SCAN:+UID=28+RSSI=0<\\r>\n"));
    QVERIFY(contentOf(paths[1]).startsWith("   121\n"));
}

void TestSimulateCommand::emulatorFolderThatCannotBeMadeIsNamed()
{
    SimulateArguments arguments;
    arguments.emulatorFolder = "/dev/null/files";
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.status, 1);
    QVERIFY(outcome.errors.contains("/dev/null/files"));
}

QTEST_GUILESS_MAIN(TestSimulateCommand)
#include "test_simulate_command.moc"
