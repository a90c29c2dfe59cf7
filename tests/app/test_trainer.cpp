// SPDX-License-Identifier: GPL-3.0-or-later
// Breaks things in the plant of a running calibration, as a trainer does from a second terminal.
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace agv::app {
namespace {

struct Answer {
    int status = -1;
    QByteArray output;
    QByteArray errors;
};

Answer run(const QStringList& arguments, const QByteArray& input = {})
{
    QProcess program;
    program.start(AGV_PROGRAM, arguments);
    program.write(input);
    program.closeWriteChannel();
    const bool ended = program.waitForFinished(20'000);
    return {ended ? program.exitCode() : -1, program.readAllStandardOutput(), program.readAllStandardError()};
}

} // namespace

class TrainerTest : public QObject {
    Q_OBJECT
private slots:
    void steersThePlantOfARunningCalibration()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("plant");
        QProcess console;
        console.start(AGV_PROGRAM, {"calibrate", "--simulate", "--robot", "2", "--control", path});
        QByteArray progress;
        QTRY_VERIFY_WITH_TIMEOUT((progress += console.readAllStandardError()).contains("stop 1 of 9"),
                                 30'000);
        const QStringList trainer{"trainer", "--control", path};
        Answer answer = run(trainer + QStringList{"antenna", "2", "-5", "0"});
        QCOMPARE(answer.status, 0);
        QCOMPARE(answer.output, "{\"command\":\"antenna\",\"ok\":true}\n");
        answer = run(trainer + QStringList{"battery", "9", "50"});
        QCOMPARE(answer.status, 1);
        QCOMPARE(answer.errors, "agv-console trainer: the plant has no robot 9\n");
        answer = run(trainer, "help\nnonsense\n\ncut robot 2 60\n");
        QCOMPARE(answer.status, 1); // one of them
        QVERIFY(answer.output.startsWith("help: this list\n"));
        QVERIFY(answer.output.endsWith("{\"command\":\"cut\",\"ok\":true}\n"));
        QVERIFY(answer.errors.contains("unknown command 'nonsense'"));
        QVERIFY(console.waitForFinished(60'000));
        QCOMPARE(console.exitCode(), 1);
        QVERIFY(console.readAllStandardOutput().contains("AGV 2: no pose."));
        QVERIFY(!QFile::exists(path));
    }
    void saysWhenThereIsNoPlant()
    {
        const Answer answer = run({"trainer", "--control", "/no/such/plant", "truth"});
        QCOMPARE(answer.status, 1);
        QVERIFY(answer.errors.startsWith("agv-console trainer: no simulated plant takes commands at "));
    }
    void needsAPath()
    {
        const Answer answer = run({"trainer", "truth"});
        QCOMPARE(answer.status, 2);
        QVERIFY(answer.errors.contains("--control PATH is missing"));
    }
};

} // namespace agv::app

QTEST_GUILESS_MAIN(agv::app::TrainerTest)
#include "test_trainer.moc"
