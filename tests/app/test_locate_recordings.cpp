// SPDX-License-Identifier: GPL-3.0-or-later
// locate and fuse on recordings of real tags, which are not part of the project; the environment variable
// AGV_RECORDINGS names another folder. The commands are those of docs/BENCHMARKS-uwb.md.
#include "app/locate.h"

#include "recording/csv_table.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>

namespace agv::app {
namespace {

namespace fs = std::filesystem;

class LocateRecordings : public testing::Test {
protected:
    LocateRecordings()
    {
        const char* const other = std::getenv("AGV_RECORDINGS");
        folder = other != nullptr ? other : AGV_RECORDINGS;
    }
    void SetUp() override
    {
        if (!fs::exists(folder))
            GTEST_SKIP() << "recordings are not here: " << folder;
    }
    std::string path(const std::string& name) const { return (folder / name).string(); }

    LocateArguments argumentsFor(const std::string& set, const std::string& ranges,
                                 const std::string& truth = {}) const
    {
        LocateArguments arguments;
        arguments.inputs = {path(set + "/" + ranges)};
        arguments.anchorsFile = path(set + "/anchors.csv");
        if (!truth.empty())
            arguments.truthFile = path(set + "/" + truth);
        return arguments;
    }

    struct Answer {
        int status = -1;
        std::string out;
        std::string err;
    };
    static Answer run(const LocateArguments& arguments)
    {
        std::istringstream in;
        std::ostringstream out;
        std::ostringstream err;
        const int status = runLocate(arguments, in, out, err);
        EXPECT_EQ(status, 0) << err.str();
        std::printf("%s", out.str().substr(0, 2000).c_str());
        return {status, out.str(), err.str()};
    }

    /// A column of the table of errors by the value of --by, or by the method without it.
    static std::map<std::string, double> column(const LocateArguments& arguments, const char* title)
    {
        const std::string out = run(arguments).out;
        const std::string csv = std::regex_replace(out.substr(out.find('\n') + 1), std::regex(" +"), ",");
        std::map<std::string, double> values;
        auto table = recording::CsvTable::open(csv);
        const auto key = table->column(arguments.by ? *arguments.by : "method");
        while (table->next())
            values[std::string(table->field(*key))] =
                table->number(*table->column(title)).value_or(std::nan(""));
        return values;
    }

    fs::path folder;
};

TEST_F(LocateRecordings, AStandingTagThatAllAnchorsSee)
{
    const LocateArguments arguments = argumentsFor("trek1000_decarange", "ranges_los.csv", "truth.csv");
    EXPECT_LE(column(arguments, "rmse").at("auto"), 70.0);
}

TEST_F(LocateRecordings, AStandingTagThatSomeAnchorsDoNotSee)
{
    LocateArguments arguments = argumentsFor("trek1000_decarange", "ranges_nlos.csv", "truth.csv");
    arguments.by = "nlos_origin";
    const auto errors = column(arguments, "rmse");
    ASSERT_EQ(errors.size(), 2U);
    EXPECT_LE(errors.at("recorded"), 150.0);
    EXPECT_LE(errors.at("injected"), 150.0);
}

TEST_F(LocateRecordings, EveryMethodRunsOnThem)
{
    LocateArguments arguments = argumentsFor("trek1000_decarange", "ranges_los.csv", "truth.csv");
    arguments.method = "all";
    for (const auto& [method, rmse] : column(arguments, "rmse"))
        EXPECT_GT(rmse, 10.0) << method;
}

TEST_F(LocateRecordings, LogsOfTheExistingProgram)
{
    LocateArguments arguments = argumentsFor("trek1000_decarange", "raw_logs");
    arguments.height_m = 0.88;
    const std::string positions = run(arguments).out;
    for (const char* name : {"001_los", "256_nlos", "dynamic_track"})
        EXPECT_NE(positions.find(name), std::string::npos);
}

TEST_F(LocateRecordings, ATrolleyThatStandsCalibratedAtItsOtherPoses)
{
    LocateArguments arguments = argumentsFor("lias_trolley", "ranges_static.csv", "truth_static.csv");
    arguments.calibrate = path("lias_trolley/ranges_static.csv") + ":" + *arguments.truthFile;
    arguments.height_m = 0.964;
    EXPECT_LE(column(arguments, "rmse").at("auto"), 60.0);
}

TEST_F(LocateRecordings, ATrolleyThatDrivesCalibratedWhereItStood)
{
    LocateArguments arguments =
        argumentsFor("lias_trolley", "ranges_dynamic_mid.csv", "truth_dynamic_mid.csv");
    arguments.calibrate =
        path("lias_trolley/ranges_static.csv") + ":" + path("lias_trolley/truth_static.csv");
    arguments.height_m = 0.964;
    EXPECT_LE(column(arguments, "rmse").at("auto"), 75.0);
    EXPECT_LE(column(arguments, "ce95").at("auto"), 110.0);
}

TEST_F(LocateRecordings, ARobotInALabyrinth)
{
    LocateArguments arguments = argumentsFor("labyrinth_odom_uwb", "ranges.csv", "truth.csv");
    EXPECT_LT(column(arguments, "rmse").at("auto"), 250.0);
    arguments.fuse = true;
    arguments.odometryFile = path("labyrinth_odom_uwb/odom.csv");
    arguments.track_m = 0.157;
    arguments.startHeading = std::numbers::pi;
    EXPECT_LE(column(arguments, "rmse").at("fusion"), 70.0);
}

TEST_F(LocateRecordings, SerialLines)
{
    for (const char* name : {"ulm_clone_wall_a.mc.txt", "ulm_clone_room_b.mc.txt", "trek1000_sample.txt"}) {
        LocateArguments arguments = argumentsFor("trek1000_decarange", "../trek_lines/" + std::string(name));
        arguments.height_m = 1.0;
        EXPECT_NE(run(arguments).out.find(",ok,"), std::string::npos) << name;
    }
}

} // namespace
} // namespace agv::app
