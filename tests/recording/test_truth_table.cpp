// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/floor_read_table.h"
#include "recording/odometry_table.h"
#include "recording/truth_table.h"

#include <gtest/gtest.h>

namespace agv::recording {
namespace {

TEST(TruthTable, HoldsPlacesWithTheColumnsThatTellThemApart)
{
    const auto truth = readTruthCsv("point,x_m,y_m,z_m,origin\n1,0.5,2,0.88,injected\n7,1,2,,recorded\n");
    ASSERT_TRUE(truth) << truth.error().detail;
    ASSERT_EQ(truth->places.size(), 2U);
    EXPECT_EQ(truth->otherColumns, (std::vector<std::string>{"point", "origin"}));
    EXPECT_EQ(truth->places[0].x_m, 0.5);
    EXPECT_EQ(truth->places[0].z_m, 0.88);
    EXPECT_FALSE(truth->places[0].time_s || truth->places[0].tag);
    EXPECT_FALSE(truth->places[1].z_m);
    EXPECT_EQ(truth->places[1].columns, (std::vector<std::string>{"7", "recorded"}));
    EXPECT_EQ(truth->places[1].line, 3);
    EXPECT_EQ(truth->otherColumn("origin"), 1U);
}

TEST(TruthTable, HoldsSeveralTagsOfOneRow)
{
    const auto truth =
        readTruthCsv("t_s,body_x_m,body_z_m,tag0_x,tag0_y,tag2_x,tag2_y\n0.05,9,0.9,1,2,3,4\n");
    ASSERT_TRUE(truth) << truth.error().detail;
    ASSERT_EQ(truth->places.size(), 2U);
    EXPECT_EQ(truth->places[0].tag, 0);
    EXPECT_EQ(truth->places[1].tag, 2);
    EXPECT_EQ(truth->places[1].y_m, 4.0);
    EXPECT_EQ(truth->places[1].z_m, 0.9);
    EXPECT_EQ(truth->places[1].time_s, 0.05);
    EXPECT_EQ(truth->otherColumns, (std::vector<std::string>{"body_x_m"}));
}

TEST(TruthTable, NamesBadLinesAndKeepsTheOthers)
{
    const auto truth =
        readTruthCsv("t_s,tag,x_m,y_m\n1,0,2,3\nnow,0,2,3\n2,0,2\n3,0,far,3\n4,0,,\n5,0,2,3\n");
    ASSERT_TRUE(truth) << truth.error().detail;
    EXPECT_EQ(truth->places.size(), 2U);
    ASSERT_EQ(truth->problems.count(), 3U);
    EXPECT_EQ(truth->problems.kept()[0].line, 3);
    EXPECT_NE(truth->problems.kept()[0].reason.find("'now'"), std::string::npos);
    EXPECT_EQ(truth->problems.kept()[1].line, 4);
    EXPECT_EQ(truth->problems.kept()[2].line, 5);
}

TEST(TruthTable, AHeightThatIsNoNumberIsNamed)
{
    const auto truth = readTruthCsv("x_m,y_m,z_m\n1,2,high\n1,2,\n");
    ASSERT_TRUE(truth) << truth.error().detail;
    EXPECT_EQ(truth->places.size(), 1U);
    ASSERT_EQ(truth->problems.count(), 1U);
    EXPECT_EQ(truth->problems.kept()[0].reason, "z_m: must be a number (is 'high')");
}

TEST(OdometryTable, SpeedsBeyondAllMeasureAreNamed)
{
    const auto odometry = readOdometryCsv("t_s,v_left_mps,v_right_mps\n1,-1e308,1e308\n2,0.1,0.1\n", 0.157);
    ASSERT_TRUE(odometry) << odometry.error().detail;
    EXPECT_EQ(odometry->rows.size(), 1U);
    ASSERT_EQ(odometry->problems.count(), 1U);
    EXPECT_NE(odometry->problems.kept()[0].reason.find("beyond all measure"), std::string::npos);
}

TEST(TruthTable, WithoutAPlaceIsRefused)
{
    for (const char* text : {"", "a,b\n1,2\n", "x_m,y_m\n", "x_m,y_m\nfar,away\n", "tag0_x,tag1_y\n1,2\n"}) {
        const auto truth = readTruthCsv(text);
        ASSERT_FALSE(truth) << text;
        EXPECT_EQ(truth.error().code, ErrorCode::BadInput);
    }
    EXPECT_TRUE(readTruthCsv("x_m,y_m\nfar,2\n").error().detail.starts_with("2: x_m"));
}

TEST(OdometryTable, TakesSpeedsOfWheelsOrOfTheVehicle)
{
    const auto wheels = readOdometryCsv("t_s,v_left_mps,v_right_mps\n0.1,0.1,0.3\n", 0.5);
    ASSERT_TRUE(wheels) << wheels.error().detail;
    EXPECT_DOUBLE_EQ(wheels->rows.at(0).forward, 0.2);
    EXPECT_DOUBLE_EQ(wheels->rows.at(0).turn, 0.4);
    const auto vehicle = readOdometryCsv("t_s;v_mps;omega_radps\n0,1;0,2;-0,4\n", {});
    ASSERT_TRUE(vehicle) << vehicle.error().detail;
    EXPECT_EQ(vehicle->rows.at(0), (OdometryRow{0.1, 0.2, -0.4}));
}

TEST(OdometryTable, SaysWhatIsMissingOrWrong)
{
    EXPECT_NE(readOdometryCsv("t_s,v_left_mps,v_right_mps\n0.1,0.1,0.3\n", {})
                  .error()
                  .detail.find("distance of the wheels"),
              std::string::npos);
    EXPECT_FALSE(readOdometryCsv("t_s,v_left_mps\n0.1,0.1\n", 0.5));
    EXPECT_FALSE(readOdometryCsv("t_s,v_mps,omega_radps\n", {}));
    const auto some = readOdometryCsv("t_s,v_mps,omega_radps\n1,0,0\n0.5,0,0\n2,fast,0\n3,0,0\n", {});
    ASSERT_TRUE(some);
    EXPECT_EQ(some->rows.size(), 2U);
    ASSERT_EQ(some->problems.count(), 2U);
    EXPECT_EQ(some->problems.kept()[0].line, 3);
    EXPECT_EQ(some->problems.kept()[1].line, 4);
}

TEST(FloorReadTable, PutsTheTagsOfOneTimeTogether)
{
    const auto rows = readFloorReadCsv("t_s,uid,rssi\n1,e2ba,6\n1,ED7C,1\n2,E2BA,5\n");
    ASSERT_TRUE(rows) << rows.error().detail;
    ASSERT_EQ(rows->rows.size(), 2U);
    EXPECT_EQ(rows->rows[0].uids, (std::vector<std::string>{"E2BA", "ED7C"}));
    const auto wide = readFloorReadCsv("t_s,n_tags,uid1,rssi1,uid2,rssi2\n1,2,E2BA,6,ED7C,1\n2,0,,,,\n");
    ASSERT_TRUE(wide) << wide.error().detail;
    ASSERT_EQ(wide->rows.size(), 1U);
    EXPECT_EQ(wide->rows[0].uids, (std::vector<std::string>{"E2BA", "ED7C"}));
}

TEST(FloorReadTable, TakesPositionsAndNamesBadLines)
{
    const auto places = readFloorReadCsv("t_s,x_m,y_m\n1,0.5,0.6\n2,,\n3,far,1\n0,1,1\n");
    ASSERT_TRUE(places) << places.error().detail;
    ASSERT_EQ(places->rows.size(), 1U);
    EXPECT_EQ(places->rows[0].x_m, 0.5);
    EXPECT_EQ(places->problems.count(), 2U);
    EXPECT_FALSE(readFloorReadCsv("t_s,rssi\n1,2\n"));
    EXPECT_FALSE(readFloorReadCsv("t_s,uid\n1,\n"));
    EXPECT_TRUE(readFloorReadCsv("t_s,uid\n1,tag 4\n").error().detail.starts_with("2: uid"));
}

TEST(TagPlaceTable, TakesMillimetresAndMetres)
{
    const auto mm = readTagPlaceCsv("uid_tail,x_mm,y_mm\ne641,140,0\n");
    ASSERT_TRUE(mm) << mm.error().detail;
    EXPECT_EQ(mm->tags.at(0).uid, "E641");
    EXPECT_DOUBLE_EQ(mm->tags.at(0).x_m, 0.14);
    const auto metres = readTagPlaceCsv("uid,x_m,y_m\nE00401503A5BDAE4,0.1,0.2\nnone,1,1\n");
    ASSERT_TRUE(metres) << metres.error().detail;
    EXPECT_DOUBLE_EQ(metres->tags.at(0).y_m, 0.2);
    EXPECT_EQ(metres->problems.count(), 1U);
    EXPECT_FALSE(readTagPlaceCsv("uid,x\n1,1\n"));
}

} // namespace
} // namespace agv::recording
