// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/locate_support.h"

#include <cmath>
#include <functional>
#include <set>
#include <tuple>

namespace agv::app {
namespace {

TEST(Locate, WritesAPositionForEveryReportWithTheColumnsOfTheFile)
{
    LocateArguments arguments = argumentsFor({uwb + "points.csv"});
    arguments.height_m = 0.2;
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const auto rows = rowsOf(outcome.out);
    ASSERT_EQ(rows.size(), 36U);
    EXPECT_EQ(rows[0].at("point"), "north-west");
    EXPECT_EQ(rows[0].at("method"), "auto");
    EXPECT_EQ(rows[35].at("point"), "east");
    EXPECT_EQ(rows[35].at("status"), "ok");
    EXPECT_NEAR(number(rows[35].at("x_m")), 3.3, 0.2);
    EXPECT_NEAR(number(rows[35].at("y_m")), 1.1, 0.2);
    EXPECT_EQ(rows[35].at("z_m"), "0.2");
    EXPECT_EQ(rows[35].at("ranges"), "4");
    EXPECT_GT(number(rows[35].at("sd_x_m")), 0.0);
}

TEST(Locate, PrintsTheErrorsOfEveryMethodOnTheSameReports)
{
    LocateArguments arguments = argumentsFor({uwb + "points.csv"});
    arguments.truthFile = uwb + "points-truth.csv";
    arguments.method = "all";
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    std::set<std::string> methods;
    for (auto& row : errorsOf(outcome)) {
        methods.insert(row["method"]);
        EXPECT_LE(number(row["min"]), number(row["median"]));
        EXPECT_LE(number(row["ce50"]), number(row["ce75"]));
        EXPECT_LE(number(row["ce75"]), number(row["ce95"]));
        EXPECT_LE(number(row["ce95"]), number(row["max"]));
        EXPECT_NEAR(number(row["rate"]), 1.0 / 0.28, 0.02) << row["method"];
        if (row["method"] == "static") {
            EXPECT_EQ(row["n"], "36");
            EXPECT_EQ(row["available"], "100.0");
            EXPECT_LT(number(row["rmse"]), 60.0);
        }
    }
    EXPECT_EQ(methods.size(), 16U);
    EXPECT_FALSE(methods.contains("fusion"));
    EXPECT_EQ(run(arguments).out, outcome.out) << "the same input gives the same output";
}

TEST(Locate, TakesTheMethodForStandingTagsOrTheOneForMovingOnes)
{
    for (const auto& [name, method] : {std::pair("points", "static"), {"drive", "ekf-los"}}) {
        LocateArguments arguments = argumentsFor({uwb + name + ".csv"});
        arguments.height_m = 0.2;
        const std::string automatic = run(arguments).out;
        arguments.method = method;
        EXPECT_EQ(automatic, std::regex_replace(run(arguments).out,
                                                std::regex("," + std::string(method) + ","), ",auto,"));
    }
}

TEST(Locate, CountsTheErrorsOfValuesOfAColumnApart)
{
    LocateArguments arguments = argumentsFor({uwb + "points.csv"});
    arguments.truthFile = uwb + "points-truth.csv";
    arguments.method = "gauss-newton";
    for (const auto& [column, count] : {std::pair("point", 3U), {"place", 2U}, {"tag", 1U}}) {
        arguments.by = column;
        EXPECT_EQ(errorsOf(run(arguments)).size(), count) << column;
    }
    arguments.by = "place";
    const auto rows = errorsOf(run(arguments));
    EXPECT_EQ(rows[1].at("place"), "rack");
    EXPECT_GT(number(rows[1].at("rmse")), 2.0 * number(rows[0].at("rmse"))) << "its anchor is hidden";
}

TEST(Locate, TakesTheHeightOfTheTruthWhereNoneIsGiven)
{
    LocateArguments arguments = argumentsFor({uwb + "points.csv"});
    arguments.truthFile = uwb + "points-truth.csv";
    const Answer asTruth = run(arguments);
    EXPECT_NE(asTruth.err.find("taking the height of the truth"), std::string::npos) << asTruth.err;
    arguments.height_m = 0.2;
    EXPECT_EQ(run(arguments).out, asTruth.out);
    arguments.height_m.reset();
    arguments.truthFile.reset();
    EXPECT_NE(run(arguments).err.find("tags on the floor, 0 m"), std::string::npos);
}

TEST(Locate, SolvesForTheHeightWhenAsked)
{
    LocateArguments arguments = argumentsFor({uwb + "points.csv"});
    arguments.truthFile = uwb + "points-truth.csv";
    arguments.inSpace = true;
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto rows = errorsOf(outcome);
    EXPECT_EQ(rows.at(0).at("method"), "gauss-newton-3d");
    EXPECT_NE(rows.at(0).at("bias_z"), "0.0");
    EXPECT_GE(number(rows.at(0).at("median")), number(rows.at(0).at("ce50")));
}

TEST_F(LocateFiles, CalibrationTakesAConstantErrorOut)
{
    // Every range 0.2 m too long.
    std::string shifted = "point,t_s,tag,anchor,range_m,seq\n";
    for (auto& row : rowsOf(read(uwb + "points.csv")))
        shifted += row["point"] + "," + row["t_s"] + ",0," + row["anchor"] + "," +
                   std::to_string(number(row["range_m"]) + 0.2) + "," + row["seq"] + "\n";
    const std::string ranges = file("shifted.csv", shifted);
    LocateArguments arguments = argumentsFor({ranges});
    arguments.truthFile = uwb + "points-truth.csv";
    arguments.method = "huber";
    arguments.by = "point";
    const double before = number(errorsOf(run(arguments)).at(0).at("rmse"));
    arguments.calibrate = ranges + ":" + uwb + "points-truth.csv";
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_LT(number(errorsOf(outcome).at(0).at("rmse")), 0.6 * before);
}

TEST_F(LocateFiles, NoPlaceIsCalibratedByItself)
{
    // Two places whose ranges are wrong in opposite ways: judged by the other one, both come out worse.
    std::string text = "run,t_s,tag,anchor,range_m\n";
    for (const auto& [run, excess] : {std::pair("a", 0.3), {"b", -0.3}})
        for (int k = 0; k < 5; ++k)
            for (const auto& [id, x, y] :
                 {std::tuple(0, 0.0, 0.0), {1, 4.0, 0.0}, {2, 4.0, 3.0}, {3, 0.0, 3.0}})
                text += std::string(run) + "," + std::to_string(k) + ",0," + std::to_string(id) + "," +
                        std::to_string(std::hypot(x - 1.0, y - 1.0) + excess) + "\n";
    const std::string ranges = file("ranges.csv", text);
    const std::string copy = file("copy.csv", text);
    const std::string truth = file("truth.csv", "run,x_m,y_m,z_m\na,1,1,0\nb,1,1,0\n");
    LocateArguments arguments = argumentsFor({ranges, copy});
    arguments.anchorsFile = file("flat.csv", "anchor,x_m,y_m,z_m\n0,0,0,0\n1,4,0,0\n2,4,3,0\n3,0,3,0\n");
    arguments.truthFile = truth;
    arguments.calibrate = ranges + ":" + truth;
    arguments.method = "gauss-newton";
    const auto rows = errorsOf(run(arguments));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_GT(number(rows[0].at("rmse")), 1.5 * number(rows[1].at("rmse")));
}

TEST_F(LocateFiles, BadLinesAndFilesAreNamedAndStopNothing)
{
    const std::string bad = file("bad.csv", "t_s,tag,anchor,range_m\n1,0,0,1\n1,0,one,2\n");
    const std::string none = file("none.txt", "hello\n");
    LocateArguments arguments = argumentsFor({bad, none, "/nowhere/ranges.csv", uwb + "points.csv"});
    arguments.height_m = 0.2;
    const Answer outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find(bad + ":3: anchor: must be a whole number from 0 (is 'one')"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find(none + ": holds no UWB ranges"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("/nowhere/ranges.csv"), std::string::npos);
    EXPECT_EQ(rowsOf(outcome.out).size(), 37U);
}

TEST_F(LocateFiles, BadFilesOfOptionsAreNamedAndThenNothingIsWritten)
{
    const std::string truth = file("truth.csv", "a,b\n1,2\n");
    for (auto change : std::vector<std::function<void(LocateArguments&)>>{
             [](auto& a) { a.anchorsFile = "/nowhere/anchors.csv"; },
             [](auto& a) { a.truthFile = "/nowhere/truth.csv"; }, [&](auto& a) { a.truthFile = truth; },
             [](auto& a) { a.calibrate = "only-one-name"; },
             [&](auto& a) { a.calibrate = uwb + "points.csv:" + truth; },
             [](auto& a) { a.csvFile = "/nowhere/out.csv"; }}) {
        LocateArguments arguments = argumentsFor({uwb + "points.csv"});
        change(arguments);
        const Answer outcome = run(arguments);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err, "");
    }
}

TEST(Locate, WrongUsageIsSaidAndNothingIsDone)
{
    for (auto change : std::vector<std::function<void(LocateArguments&)>>{
             [](auto& a) { a.inputs.clear(); }, [](auto& a) { a.method = "guess"; },
             [](auto& a) { a.method = "aoa"; }, [](auto& a) { a.method = "fusion"; },
             [](auto& a) {
                 a.inSpace = true;
                 a.method = "static";
             },
             [](auto& a) {
                 a.inSpace = true;
                 a.height_m = 1.0;
             },
             [](auto& a) { a.by = "point"; }, [](auto& a) { a.plantFile = "plant.json"; }}) {
        LocateArguments arguments = argumentsFor({uwb + "points.csv"});
        change(arguments);
        const Answer outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("locate: ")) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
}

TEST_F(LocateFiles, ATruthThatDoesNotTellPlacesApartIsRefused)
{
    LocateArguments arguments = argumentsFor({file("plain.csv", "t_s,tag,anchor,range_m\n1,0,0,1\n")});
    arguments.truthFile = uwb + "points-truth.csv";
    const Answer outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("points-truth.csv:3: line 2 has another place"), std::string::npos)
        << outcome.err;
}

TEST_F(LocateFiles, LogsCapturesAndFoldersOfThemAreRead)
{
    const std::string log =
        file("a.txt", "T:090531087:DecaRangeRTLS:LogFile\xff\n"
                      "T:090531088:AP:0:0:0:1600\nT:090531088:AP:1:4000:0:1800\n"
                      "T:090531088:AP:2:4000:3000:1600\nT:090531088:AP:3:0:3000:1800\n"
                      "T:090531088:RR:0:0:2571:2571:1:1\nT:090531088:RR:0:1:2571:2571:1:1\n"
                      "T:090531088:RR:0:2:2571:2571:1:1\nT:090531088:RR:0:3:2571:2571:1:1\n");
    file("b.txt", "mc 0f 00000a0b 00000a0b 00000a0b 00000a0b 095f c1 00024c24 a0:0\r\n");
    file("notes.txt", "nothing to see\n");
    LocateArguments arguments = argumentsFor({folder.string()});
    arguments.height_m = 0.2;
    arguments.method = "gauss-newton";
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto rows = rowsOf(outcome.out);
    ASSERT_EQ(rows.size(), 2U) << outcome.out;
    for (const auto& row : rows)
        EXPECT_NEAR(number(row.at("x_m")), 2.0, 0.2);
    EXPECT_EQ(rows[0].at("nranges"), "1");
    EXPECT_EQ(rows[1].at("nranges"), "");

    arguments.inputs = {log};
    arguments.anchorsFile.reset();
    const Answer own = run(arguments);
    EXPECT_EQ(own.status, 0) << own.err;
    EXPECT_NE(own.err.find("taking the 4 anchors of the log"), std::string::npos) << own.err;
    arguments.inputs = {uwb + "points.csv"};
    EXPECT_EQ(run(arguments).status, 1) << "nobody says where the anchors are";
}

TEST_F(LocateFiles, CorrectionsOfTheExistingProgramAreAddedToItsRanges)
{
    std::string xml = "<config>\n";
    for (const auto& [id, x, y] : {std::tuple(0, 0, 0), {1, 4, 0}, {2, 4, 3}, {3, 0, 3}})
        xml += "<anc ID=\"" + std::to_string(id) + "\" x=\"" + std::to_string(x) + "\" y=\"" +
               std::to_string(y) + "\" z=\"0\" t0=\"-50\"/>\n";
    LocateArguments arguments = argumentsFor({"-"});
    arguments.anchorsFile = file("TREKanc_config.xml", xml + "</config>\n");
    arguments.method = "gauss-newton";
    arguments.height_m = 0.0;
    std::string ranges = "t_s,tag,anchor,range_m\n";
    for (const auto& [id, x, y] : {std::tuple(0, 0.0, 0.0), {1, 4.0, 0.0}, {2, 4.0, 3.0}, {3, 0.0, 3.0}})
        ranges +=
            "1,0," + std::to_string(id) + "," + std::to_string(std::hypot(x - 1.5, y - 1.0) + 0.5) + "\n";
    const auto rows = rowsOf(run(arguments, ranges).out);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_NEAR(number(rows[0].at("x_m")), 1.5, 1e-4);
    EXPECT_NEAR(number(rows[0].at("y_m")), 1.0, 1e-4);
}

TEST(Locate, RangesOfUnknownAnchorsAreLeftOutAndNamed)
{
    LocateArguments arguments = argumentsFor({"-"});
    arguments.height_m = 0.2;
    const Answer outcome = run(arguments, "t_s,tag,anchor,range_m\n1,0,9,1\n1,0,0,1\n");
    EXPECT_EQ(outcome.status, 1) << "one range gives no position";
    EXPECT_NE(outcome.err.find("-: anchor 9 is not in the list; its 1 ranges are left out"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("has no position"), std::string::npos) << outcome.err;
}

TEST(Locate, AnchorsThatAnswerInTurnsAreTakenInRounds)
{
    LocateArguments arguments = argumentsFor({uwb + "drive.csv"});
    arguments.truthFile = uwb + "drive-truth.csv";
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("in turns"), std::string::npos) << outcome.err;
    const auto rows = errorsOf(outcome);
    EXPECT_EQ(rows.at(0).at("n"), "60");
    EXPECT_LT(number(rows.at(0).at("rmse")), 120.0);
}

TEST(Locate, ListsEveryMethodWithItsSource)
{
    LocateArguments arguments;
    arguments.listMethods = true;
    const Answer outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0);
    for (const char* text : {"ekf-los", "two-step", "thesis 5.19 to 5.39", "fingerprint", "fusion"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
}

TEST_F(LocateFiles, TheCsvFileGetsThePositionsAndTheirErrors)
{
    LocateArguments arguments = argumentsFor({uwb + "points.csv"});
    arguments.truthFile = uwb + "points-truth.csv";
    arguments.csvFile = (folder / "out.csv").string();
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto rows = rowsOf(read(*arguments.csvFile));
    ASSERT_EQ(rows.size(), 36U);
    EXPECT_EQ(rows[0].at("true_x_m"), "0.8");
    EXPECT_EQ(rows[0].at("true_z_m"), "0.2");
    EXPECT_LT(number(rows[0].at("error_m")), 0.3);
    EXPECT_EQ(errorsOf(outcome).size(), 1U);
}

} // namespace
} // namespace agv::app
