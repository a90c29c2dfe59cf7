// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/solve_turn.h"

#include "app/tag_fields.h"
#include "core/text_file.h"

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace agv::app {
namespace {

using Json = nlohmann::json;

const std::string turns = std::string(AGV_TEST_DATA) + "/turns/";
const std::string vectors = std::string(AGV_TEST_DATA) + "/vectors/";

struct Outcome {
    int status = -1;
    std::string out;
    std::string err;
};

Outcome run(const SolveTurnArguments& arguments, const std::string& input = {})
{
    std::istringstream in(input);
    std::ostringstream out;
    std::ostringstream err;
    const int status = runSolveTurn(arguments, in, out, err);
    return {status, out.str(), err.str()};
}

std::vector<Json> jsonRows(const Outcome& outcome)
{
    std::vector<Json> rows;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);)
        rows.push_back(Json::parse(line));
    return rows;
}

SolveTurnArguments argumentsFor(std::vector<std::string> files, SolveMethod method = SolveMethod::Auto)
{
    SolveTurnArguments arguments;
    arguments.files = std::move(files);
    arguments.method = method;
    arguments.json = true;
    return arguments;
}

double angleBetween_deg(double a, double b) { return std::abs(std::remainder(a - b, 360.0)); }

/// A folder of its own that is removed at the end.
class SolveTurnFiles : public testing::Test {
protected:
    SolveTurnFiles() { std::filesystem::create_directories(folder); }
    ~SolveTurnFiles() override { std::filesystem::remove_all(folder); }

    std::string file(const std::string& name, const std::string& text) const
    {
        const auto path = folder / name;
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }

    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("agv-solve-turn-" + std::to_string(::getpid()));
};

TEST(SolveTurn, findsThePoseOfTheSeedsRecordedTable)
{
    const Outcome outcome = run(argumentsFor({turns + "table10.csv"}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json row = jsonRows(outcome).at(0);
    // Nominal pose of the experiment: the middle tag, front along +x.
    EXPECT_LT(std::hypot(row["x_mm"].get<double>() - 100.0, row["y_mm"].get<double>() - 100.0), 12.0);
    EXPECT_LT(std::abs(row["heading_deg"].get<double>()), 5.0);
    EXPECT_EQ(row["direction"], "cw");
    EXPECT_GE(row["step_deg"].get<double>(), 40.0);
    EXPECT_LE(row["step_deg"].get<double>(), 44.5);
    EXPECT_GE(row["sleeptime_ms"].get<double>(), 1140.0);
    EXPECT_LE(row["sleeptime_ms"].get<double>(), 1265.0);
    EXPECT_NE(outcome.err.find("3x3 test field"), std::string::npos) << outcome.err;
}

TEST(SolveTurn, findsThePoseOfEmulatorFilesOfEveryKind)
{
    for (const char* name : {"emulator_filtered11.txt", "emulator_reader12.txt", "emulator_changes13.txt",
                             "emulator_reader_changes14.txt"}) {
        const Outcome outcome = run(argumentsFor({turns + name}));
        ASSERT_EQ(outcome.status, 0) << name << outcome.err;
        const Json row = jsonRows(outcome).at(0);
        EXPECT_LT(std::hypot(row["x_mm"].get<double>() - 225.0, row["y_mm"].get<double>() - 515.0), 5.0)
            << name;
        // The emulator places the antenna at 22.5 degrees; the robot's front is opposite.
        EXPECT_LT(angleBetween_deg(row["heading_deg"].get<double>(), 22.5 + 180.0), 4.0) << name;
        EXPECT_EQ(row["direction"], "ccw") << name;
        EXPECT_NE(outcome.err.find("side file"), std::string::npos) << outcome.err;
    }
}

TEST(SolveTurn, findsThePoseOfAReaderCapture)
{
    SolveTurnArguments arguments = argumentsFor({turns + "capture_small_field.txt"});
    for (const bool withPlant : {false, true}) {
        if (withPlant)
            arguments.plantFile = AGV_SOURCE_DIR "/resources/small-field.json";
        const Outcome outcome = run(arguments);
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const Json row = jsonRows(outcome).at(0);
        EXPECT_LT(std::hypot(row["x_mm"].get<double>() - 106.0, row["y_mm"].get<double>() - 93.0), 5.0);
        EXPECT_LT(angleBetween_deg(row["heading_deg"].get<double>(), 130.0 - 180.0), 4.0);
        EXPECT_EQ(row["direction"], "cw");
    }
}

TEST_F(SolveTurnFiles, everyMethodSolvesJsonLinesInOrder)
{
    std::ifstream all(vectors + "rfid_A0_clean.jsonl");
    std::string text;
    std::vector<Json> truth;
    for (std::string line; truth.size() < 6 && std::getline(all, line);) {
        text += line + "\n";
        truth.push_back(Json::parse(line));
    }
    const std::string path = file("turns", text);
    for (const auto& [method, tolerance_mm] :
         {std::pair{SolveMethod::Auto, 4.0}, {SolveMethod::Fast, 10.0}, {SolveMethod::Classic, 80.0}}) {
        SolveTurnArguments arguments = argumentsFor({path}, method);
        arguments.field = "11x11";
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        const std::vector<Json> rows = jsonRows(outcome);
        ASSERT_EQ(rows.size(), truth.size());
        for (std::size_t turn = 0; turn < rows.size(); ++turn) {
            EXPECT_EQ(rows[turn]["id"], path + ":" + std::to_string(turn + 1));
            EXPECT_EQ(rows[turn]["method"], toText(method));
            EXPECT_LT(std::hypot(rows[turn]["x_mm"].get<double>() - truth[turn]["x"].get<double>(),
                                 rows[turn]["y_mm"].get<double>() - truth[turn]["y"].get<double>()),
                      tolerance_mm)
                << toText(method) << " turn " << turn;
        }
    }
}

TEST(SolveTurn, givesTheSameOutputEveryTime)
{
    SolveTurnArguments arguments = argumentsFor({turns + "table10.csv", turns + "emulator_filtered11.txt"});
    const std::regex elapsed("\"elapsed_ms\":[^,]*");
    const std::string first = std::regex_replace(run(arguments).out, elapsed, "");
    EXPECT_EQ(std::regex_replace(run(arguments).out, elapsed, ""), first);
    arguments.seed = 2;
    EXPECT_NE(std::regex_replace(run(arguments).out, elapsed, ""), first);
}

TEST_F(SolveTurnFiles, badTurnsAndFilesAreNamedAndStopNoOther)
{
    const std::string mixed = file("mixed", "{\"rows\": [[[1, 9]]]}\n{\"rows\": [[], []]}\nnonsense\n");
    const std::string empty = file("empty", "");
    SolveTurnArguments arguments =
        argumentsFor({mixed, "no/such/file", empty, turns + "table10.csv"}, SolveMethod::Classic);
    arguments.field = "3x3";
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    const std::vector<Json> rows = jsonRows(outcome);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0]["status"], "bad_input");
    EXPECT_EQ(rows[1]["status"], "no_reads");
    EXPECT_EQ(rows[2]["status"], "bad_input");
    EXPECT_EQ(rows[3]["status"], "ok");
    EXPECT_NE(outcome.err.find(mixed + ":1: RSSI '9'"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(mixed + ":2: turn 2 has no pose: no_reads"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(mixed + ":3: not a JSON object"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("no/such/file: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(empty + ": holds no turns"), std::string::npos) << outcome.err;
}

TEST_F(SolveTurnFiles, csvGoesToStandardOutputOrToTheFileAsked)
{
    SolveTurnArguments arguments = argumentsFor({turns + "table10.csv"}, SolveMethod::Classic);
    arguments.json = false;
    const Outcome printed = run(arguments);
    EXPECT_EQ(printed.status, 0);
    EXPECT_TRUE(printed.out.starts_with("id,status,x_mm,"));
    EXPECT_EQ(std::ranges::count(printed.out, '\n'), 2);

    arguments.csvFile = (folder / "out.csv").string();
    const Outcome written = run(arguments);
    EXPECT_EQ(written.status, 0);
    EXPECT_EQ(written.out, "");
    EXPECT_TRUE(readTextFile(*arguments.csvFile, 1U << 20U)->starts_with("id,status,x_mm,"));

    arguments.json = true;
    EXPECT_EQ(jsonRows(run(arguments)).size(), 1U);

    arguments.csvFile = (folder / "missing" / "out.csv").string();
    const Outcome failed = run(arguments);
    EXPECT_EQ(failed.status, 1);
    EXPECT_NE(failed.err.find("out.csv: cannot be written: No such file or directory; nothing was solved"),
              std::string::npos);
}

TEST_F(SolveTurnFiles, solvingEndsWhenNobodyGetsTheRows)
{
    SolveTurnArguments arguments =
        argumentsFor({turns + "table10.csv", "no/such/file"}, SolveMethod::Classic);
    arguments.csvFile = (folder / "out.csv").string();
    std::istringstream in;
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    std::ostringstream err;
    EXPECT_EQ(runSolveTurn(arguments, in, out, err), 1);
    EXPECT_EQ(err.str().find("no/such/file"), std::string::npos) << err.str();
    EXPECT_NE(err.str().find("standard output: cannot be written"), std::string::npos) << err.str();
    EXPECT_FALSE(std::filesystem::exists(*arguments.csvFile));
}

TEST(SolveTurn, aDashIsStandardInput)
{
    const std::string table = readTextFile(turns + "table10.csv", 1U << 20U).value();
    SolveTurnArguments arguments = argumentsFor({"-"}, SolveMethod::Classic);
    const Outcome outcome = run(arguments, table);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(jsonRows(outcome).at(0)["id"], "-:1");
    const Outcome nonsense = run(arguments, "nonsense\n");
    EXPECT_EQ(nonsense.status, 1);
    EXPECT_TRUE(nonsense.err.starts_with("-: holds no turns")) << nonsense.err;
}

TEST_F(SolveTurnFiles, aPipeIsReadToItsEndAsOftenAsItsTurnsMustBeParsed)
{
    // Tags of the 11 x 11 field: without --field they are parsed with the 3 x 3 field's first.
    const std::string line = R"({"rows": [[[81, 0], [82, 7]], [[83, 4]], [[84, 4]]]})";
    std::string text;
    while (text.size() < 100'000) // more than a pipe holds at once
        text += line + "\n";
    const std::string pipe = (folder / "pipe").string();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::jthread writer([&] { std::ofstream(pipe) << text; });
    const Outcome fromPipe = run(argumentsFor({pipe}, SolveMethod::Classic));
    writer.join();
    const Outcome fromFile = run(argumentsFor({file("turns", text)}, SolveMethod::Classic));
    EXPECT_EQ(jsonRows(fromPipe).size(), text.size() / (line.size() + 1));
    ASSERT_EQ(jsonRows(fromPipe).size(), jsonRows(fromFile).size());
    EXPECT_NE(fromPipe.err.find("taking the 11x11 field"), std::string::npos) << fromPipe.err;
    EXPECT_EQ(jsonRows(fromPipe).back()["status"], jsonRows(fromFile).back()["status"]);
}

TEST_F(SolveTurnFiles, aFileOrPipeOrInputWithoutEndIsRefusedAtItsLimit)
{
    const std::string endless(65U << 20U, '\n');
    const std::string pipe = (folder / "pipe").string();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const auto handler = ::signal(SIGPIPE, SIG_IGN); // the reader goes away
    std::jthread writer([&] { std::ofstream(pipe) << endless; });
    const Outcome fromPipe = run(argumentsFor({pipe}));
    writer.join();
    ::signal(SIGPIPE, handler);
    for (const auto& [outcome, name] :
         {std::pair(fromPipe, pipe), std::pair(run(argumentsFor({"-"}), endless), std::string("-"))}) {
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(outcome.err, name + ": is larger than 64 MB; this is hardly the file you meant\n");
    }
}

TEST_F(SolveTurnFiles, aLongFileIsSolvedInItsOrder)
{
    const std::string line = R"({"rows": [[[1, 4], [2, 3]], [], [[4, 3]]]})";
    std::string text;
    for (int turn = 1; turn <= 70; ++turn)
        text += turn % 10 == 0 ? "nonsense\n" : line + "\n";
    SolveTurnArguments arguments = argumentsFor({file("turns", text)}, SolveMethod::Classic);
    arguments.field = "3x3";
    const std::vector<Json> rows = jsonRows(run(arguments));
    ASSERT_EQ(rows.size(), 70U);
    for (std::size_t turn = 1; turn <= rows.size(); ++turn) {
        EXPECT_TRUE(rows[turn - 1]["id"].get<std::string>().ends_with(":" + std::to_string(turn)));
        EXPECT_EQ(rows[turn - 1]["status"] == "bad_input", turn % 10 == 0);
    }
}

TEST(SolveTurn, refusesWrongUsageAndDoesNothing)
{
    const auto good = argumentsFor({turns + "table10.csv"}, SolveMethod::Classic);
    std::vector<SolveTurnArguments> wrong(10, good);
    wrong[0].files.clear();
    wrong[1].plantFile = "a";
    wrong[1].field = "3x3";
    wrong[2].robot = RobotId{1};
    wrong[3].pitch_mm = 0.0;
    wrong[4].turnTime_ms = std::nan("");
    wrong[5].step_deg = 181.0;
    wrong[6].field = "3";
    wrong[7].field = "0x3";
    wrong[8].field = "3x3x3";
    wrong[9].field = "99999x3";
    for (std::size_t k = 0; k < wrong.size(); ++k) {
        const Outcome outcome = run(wrong[k]);
        EXPECT_EQ(outcome.status, 2) << k;
        EXPECT_EQ(outcome.out, "") << k;
        EXPECT_TRUE(outcome.err.starts_with("solve-turn: ")) << k;
    }
}

TEST_F(SolveTurnFiles, aBadPlantFileOrRobotIsNamed)
{
    SolveTurnArguments arguments = argumentsFor({turns + "table10.csv"}, SolveMethod::Classic);
    arguments.plantFile = file("plant.json", "{");
    EXPECT_EQ(run(arguments).status, 1);
    EXPECT_NE(run(arguments).err.find("plant.json"), std::string::npos);
    arguments.plantFile = AGV_SOURCE_DIR "/resources/small-field.json";
    arguments.robot = RobotId{77};
    EXPECT_EQ(run(arguments).status, 2);
    EXPECT_NE(run(arguments).err.find("AGV 77"), std::string::npos);
    arguments.robot = RobotId{1};
    EXPECT_EQ(run(arguments).status, 0);
}

TEST(SolveTurn, takesTheStepAndTheSleeptimeOfTheCommandLineWhereTheFileDoesNotSay)
{
    SolveTurnArguments arguments = argumentsFor({turns + "table10.csv"}, SolveMethod::Fast);
    const double suggested = jsonRows(run(arguments)).at(0)["sleeptime_ms"].get<double>();
    arguments.turnTime_ms = 2250.0;
    EXPECT_NEAR(jsonRows(run(arguments)).at(0)["sleeptime_ms"].get<double>(), 2.0 * suggested,
                1e-6 * suggested);
}

TEST(TagFields, numberTheSeedsFieldAsItsTable13)
{
    const std::vector<FloorTag> tags = seedTestField();
    ASSERT_EQ(tags.size(), 9U);
    EXPECT_EQ(fullText(tags[5].uid), "E00401503A5BD691");
    EXPECT_EQ(tags[5].number, 6);
    EXPECT_NEAR(tags[5].position.x, 0.1, 1e-12);
    EXPECT_NEAR(tags[5].position.y, 0.2, 1e-12);
    EXPECT_EQ(parseField("31x41", 0.1)->size(), 31U * 41U);
}

} // namespace
} // namespace agv::app
