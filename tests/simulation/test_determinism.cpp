// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant_fixture.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::simulation;

namespace {

struct Wire {
    std::string reader;
    protocol::Bytes frames;
    std::vector<protocol::Bytes> datagrams;
    bool operator==(const Wire&) const = default;
};

/// Drives robot 1 about for 3 s, advancing the plant `chunk` at a time, and returns everything all robots
/// sent.
std::vector<Wire> record(std::uint64_t seed, Duration chunk)
{
    PlantSettings settings;
    settings.seed = seed;
    Plant plant = Plant::create(hall(4), settings).value();
    const auto runTo = [&](Time end) {
        while (plant.now() < end)
            plant.advance(std::min(end, plant.now() + chunk));
    };
    runTo(Time{} + 500ms);
    plant.receive(RobotId{1}, protocol::encodeCommand(protocol::DirectDrive{{-0.1, 0.1}}).value());
    runTo(Time{} + 2s);
    plant.receive(RobotId{1}, protocol::encodeCommand(protocol::DirectDrive{}).value());
    runTo(Time{} + 3s);
    std::vector<Wire> wires;
    for (int i = 1; i <= 4; ++i)
        wires.push_back({plant.takeReaderBytes(RobotId{i}), plant.takeRobotFrames(RobotId{i}),
                         plant.takeRobotDatagrams(RobotId{i})});
    return wires;
}

} // namespace

TEST(Plant, givesTheSameBytesForTheSameSeed)
{
    const auto first = record(42, 5ms);
    EXPECT_EQ(first, record(42, 5ms));
    EXPECT_FALSE(first[0].reader.empty());
    EXPECT_FALSE(first[0].frames.empty());
    EXPECT_FALSE(first[0].datagrams.empty());
}

TEST(Plant, givesTheSameBytesHoweverItIsAdvanced) { EXPECT_EQ(record(42, 1ms), record(42, 500ms)); }

TEST(Plant, givesOtherBytesForAnotherSeed) { EXPECT_NE(record(42, 5ms), record(43, 5ms)); }

TEST(Plant, placesFourRobotsClearOfEverything)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        PlantSettings settings;
        settings.seed = seed;
        PlantLayout layout = hall(4);
        layout.stations.push_back({"mixer", StationKind::Mixing, {{1.5, 2.0}, 0.3}, 0.6, 0.4});
        const auto truth = Plant::create(layout, settings)->truth();
        ASSERT_EQ(truth.size(), 4U);
        for (const RobotTruth& a : truth) {
            EXPECT_GE(CollisionMap(layout).clearance(a.pose.position, 0.165), 0.0);
            for (const RobotTruth& b : truth)
                EXPECT_TRUE(a.id == b.id || distance(a.pose.position, b.pose.position) > 0.33);
        }
    }
}

TEST(Plant, saysWhenThereIsNoRoom)
{
    PlantLayout layout = hall(1);
    layout.obstacles.push_back({"everything", {{-1, -1}, {4, -1}, {4, 5}, {-1, 5}}});
    const auto plant = Plant::create(layout, idealSettings());
    ASSERT_FALSE(plant);
    EXPECT_EQ(plant.error().code, ErrorCode::NotFound);
    EXPECT_NE(plant.error().detail.find("AGV 1"), std::string::npos);
    layout = hall(1);
    layout.floorTags.clear();
    EXPECT_FALSE(Plant::create(layout, idealSettings()));
}

TEST(Plant, placesARobotOnTheSeedsFieldOfThreeByThree)
{
    PlantLayout layout = hall(1);
    layout.width_m = layout.height_m = 0.4;
    layout.floorTags = tagGrid(3, 3, 0.1, {0.1, 0.1}, TagUid{0xE00401503A5BD001});
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        PlantSettings settings;
        settings.seed = seed;
        const auto plant = Plant::create(layout, settings);
        ASSERT_TRUE(plant);
        EXPECT_LT(distance(plant->truth()[0].pose.position, {0.2, 0.2}), 0.15);
    }
}

TEST(Plant, ignoresRobotsItDoesNotHave)
{
    Plant plant = Plant::create(hall(1), idealSettings()).value();
    plant.receive(RobotId{9}, protocol::encodeCommand(protocol::Interrupt{}).value());
    plant.setCharge(RobotId{9}, 0.1);
    EXPECT_TRUE(plant.takeReaderBytes(RobotId{9}).empty());
    EXPECT_FALSE(plant.truth(RobotId{9}));
}
