// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_layout.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace agv;

TEST(RssiTable, readsTheUpperEdgeOfAStepAsThatStep)
{
    const RssiTable table = seedRssiTable();
    EXPECT_EQ(rssiAt(table, 0.1400), 0);
    EXPECT_EQ(rssiAt(table, 0.0975), 1);
    EXPECT_EQ(rssiAt(table, 0.09751), 0);
    EXPECT_EQ(rssiAt(table, 0.0), 7);
}

TEST(RssiTable, hasTheBlindSpotNearFiftyMillimetres)
{
    const RssiTable table = seedRssiTable();
    EXPECT_EQ(rssiAt(table, 0.0600), 5);
    EXPECT_EQ(rssiAt(table, 0.0500), 0);
    EXPECT_EQ(rssiAt(table, 0.0400), 5);
}

TEST(RssiTable, readsNothingBeyondItsFirstEdge)
{
    EXPECT_FALSE(rssiAt(seedRssiTable(), 0.14001));
    EXPECT_FALSE(rssiAt({}, 0.01));
}

TEST(TagGrid, countsColumnByColumnLikeTheSeed)
{
    const auto tags = tagGrid(3, 3, 0.1, {0.1, 0.1}, TagUid{0x100});
    ASSERT_EQ(tags.size(), 9U);
    EXPECT_EQ(tags[3].number, 4);
    EXPECT_EQ(tags[3].uid, TagUid{0x103});
    EXPECT_DOUBLE_EQ(tags[3].position.x, 0.2);
    EXPECT_DOUBLE_EQ(tags[3].position.y, 0.1);
}

TEST(Endpoint, saysWhichPartIsWrong)
{
    EXPECT_EQ(parseEndpoint("127.0.0.1:2001"), (Endpoint{"127.0.0.1", 2001}));
    EXPECT_NE(parseEndpoint("127.0.0.1:20x").error().detail.find("'20x'"), std::string::npos);
    EXPECT_FALSE(parseEndpoint("127.0.0.1"));
    EXPECT_FALSE(parseEndpoint(":1"));
    EXPECT_FALSE(parseEndpoint("h:65536"));
}

TEST(Angles, areWrappedIntoTheHalfOpenInterval)
{
    EXPECT_DOUBLE_EQ(wrapAngle(-std::numbers::pi), std::numbers::pi);
    EXPECT_DOUBLE_EQ(wrapAngle(std::numbers::pi), std::numbers::pi);
    EXPECT_NEAR(wrapAngle(7.0), 7.0 - 2.0 * std::numbers::pi, 1e-15);
}

TEST(Pose, putsTheAntennaBehindTheCentre)
{
    const Point2 antenna = fromVehicleFrame({{1.0, 2.0}, std::numbers::pi / 2}, {-0.1, 0.0});
    EXPECT_NEAR(antenna.x, 1.0, 1e-15);
    EXPECT_NEAR(antenna.y, 1.9, 1e-15);
}
