// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a command whose standard output goes nowhere.
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

#include <sys/resource.h>
#include <unistd.h>

namespace agv::app {
namespace {

const QStringList commands{
    "--help",
    "--version",
    "calibrate --help",
    "simulate --help",
    "trainer --help",
    "plant --help",
    "solve-turn --help",
    "locate --help",
    "fuse --help",
    "locate --list-methods",
    "locate --height 0.2 --anchors " AGV_TEST_DATA "/uwb/anchors.csv " AGV_TEST_DATA "/uwb/points.csv",
    "plant check " AGV_SOURCE_DIR "/resources/plant.json",
    "plant export-tags " AGV_SOURCE_DIR "/resources/plant.json",
    "solve-turn --field 3x3 --method classic " AGV_TEST_DATA "/turns/table10.csv",
};

/// The writing end of a pipe that nobody reads.
class DeadPipe {
public:
    DeadPipe()
    {
        int ends[2] = {-1, -1};
        if (::pipe(ends) == 0)
            ::close(ends[0]);
        m_end = ends[1];
    }
    DeadPipe(const DeadPipe&) = delete;
    DeadPipe& operator=(const DeadPipe&) = delete;
    ~DeadPipe() { ::close(m_end); }
    int end() const { return m_end; }

private:
    int m_end = -1;
};

} // namespace

class StandardOutputTest : public QObject {
    Q_OBJECT
private slots:
    void aFullDiskIsSaidAndEndsWithOne_data() { addCommands(); }
    void aFullDiskIsSaidAndEndsWithOne()
    {
        const QTemporaryDir folder;
        QProcess program;
        program.setStandardOutputFile(folder.filePath("out"));
        program.setChildProcessModifier([] {
            ::signal(SIGXFSZ, SIG_IGN);
            const rlimit nothing{0, 0};
            ::setrlimit(RLIMIT_FSIZE, &nothing);
        });
        QCOMPARE(statusOf(program), 1);
        const QByteArray errors = program.readAllStandardError();
        QVERIFY2(errors.contains("standard output: cannot be written: File too large"), errors);
    }
    void aPipeWithoutReaderEndsACommandSilentlyAsAnyOther_data() { addCommands(); }
    void aPipeWithoutReaderEndsACommandSilentlyAsAnyOther()
    {
        const DeadPipe pipe;
        QProcess program;
        program.setChildProcessModifier([&] { ::dup2(pipe.end(), STDOUT_FILENO); });
        statusOf(program);
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);
        QCOMPARE(program.exitCode(), SIGPIPE);
        QVERIFY(!program.readAllStandardError().contains("cannot be written"));
    }
    void aPipeWithoutReaderIsSaidWhereItsSignalIsIgnored_data() { addCommands(); }
    void aPipeWithoutReaderIsSaidWhereItsSignalIsIgnored()
    {
        const DeadPipe pipe;
        QProcess program;
        program.setChildProcessModifier([&] {
            ::signal(SIGPIPE, SIG_IGN); // as services and some shells do
            ::dup2(pipe.end(), STDOUT_FILENO);
        });
        QCOMPARE(statusOf(program), 1);
        const QByteArray errors = program.readAllStandardError();
        QVERIFY2(errors.contains("standard output: cannot be written: Broken pipe"), errors);
    }

private:
    static void addCommands()
    {
        QTest::addColumn<QStringList>("arguments");
        for (const QString& command : commands)
            QTest::newRow(qPrintable(command)) << command.split(' ');
    }
    static int statusOf(QProcess& program)
    {
        QFETCH(QStringList, arguments);
        program.start(AGV_PROGRAM, arguments);
        return program.waitForFinished(20'000) ? program.exitCode() : -1;
    }
};

} // namespace agv::app

QTEST_GUILESS_MAIN(agv::app::StandardOutputTest)
#include "test_standard_output.moc"
