// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/calibration_run.h"
#include "app/command_line.h"

namespace agv::app {

class CommandLineTest : public QObject {
    Q_OBJECT
private slots:
    void readsACalibration()
    {
        const auto parsed = parseCalibrateArguments(
            {"--plant", "p.json",      "--robot", "2",        "--measured", "--clockwise", "--stops",
             "12",      "--turn-time", "1200",    "--method", "fast",       "--seed",      "7",
             "--out",   "dir",         "--speed", "80",       "--dwell",    "1.5"});
        QVERIFY(parsed.has_value());
        QCOMPARE(parsed->turn.wheelSpeed_m_s, 0.08);
        QVERIFY(parsed->speedGiven);
        QCOMPARE(parsed->turn.maxDwell_s, 1.5);
        QCOMPARE(parsed->plant.plantFile, std::optional<std::string>("p.json"));
        QCOMPARE(parsed->robot, std::optional(2));
        QCOMPARE(parsed->turn.kind, TurnKind::Measured);
        QCOMPARE(parsed->turn.rotation, Rotation::Clockwise);
        QCOMPARE(parsed->turn.stopsPerTurn, 12);
        QCOMPARE(parsed->turn.turnTime_s, 1.2);
        QVERIFY(parsed->turnTimeGiven);
        QCOMPARE(parsed->method, SolveMethod::Fast);
        QCOMPARE(parsed->plant.seed, std::uint64_t{7});
        QCOMPARE(parsed->outFolder, std::optional<std::string>("dir"));
        QVERIFY(!parsed->plant.simulate);
    }
    void aSimulatedCalibrationNeedsNoFolder()
    {
        const auto parsed = parseCalibrateArguments({"--simulate", "--battery", "40"});
        QVERIFY(parsed.has_value());
        QVERIFY(parsed->plant.simulate);
        QCOMPARE(parsed->plant.batteryPercent, std::optional(40.0));
        QVERIFY(!parsed->robot);
        QVERIFY(!parsed->turnTimeGiven);
    }
    void aTurnAtAnotherSpeedTakesThePlantFilesSleeptimeScaledToIt()
    {
        AgvConfig agv;
        agv.turnTime_s = 1.2;
        agv.turnSpeed_m_s = 0.1;
        const auto parameters = [&](const QStringList& options) {
            return parametersFor(agv, *parseCalibrateArguments(QStringList{"--simulate"} + options));
        };
        QCOMPARE(parameters({}).wheelSpeed_m_s, 0.1);
        QCOMPARE(parameters({}).turnTime_s, 1.2);
        QCOMPARE(parameters({"--speed", "50"}).wheelSpeed_m_s, 0.05);
        QCOMPARE(parameters({"--speed", "50"}).turnTime_s, 2.4);
        QCOMPARE(parameters({"--speed", "50", "--turn-time", "900"}).turnTime_s, 0.9);
    }
    void wrongUsageNamesTheOptionAndEndsWithTwo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("expected");
        const auto row = [](const QString& arguments, const char* expected) {
            QTest::newRow(qPrintable(arguments)) << arguments.split(' ') << QString(expected);
        };
        row("--out d --nonsense", "Unknown option 'nonsense'.");
        row("--out d --stops 9", "--stops is \"9\": it must be one of 8, 12, 16.");
        row("--out d --robot x", "--robot is \"x\": it must be a whole number from 1 to 1000000.");
        row("--out d --turn-time 5", "--turn-time is \"5\": it must be a number from 100 to 10000.");
        row("--out d --speed 9", "--speed is \"9\": it must be a number from 10 to 250.");
        row("--out d --speed 251", "--speed is \"251\": it must be a number from 10 to 250.");
        row("--out d --dwell 0.2", "--dwell is \"0.2\": it must be a number from 0.3 to 10.");
        row("--out d --dwell 11", "--dwell is \"11\": it must be a number from 0.3 to 10.");
        row("--out d --method best", "--method is \"best\": it must be one of auto, fast, classic.");
        row("--out d --timed --measured", "--timed and --measured exclude each other.");
        row("--out d --plant p --small-field", "--plant and --small-field exclude each other.");
        row("--out d --battery 50", "--battery needs --simulate.");
        row("--simulate --battery 101", "--battery is \"101\": it must be a number from 0 to 100.");
        row("--plant p", "--out DIR is missing.");
        row("--out d extra", "Unexpected argument \"extra\".");
    }
    void wrongUsageNamesTheOptionAndEndsWithTwo()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, expected);
        const auto parsed = parseCalibrateArguments(arguments);
        QVERIFY(!parsed.has_value());
        QCOMPARE(parsed.error().status, 2);
        QCOMPARE(parsed.error().text,
                 "agv-console calibrate: " + expected + "\nTry \"agv-console calibrate --help\".\n");
    }
    void helpAndVersionGoToStandardOutput()
    {
        for (const auto& exit :
             {parseWindowArguments({"--help"}).error(), parseCalibrateArguments({"-h"}).error(),
              parseSimulateArguments({"--help"}).error(), parseSolveTurnArguments({"--help"}).error(),
              parsePlantArguments({"--help"}).error()}) {
            QCOMPARE(exit.status, 0);
            QVERIFY2(exit.text.startsWith("Usage: agv-console"), qPrintable(exit.text));
        }
        QVERIFY(parseWindowArguments({"--version"}).error().text.startsWith("agv-console "));
    }
    void readsTheWindowsOptions()
    {
        const auto parsed = parseWindowArguments({"--simulate", "--small-field", "--seed", "3"});
        QVERIFY(parsed.has_value());
        QVERIFY(parsed->plant.simulate && parsed->plant.smallField);
        QCOMPARE(parseWindowArguments({"calibrat"}).error().status, 2);
    }
    void readsASimulation()
    {
        const auto parsed = parseSimulateArguments({"--console", "127.0.0.1:2001", "--telemetry-port", "2000",
                                                    "--reader-ports", "fixed", "--parent-guard"});
        QVERIFY(parsed.has_value());
        QCOMPARE(parsed->console, std::optional(Endpoint{"127.0.0.1", 2001}));
        QVERIFY(parsed->fixedReaderPorts && parsed->parentGuard);
        QVERIFY(parsed->uwbDialect == UwbDialect::Trek && !parsed->uwbSlow);
        QCOMPARE(parseSimulateArguments({"--console", "nowhere"}).error().status, 2);
        QCOMPARE(parseSimulateArguments({"--field", "11"}).error().status, 2);
    }
    void readsTheKitOfASimulation()
    {
        const auto parsed =
            parseSimulateArguments({"--uwb-link", "/tmp/uwb", "--uwb-dialect", "ulm4", "--uwb-slow"});
        QVERIFY(parsed.has_value());
        QCOMPARE(parsed->uwbLink, std::optional<std::string>("/tmp/uwb"));
        QVERIFY(parsed->uwbDialect == UwbDialect::UlmFour && parsed->uwbSlow);
        QCOMPARE(parseSimulateArguments({"--uwb-dialect", "unknown"}).error().status, 2);
    }
    void optionsOfTheEmulatorFileNeedIt()
    {
        for (const QString line :
             {"--x 100", "--y 100", "--bearing 0", "--step 30", "--stops 9", "--number 3", "--field 3x3",
              "--reader-like", "--changes-only", "--hexadecimal"}) {
            const auto parsed = parseSimulateArguments(line.split(' '));
            QVERIFY2(!parsed, qPrintable(line));
            QCOMPARE(parsed.error().status, 2);
            QVERIFY2(parsed.error().text.contains(line.section(' ', 0, 0) + " needs --emulator-file."),
                     qPrintable(parsed.error().text));
            QVERIFY(
                parseSimulateArguments(QStringList{"--emulator-file", "d"} + line.split(' ')).has_value());
        }
    }
    void readsASolveTurn()
    {
        const auto parsed = parseSolveTurnArguments({"a.jsonl", "b.txt", "--field", "11x11", "--json"});
        QVERIFY(parsed.has_value());
        QCOMPARE(parsed->files.size(), std::size_t{2});
        QVERIFY(parsed->json);
        QCOMPARE(parseSolveTurnArguments({}).error().status, 2);
        QCOMPARE(parseSolveTurnArguments({"a", "--plant", "p", "--field", "3x3"}).error().status, 2);
    }
    void readsWorkOnPlantFiles()
    {
        const auto checks = parsePlantArguments({"check", "a.json", "b.json"});
        QVERIFY(checks.has_value());
        QCOMPARE(checks->action, PlantAction::Check);
        QCOMPARE(checks->plantFiles, (std::vector<std::string>{"a.json", "b.json"}));
        const auto imports = parsePlantArguments({"import-tags", "a.json", "t.csv", "--merge", "--out", "b"});
        QVERIFY(imports.has_value());
        QCOMPARE(imports->plantFiles, std::vector<std::string>{"a.json"});
        QCOMPARE(imports->csvFile, std::string("t.csv"));
        QCOMPARE(imports->outFile, std::optional<std::string>("b"));
        QVERIFY(imports->merge);
        const auto complaint = [](const QString& line) {
            const auto parsed = parsePlantArguments(line.split(' '));
            return parsed ? "accepted" : parsed.error().text.section(": ", 1).section(".\n", 0, 0);
        };
        QCOMPARE(complaint("mend a"), "ACTION must be one of check, export-tags, import-tags");
        QCOMPARE(complaint("check"), "no FILE was given");
        QCOMPARE(complaint("import-tags a"), "import-tags needs a plant file and a table");
        QCOMPARE(complaint("export-tags a b"), "export-tags needs one plant file");
        QCOMPARE(complaint("check a --merge"), "--merge belongs to import-tags");
        QCOMPARE(complaint("check a --out b"), "check writes nothing to --out");
    }
    void readsALocateAndAFuse()
    {
        const auto locate =
            parseLocateArguments({"a.csv", "b.txt", "--anchors", "anchors.csv", "--height", "0.9", "--method",
                                  "all", "--calibrate", "r.csv:t.csv", "--truth", "t.csv", "--by", "point",
                                  "--csv", "out.csv", "--seed", "4"});
        QVERIFY(locate.has_value());
        QVERIFY(!locate->fuse);
        QCOMPARE(locate->inputs, (std::vector<std::string>{"a.csv", "b.txt"}));
        QCOMPARE(locate->height_m, std::optional(0.9));
        QCOMPARE(locate->calibrate, std::optional<std::string>("r.csv:t.csv"));
        QCOMPARE(locate->by, std::optional<std::string>("point"));
        QCOMPARE(locate->seed, std::uint64_t{4});
        QVERIFY(parseLocateArguments({"a.csv", "--3d"})->inSpace);
        QVERIFY(parseLocateArguments({"--list-methods"})->listMethods);
        const auto fuse =
            parseFuseArguments({"a.csv", "--odometry", "o.csv", "--wheel-distance", "0.3", "--heading", "180",
                                "--start", "1.5,-2", "--rfid", "r.csv", "--mount", "80,-25"});
        QVERIFY(fuse.has_value());
        QVERIFY(fuse->fuse);
        QCOMPARE(fuse->track_m, std::optional(0.3));
        QCOMPARE(*fuse->startHeading, radFromDeg(180.0));
        QCOMPARE(*fuse->startPosition, (Point2{1.5, -2.0}));
        QCOMPARE(*fuse->mount, (Point2{0.08, -0.025}));
        QVERIFY(parseFuseArguments({"--rfid", "r.csv"})->inputs.empty());
    }
    void wrongUsageOfLocateAndFuseNamesTheOption()
    {
        const auto locate = [](const char* line) {
            return parseLocateArguments(QString(line).split(' ')).error();
        };
        const auto fuse = [](const char* line) {
            return parseFuseArguments(QString(line).split(' ')).error();
        };
        QVERIFY(locate("--height 1").text.contains("no INPUT was given"));
        QVERIFY(locate("a --height high").text.contains("--height is \"high\""));
        QVERIFY(locate("a --odometry o").text.contains("odometry"));
        QVERIFY(fuse("a").text.contains("needs --odometry or --rfid"));
        QVERIFY(fuse("a --rfid r --start 1").text.contains("must be X,Y in metres"));
        QVERIFY(
            fuse("a --rfid r --mount 1,9000").text.contains("must be X,Y in mm, each from -2000 to 2000"));
        QVERIFY(fuse("--odometry o").text.contains("no INPUT was given"));
        QCOMPARE(fuse("a --rfid r --heading north").status, 2);
    }
};

} // namespace agv::app

QTEST_GUILESS_MAIN(agv::app::CommandLineTest)
#include "test_command_line.moc"
