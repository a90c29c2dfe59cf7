// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

using namespace agv;

namespace {

PlantLayout example(const std::string& file)
{
    const auto document = PlantDocument::fromFile(std::string(AGV_SOURCE_DIR) + "/resources/" + file);
    if (!document) {
        ADD_FAILURE() << document.error().detail;
        return {};
    }
    EXPECT_EQ(document->warnings(), std::vector<std::string>{});
    return document->layout();
}

/// The text between the first ```json and the next ``` of a page.
std::string jsonBlockOf(const std::string& page)
{
    std::ifstream stream(std::string(AGV_SOURCE_DIR) + "/docs/" + page);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const std::string fence = "```json\n";
    const auto begin = text.find(fence);
    const auto end = text.find("```", begin + fence.size());
    return begin == std::string::npos || end == std::string::npos
               ? ""
               : text.substr(begin + fence.size(), end - begin - fence.size());
}

double distanceToEdge(const PlantLayout& plant, Point2 p)
{
    return std::min({p.x - plant.origin.x, p.y - plant.origin.y, plant.origin.x + plant.width_m - p.x,
                     plant.origin.y + plant.height_m - p.y});
}

} // namespace

TEST(ExamplePlant, hasTheWholePlantOfTheSeed)
{
    const PlantLayout plant = example("plant.json");
    EXPECT_EQ(plant.width_m, 3.0);
    EXPECT_EQ(plant.height_m, 4.0);
    EXPECT_EQ(plant.floorTags, tagGrid(31, 41, 0.1, {}, TagUid{0xE00401503B000001}));
    EXPECT_EQ(plant.rssiTable, seedRssiTable());
    EXPECT_EQ(plant.robotListen, (Endpoint{"127.0.0.1", 2001}));
    EXPECT_EQ(plant.telemetryPort, 2000);
    const auto count = [&](StationKind kind) {
        return std::count_if(plant.stations.begin(), plant.stations.end(),
                             [=](const Station& station) { return station.kind == kind; });
    };
    EXPECT_EQ(count(StationKind::Colour), 2);
    EXPECT_EQ(count(StationKind::Mixing), 1);
    EXPECT_EQ(count(StationKind::Storage), 1);
    EXPECT_EQ(count(StationKind::Charging), 4);
}

TEST(ExamplePlant, hasFourAgvsWithTheBuiltInValuesOnTheAddressesOfTheOldRule)
{
    const PlantLayout plant = example("plant.json");
    ASSERT_EQ(plant.agvs.size(), 4U);
    for (int id = 1; id <= 4; ++id) {
        const std::string host = "127.0.0." + std::to_string(id + 1);
        AgvConfig expected;
        expected.id = RobotId{id};
        expected.name = "AGV " + std::to_string(id);
        expected.robotHost = host;
        expected.reader = {host, 8883};
        EXPECT_EQ(plant.agvs[static_cast<std::size_t>(id) - 1], expected);
    }
}

TEST(ExamplePlant, hasRoomForAnAgvInFrontOfEveryDock)
{
    const PlantLayout plant = example("plant.json");
    const double radius = plant.agvs.front().radius_m;
    std::vector<Point2> fronts;
    for (const Station& station : plant.stations) {
        if (station.kind == StationKind::Charging)
            fronts.push_back(fromVehicleFrame(station.pose, {0.0, station.depth_m / 2 + 2 * radius}));
    }
    for (std::size_t i = 0; i < fronts.size(); ++i) {
        EXPECT_GT(distanceToEdge(plant, fronts[i]), radius);
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_GT(distance(fronts[i], fronts[k]), 2 * radius);
    }
}

TEST(ExampleSmallField, hasTheRealTagsInTheCoordinatesOfTheReport)
{
    const PlantLayout plant = example("small-field.json");
    ASSERT_EQ(plant.floorTags.size(), 9U);
    const char* const shortNames[] = {"AE4", "586", "BF4", "689", "785", "691", "47A", "ADC", "78D"};
    for (std::size_t i = 0; i < 9; ++i) {
        const FloorTag& tag = plant.floorTags[i];
        EXPECT_EQ(fullText(tag.uid), "E00401503A5BD" + std::string(shortNames[i]));
        EXPECT_EQ(tag.number, static_cast<int>(i) + 1);
        EXPECT_EQ(tag.position, (Point2{0.1 * static_cast<double>(i / 3), 0.1 * static_cast<double>(i % 3)}));
        EXPECT_GE(distanceToEdge(plant, tag.position), 0.3 - 1e-12);
    }
    EXPECT_EQ(plant.agvs.size(), 1U);
}

TEST(ExampleOfTheManual, isAcceptedWithoutAWarningAndHasTheDefaultsOfTheManual)
{
    const auto document = PlantDocument::fromText(jsonBlockOf("plant-file.md"), "plant-file.md");
    ASSERT_TRUE(document) << document.error().detail;
    EXPECT_EQ(document->warnings(), std::vector<std::string>{});
    const PlantLayout& plant = document->layout();
    AgvConfig agv;
    agv.id = RobotId{1};
    agv.name = "AGV 1";
    agv.robotHost = "192.168.1.2";
    agv.turnTime_s = 1.18;
    EXPECT_EQ(plant.agvs, std::vector<AgvConfig>{agv});
    EXPECT_EQ(plant.anchors, (std::vector<UwbAnchor>{{0, "A0", 0.0, 0.0, 2.0, true}}));
    EXPECT_EQ(plant.floorTags.back(), (FloorTag{TagUid{0xE00401503A5BDAE4}, {1.5005, 0.82}, 122}));
    EXPECT_EQ(plant.rssiTable, seedRssiTable());
}
