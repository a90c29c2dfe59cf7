// SPDX-License-Identifier: GPL-3.0-or-later
// locate and fuse on recordings of real tags, which are not part of the project; the environment variable
// AGV_RECORDINGS names another folder. The commands are those of docs/BENCHMARKS-uwb.md.
#include "app/locate.h"

#include "core/text_file.h"
#include "recording/csv_table.h"
#include "recording/floor_read_table.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

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

/// What positions from floor tags can be judged by without a truth.
struct FloorTrack {
    std::size_t positions = 0;
    std::size_t reads = 0;
    std::size_t withinReach = 0; ///< reads of tags no farther from the position than the reader reaches
    std::size_t plausible = 0;   ///< the same, allowing two sds that the position claims for itself
    double roughness_m = 0.0;    ///< mean length of the second difference of three positions 0.25 s apart
};

FloorTrack judged(const std::string& positionsText, const recording::FloorReadTable& reads,
                  const recording::TagPlaceTable& tags)
{
    constexpr double reach_m = 0.14; // of the reader, measured; also the pitch of the tags
    constexpr double longestStep_s = 0.3;
    std::map<double, Point2> track;
    std::map<double, double> sds_m;
    auto positions = recording::CsvTable::open(positionsText);
    while (positions->next()) {
        const double time_s = *positions->number(*positions->column("t_s"));
        sds_m[time_s] = positions->number(*positions->column("sd_x_m")).value_or(0.0);
        track[time_s] = {*positions->number(*positions->column("x_m")),
                         *positions->number(*positions->column("y_m"))};
    }
    FloorTrack result;
    result.positions = track.size();
    for (const recording::FloorReadRow& row : reads.rows)
        for (const std::string& uid : row.uids)
            for (const recording::TagPlace& tag : tags.tags)
                if (tag.uid == uid && track.contains(row.time_s)) {
                    const Point2 away = track.at(row.time_s) - Point2{tag.x_m, tag.y_m};
                    ++result.reads;
                    const double distance_m = std::hypot(away.x, away.y);
                    result.withinReach += distance_m <= reach_m ? 1 : 0;
                    result.plausible += distance_m <= reach_m + 2.0 * sds_m.at(row.time_s) ? 1 : 0;
                }
    std::size_t steps = 0;
    const std::vector<std::pair<double, Point2>> points(track.begin(), track.end());
    for (std::size_t i = 2; i < points.size(); ++i) {
        if (points[i].first - points[i - 2].first > 2.0 * longestStep_s)
            continue;
        const Point2 bend =
            points[i].second - points[i - 1].second - (points[i - 1].second - points[i - 2].second);
        result.roughness_m += std::hypot(bend.x, bend.y);
        ++steps;
    }
    result.roughness_m /= static_cast<double>(steps);
    return result;
}

TEST_F(LocateRecordings, FloorReadsOfADrivingVehicle)
{
    for (const char* name : {"experiment_1.csv", "firstTest.csv"}) {
        LocateArguments arguments;
        arguments.fuse = true;
        arguments.floorFile = path("rfid_dyn_dortmund/known/" + std::string(name));
        arguments.tagsFile = path("rfid_dyn_dortmund/tag_map.csv");
        const auto reads =
            recording::readFloorReadCsv(readTextFile(*arguments.floorFile, 1U << 20U).value_or(""));
        const auto tags =
            recording::readTagPlaceCsv(readTextFile(*arguments.tagsFile, 1U << 20U).value_or(""));
        ASSERT_TRUE(reads && tags);
        std::map<std::string, FloorTrack> tracks;
        for (const char* method : {"rfid-average", "fusion-position"}) {
            arguments.method = method;
            const FloorTrack track = judged(run(arguments).out, *reads, *tags);
            std::printf(
                "%s %s: %zu positions, %zu of %zu reads within reach, %zu with its sds, roughness %.1f mm\n",
                name, method, track.positions, track.withinReach, track.reads, track.plausible,
                1e3 * track.roughness_m);
            tracks[method] = track;
        }
        EXPECT_GT(tracks["rfid-average"].positions, 30U);
        EXPECT_EQ(tracks["rfid-average"].positions, tracks["fusion-position"].positions);
        EXPECT_EQ(tracks["rfid-average"].withinReach, tracks["rfid-average"].reads);
        EXPECT_GE(tracks["fusion-position"].plausible, tracks["fusion-position"].reads * 95 / 100);
        EXPECT_LT(tracks["fusion-position"].roughness_m, tracks["rfid-average"].roughness_m);
    }
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
