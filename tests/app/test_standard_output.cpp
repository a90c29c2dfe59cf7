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
        program.setChildProcessModifier([&] { ::dup2(pipe.end(), STDOUT_FILENO); });
        // As services do, and some shells; QProcess itself gives the signal its usual meaning again since
        // Qt 6.6.
        QCOMPARE(statusOf(program, {"/bin/sh", "-c", "trap '' PIPE; exec \"$0\" \"$@\""}), 1);
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
    /// `starter`: what starts the command, with its own arguments first.
    static int statusOf(QProcess& program, QStringList starter = {})
    {
        QFETCH(QStringList, arguments);
        starter += QStringList(AGV_PROGRAM) + arguments;
        program.start(starter.takeFirst(), starter);
        return program.waitForFinished(20'000) ? program.exitCode() : -1;
    }
};

} // namespace agv::app

QTEST_GUILESS_MAIN(agv::app::StandardOutputTest)
#include "test_standard_output.moc"
