// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/locate_support.h"
#include "core/geometry.h"
#include "recording/floor_read_table.h"
#include "recording/number_text.h"

#include <cmath>
#include <numbers>
#include <set>

namespace agv::app {
namespace {

LocateArguments drive()
{
    LocateArguments arguments = argumentsFor({uwb + "drive.csv"});
    arguments.fuse = true;
    arguments.truthFile = uwb + "drive-truth.csv";
    arguments.odometryFile = uwb + "drive-odometry.csv";
    arguments.track_m = 0.2865;
    arguments.startHeading = 20.0 * std::numbers::pi / 180.0;
    return arguments;
}

TEST(Fuse, FollowsAVehicleByWheelsAndSingleRanges)
{
    const Answer outcome = run(drive());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto rows = errorsOf(outcome);
    EXPECT_EQ(rows.at(0).at("method"), "fusion");
    EXPECT_EQ(rows.at(0).at("n"), "237") << "from the moment every anchor was heard";
    EXPECT_LT(number(rows.at(0).at("rmse")), 80.0);
}

TEST(Fuse, FloorTagsMakeItBetter)
{
    LocateArguments arguments = drive();
    arguments.odometryFile.reset();
    const double without = number(errorsOf(run(arguments)).at(0).at("rmse"));
    arguments.floorFile = uwb + "drive-reads.csv";
    arguments.tagsFile = uwb + "drive-tags.csv";
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_LT(number(errorsOf(outcome).at(0).at("rmse")), without);
}

TEST(Fuse, ComparesUwbFloorTagsAndBoth)
{
    LocateArguments arguments = drive();
    arguments.floorFile = uwb + "drive-reads.csv";
    arguments.tagsFile = uwb + "drive-tags.csv";
    arguments.method = "all";
    std::set<std::string> methods;
    const Answer outcome = run(arguments);
    for (const auto& row : errorsOf(outcome))
        methods.insert(row.at("method"));
    for (const char* name :
         {"ekf-los", "fusion", "fusion-position", "fusion-particle", "switching", "rfid-average"})
        EXPECT_TRUE(methods.contains(name)) << name;
}

TEST(Fuse, AGivenStartCountsFromTheFirstRange)
{
    LocateArguments arguments = drive();
    arguments.startPosition = Point2{1.8, 0.6};
    EXPECT_EQ(errorsOf(run(arguments)).at(0).at("n"), "240");
}

/// A vehicle on a circle, its tag beside and ahead of its centre; exact ranges to the anchors of the drive.
struct CircleDrive {
    std::string ranges = "t_s,tag,anchor,range_m\n";
    std::string odometry = "t_s,v_mps,omega_radps\n";
    std::string truth = "t_s,x_m,y_m,z_m\n"; ///< of the centre

    explicit CircleDrive(Point2 mount)
    {
        constexpr double speed = 0.2;
        constexpr double turnRate = 0.25;
        constexpr double height = 0.2;
        const auto anchors = rowsOf(readTextFile(uwb + "anchors.csv", 1U << 16U).value_or(""));
        for (int k = 0; k <= 250; ++k) {
            const double time = 0.1 * k;
            const double heading = turnRate * time;
            const double radius = speed / turnRate;
            const Pose2 pose{{1.2 + radius * std::sin(heading), 0.7 + radius * (1.0 - std::cos(heading))},
                             wrapAngle(heading)};
            const Point2 tag = fromVehicleFrame(pose, mount);
            for (const auto& anchor : anchors)
                ranges += row(time) + ",7," + anchor.at("anchor") + "," +
                          row(std::hypot(tag.x - number(anchor.at("x_m")), tag.y - number(anchor.at("y_m")),
                                         height - number(anchor.at("z_m")))) +
                          "\n";
            odometry += row(time) + "," + row(speed) + "," + row(turnRate) + "\n";
            truth += row(time) + "," + row(pose.position.x) + "," + row(pose.position.y) + "," + row(height) +
                     "\n";
        }
    }
    static std::string row(double value) { return recording::exactNumberText(value); }
};

class FuseWithAMount : public LocateFiles {
protected:
    static constexpr Point2 mount{0.15, -0.1};
    LocateArguments drive() const
    {
        const CircleDrive circle(mount);
        LocateArguments arguments = argumentsFor({file("ranges.csv", circle.ranges)});
        arguments.fuse = true;
        arguments.odometryFile = file("odometry.csv", circle.odometry);
        arguments.truthFile = file("truth.csv", circle.truth);
        arguments.startHeading = 0.0;
        return arguments;
    }
    static double worst(const LocateArguments& arguments)
    {
        const Answer outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return number(errorsOf(outcome).at(0).at("max"));
    }
};

TEST_F(FuseWithAMount, GivesTheVehiclesCentreWhereTheTagIsMountedBesideIt)
{
    LocateArguments arguments = drive();
    EXPECT_GT(worst(arguments), 60.0) << "taken to be at the centre";
    arguments.mount = mount;
    EXPECT_LT(worst(arguments), 10.0);
}

TEST_F(FuseWithAMount, ThePlantFileSaysWhereTheTagIsMounted)
{
    LocateArguments arguments = drive();
    const auto plantWith = [&](const std::string& id) {
        return file("plant-" + id + ".json",
                    R"({"format": "agv-plant", "version": 1, "size": {"width_mm": 4000, "height_mm": 3000},
"agvs": [{"id": 1, "robot_host": "10.0.0.2"}], "uwb": {"tags": [{"id": )" +
                        id + R"(, "agv": 1, "along_mm": 150, "across_mm": -100}]}})");
    };
    arguments.plantFile = plantWith("8");
    EXPECT_GT(worst(arguments), 60.0) << "tag 7 is not in the plant file";
    arguments.plantFile = plantWith("7");
    EXPECT_LT(worst(arguments), 10.0);
    arguments.mount = Point2{};
    EXPECT_GT(worst(arguments), 60.0) << "--mount comes before the plant file";
}

LocateArguments floorReads()
{
    LocateArguments arguments;
    arguments.fuse = true;
    arguments.floorFile = uwb + "drive-reads.csv";
    arguments.tagsFile = uwb + "drive-tags.csv";
    return arguments;
}

TEST(Fuse, FloorTagsAloneGiveAPositionForEachTimeSomeWereRead)
{
    LocateArguments arguments = floorReads();
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto reads =
        recording::readFloorReadCsv(readTextFile(*arguments.floorFile, 1U << 20U).value_or(""));
    const auto positions = rowsOf(outcome.out);
    ASSERT_EQ(positions.size(), reads->rows.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        EXPECT_EQ(number(positions[i].at("t_s")), reads->rows[i].time_s);
        EXPECT_EQ(positions[i].at("method"), "fusion-position");
        EXPECT_EQ(positions[i].at("status"), "ok");
        EXPECT_EQ(positions[i].at("tag"), "");
    }
}

TEST(Fuse, FloorTagsAloneAreComparedWithTheTruth)
{
    LocateArguments arguments = floorReads();
    arguments.method = "all";
    arguments.truthFile = uwb + "drive-truth.csv";
    std::set<std::string> methods;
    for (const auto& row : errorsOf(run(arguments))) {
        methods.insert(row.at("method"));
        EXPECT_LT(number(row.at("rmse")), 100.0) << row.at("method");
    }
    EXPECT_EQ(methods, (std::set<std::string>{"fusion-position", "switching", "rfid-average"}));
}

TEST(Fuse, FloorTagsAloneWithAGivenStartAndWheels)
{
    LocateArguments arguments = floorReads();
    arguments.odometryFile = uwb + "drive-odometry.csv";
    arguments.track_m = 0.2865;
    EXPECT_EQ(run(arguments).status, 2) << "nothing says where it starts";
    arguments.startHeading = 20.0 * std::numbers::pi / 180.0;
    arguments.startPosition = Point2{1.8, 0.6};
    arguments.truthFile = uwb + "drive-truth.csv";
    const Answer outcome = run(arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto rows = errorsOf(outcome);
    EXPECT_EQ(rows.at(0).at("method"), "fusion");
    EXPECT_LT(number(rows.at(0).at("rmse")), 100.0);
}

TEST_F(LocateFiles, FloorTagsAloneNameWhatIsMissing)
{
    LocateArguments arguments = floorReads();
    for (const char* method : {"auto", "ekf-los", "fusion-particle"}) {
        arguments.method = method;
        const Answer outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_NE(outcome.err.find("needs ranges; name an INPUT"), std::string::npos) << outcome.err;
    }
    arguments = floorReads();
    arguments.tagsFile = file("tags.csv", "uid,x_mm,y_mm\nFFFF,800,700\n");
    const Answer outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("no tag that was read has a known place"), std::string::npos) << outcome.err;
    arguments.floorFile.reset();
    EXPECT_EQ(run(arguments).status, 2);
}

TEST_F(LocateFiles, FuseNamesWhatIsWrongWithItsFiles)
{
    LocateArguments arguments = drive();
    arguments.track_m.reset();
    EXPECT_NE(run(arguments).err.find("--wheel-distance"), std::string::npos);
    arguments = drive();
    arguments.floorFile = uwb + "drive-reads.csv";
    EXPECT_NE(run(arguments).err.find("give --tags or --plant"), std::string::npos);
    arguments.tagsFile = file("tags.csv", "uid,x_mm,y_mm\nE00401503B000807,800,700\n");
    const Answer outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("is not one known tag; its"), std::string::npos) << outcome.err;
    arguments.odometryFile.reset();
    arguments.method = "fusion";
    EXPECT_EQ(run(arguments).status, 2);
}

} // namespace
} // namespace agv::app
