// SPDX-License-Identifier: GPL-3.0-or-later
// A whole turn over real sockets against the simulated plant, started as an operator does.
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace agv::app {
namespace {

QJsonArray jsonFile(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).array() : QJsonArray();
}

QString run(const QStringList& arguments, int& status)
{
    QProcess program;
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(AGV_PROGRAM, arguments);
    status = program.waitForFinished(120'000) ? program.exitCode() : -1;
    return QString::fromUtf8(program.readAllStandardOutput());
}

} // namespace

class CalibrateProgramTest : public QObject {
    Q_OBJECT
private slots:
    void findsASimulatedAgvAndSolvesItsCaptureAgainToTheSamePoseAndItsTableToNearlyTheSame()
    {
        const QTemporaryDir folder;
        int status = 0;
        const QString text = run({"calibrate", "--simulate", "--robot", "1", "--seed", "11", "--battery",
                                  "90", "--method", "fast", "--out", folder.filePath("out")},
                                 status);
        QCOMPARE(status, 0);
        QVERIFY2(text.startsWith("AGV 1 stands at "), qPrintable(text));
        const QJsonArray truths = jsonFile(folder.filePath("out/truth.json"));
        QCOMPARE(truths.size(), 1);
        QVERIFY2(truths[0]["error_mm"].toDouble() < 60.0, qPrintable(text));
        QFile plant(AGV_SOURCE_DIR "/resources/plant.json");
        QVERIFY(plant.exists());
        const QString csv = run({"solve-turn", folder.filePath("out/agv1-capture.txt"), "--plant",
                                 plant.fileName(), "--method", "fast", "--seed", "11", "--json"},
                                status);
        QCOMPARE(status, 0);
        const QJsonObject again = QJsonDocument::fromJson(csv.toUtf8()).object();
        const QJsonObject first = jsonFile(folder.filePath("out/result.json"))[0].toObject();
        for (const char* key : {"x_mm", "y_mm", "heading_deg", "step_deg"}) {
            QVERIFY2(!first[key].isUndefined(), key);
            QCOMPARE(again[key], first[key]);
        }
        QFile table(folder.filePath("out/agv1-table.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QList<QByteArray> rows = table.readAll().split('\n');
        QCOMPARE(rows.size(), 10); // 8 stops, the closing one, and nothing behind the last line
        QVERIFY2(rows[0].count(',') >= 13, rows[0]);
        const QString line =
            run({"solve-turn", table.fileName(), "--plant", plant.fileName(), "--json"}, status);
        QCOMPARE(status, 0);
        const QJsonObject fromTable = QJsonDocument::fromJson(line.toUtf8()).object();
        for (const char* key : {"x_mm", "y_mm", "x_now_mm", "y_now_mm"})
            QVERIFY2(std::abs(fromTable[key].toDouble() - first[key].toDouble()) < 60.0, key);
    }
    void anOlderResultStaysUntilThereIsANewOne()
    {
        const QTemporaryDir folder;
        QFile older(folder.filePath("result.csv"));
        QVERIFY(older.open(QIODevice::WriteOnly));
        older.write("yesterday");
        older.close();
        QProcess program;
        program.start(AGV_PROGRAM, {"calibrate", "--simulate", "--out", folder.path()});
        program.setReadChannel(QProcess::StandardError);
        QVERIFY(program.waitForReadyRead(20'000)); // "AGV 1: stop 1 of 9"
        program.terminate();
        QVERIFY(program.waitForFinished(20'000));
        QCOMPARE(program.exitCode(), 143);
        QVERIFY(older.open(QIODevice::ReadOnly));
        QCOMPARE(older.readAll(), "yesterday");
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList("result.csv"));
    }
    void aRobotThatDoesNotExistIsWrongUsage()
    {
        int status = 0;
        QCOMPARE(run({"calibrate", "--simulate", "--robot", "99"}, status), QString());
        QCOMPARE(status, 2);
    }
    void aSpeedThatThePlantFileDoesNotAllowIsWrongUsage()
    {
        const QTemporaryDir folder;
        QFile plant(folder.filePath("plant.json"));
        QVERIFY(plant.open(QIODevice::WriteOnly));
        plant.write(R"({"format": "agv-plant", "version": 1, "size": {"width_mm": 3000, "height_mm": 3000},
            "agvs": [{"id": 1, "turn_speed_mm_s": 100, "max_speed_mm_s": 150, "sleeptime_ms": 2000}]})");
        plant.close();
        int status = 0;
        run({"calibrate", "--simulate", "--plant", plant.fileName(), "--speed", "151"}, status);
        QCOMPARE(status, 2);
        // So slow that a step of 45 degrees would take 20 s.
        run({"calibrate", "--simulate", "--plant", plant.fileName(), "--speed", "10"}, status);
        QCOMPARE(status, 2);
    }
    void aBadPlantFileEndsWithStatusOne()
    {
        int status = 0;
        run({"calibrate", "--simulate", "--plant", "/no/such/plant.json"}, status);
        QCOMPARE(status, 1);
    }
};

} // namespace agv::app

QTEST_GUILESS_MAIN(agv::app::CalibrateProgramTest)
#include "test_calibrate_program.moc"
