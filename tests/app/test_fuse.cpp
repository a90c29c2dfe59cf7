// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/locate_support.h"

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
