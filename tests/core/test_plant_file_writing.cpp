// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file_units.h"
#include "core/plant_file.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

using namespace agv;

namespace {

int intFrom(SplitMix64& random, int least, int most)
{
    return least + static_cast<int>(random.next() % static_cast<std::uint64_t>(most - least + 1));
}

std::string someText(SplitMix64& random)
{
    static const char* const pieces[] = {"a",  "Z",  " ",    "\"",     "\\",     "/",
                                         "\n", "\t", "\x01", "\u00e4", "\u20ac", "{"};
    std::string text;
    for (int i = intFrom(random, 0, 12); i > 0; --i)
        text += pieces[random.next() % std::size(pieces)];
    return text;
}

/// A layout that obeys every rule of the format, with values of all 53 bits.
PlantLayout randomLayout(SplitMix64& random)
{
    PlantLayout plant;
    const auto inside = [&] {
        return Point2{plant.origin.x + random.uniform(0.0, plant.width_m),
                      plant.origin.y + random.uniform(0.0, plant.height_m)};
    };
    plant.name = someText(random);
    plant.origin = {random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
    plant.width_m = random.uniform(1.0, 20.0);
    plant.height_m = random.uniform(1.0, 20.0);
    plant.tagRadius_m = random.uniform(0.0, 0.1);
    if (random.uniform() < 0.5)
        plant.floorTags = tagGrid(intFrom(random, 1, 6), intFrom(random, 1, 6), random.uniform(0.01, 0.1),
                                  plant.origin, TagUid{random.next() >> 1});
    for (int i = intFrom(random, 0, 5); i > 0; --i)
        plant.floorTags.push_back({TagUid{random.next()}, inside(), intFrom(random, 0, 1000)});
    for (int i = intFrom(random, 0, 4); i > 0; --i)
        plant.stations.push_back({someText(random),
                                  static_cast<StationKind>(intFrom(random, 0, 4)),
                                  {inside(), random.uniform(-std::numbers::pi, std::numbers::pi)},
                                  random.uniform(0.1, 2.0),
                                  random.uniform(0.1, 2.0)});
    for (int i = intFrom(random, 0, 3); i > 0; --i)
        plant.obstacles.push_back({someText(random), {inside(), inside(), inside(), inside()}});
    const int agvCount = intFrom(random, 0, 5);
    for (int id = 1; id <= agvCount; ++id) {
        AgvConfig agv;
        agv.id = RobotId{id};
        agv.name = someText(random);
        agv.robotHost = "10.0.0." + std::to_string(id);
        agv.robotPeerPort = static_cast<std::uint16_t>(intFrom(random, 0, 65535));
        agv.reader = {"reader-" + std::to_string(id), static_cast<std::uint16_t>(intFrom(random, 1, 65535))};
        agv.radius_m = random.uniform(0.05, 1.0);
        agv.track_m = random.uniform(0.05, 1.0);
        agv.antenna = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
        agv.turnTime_s = random.uniform(0.1, 10.0);
        agv.turnSpeed_m_s = random.uniform(0.01, 0.2);
        agv.maxSpeed_m_s = random.uniform(0.2, 0.5);
        plant.agvs.push_back(agv);
    }
    if (random.uniform() < 0.5) {
        plant.rssiTable.clear();
        for (double edge = random.uniform(0.1, 0.3); edge > 0.01; edge -= random.uniform(0.001, 0.05))
            plant.rssiTable.push_back({edge, intFrom(random, 0, 7)});
    }
    const int anchorCount = intFrom(random, 0, 6);
    for (int id = 0; id < anchorCount; ++id)
        plant.anchors.push_back({id, someText(random), random.uniform(-9, 9), random.uniform(-9, 9),
                                 random.uniform(0, 5), random.uniform() < 0.5});
    if (random.uniform() < 0.5)
        plant.uwb.port = {someText(random), UsbId{0x0483, 0x5740}, someText(random)};
    if (random.uniform() < 0.5)
        plant.uwb.dialect = static_cast<UwbDialect>(intFrom(random, 1, 6));
    plant.uwb.tagHeight_m = random.uniform(0, 2);
    const int tagCount = intFrom(random, 0, 4);
    for (int id = 0; id < tagCount; ++id)
        plant.uwb.tags.push_back({id,
                                  someText(random),
                                  plant.agvs.empty() ? std::nullopt : std::optional(plant.agvs[0].id),
                                  random.uniform(0, 2),
                                  {random.uniform(-1, 1), random.uniform(-1, 1)}});
    plant.robotListen = {"10.0." + std::to_string(intFrom(random, 0, 255)) + ".1",
                         static_cast<std::uint16_t>(intFrom(random, 0, 65535))};
    plant.telemetryPort = static_cast<std::uint16_t>(intFrom(random, 0, 65535));
    return plant;
}

PlantDocument documentOf(std::string_view text)
{
    auto document = PlantDocument::fromText(text, "original");
    EXPECT_TRUE(document) << document.error().detail;
    return *document;
}

const std::string originalText = R"({
  "made_by": "surveyor",
  "version": 1,
  "format": "agv-plant",
  "size": {"height_mm": 2000, "unit note": [1, 2.50, 18446744073709551615, 0.1], "width_mm": 1000},
  "agvs": [
    {"colour": "red", "robot_host": "10.0.0.2", "id": 1},
    {"id": 2, "robot_host": "10.0.0.3", "reader": "10.0.1.3:8883", "owner": {"name": "B", "tel": null}}
  ],
  "floor_tags": {"list": [{"glue": true, "uid": "AE4", "x_mm": 5, "y_mm": 6}], "surveyed": "2024-05-01"},
  "anchors": [],
  "comment": "kept"
}
)";

} // namespace

TEST(PlantFileText, readsBackExactlyForRandomLayouts)
{
    SplitMix64 random(20240501);
    const PlantDocument original = documentOf(originalText);
    for (int i = 0; i < 60; ++i) {
        const PlantLayout plant = randomLayout(random);
        const auto text = plantText(plant);
        ASSERT_TRUE(text) << i << ": " << text.error().detail;
        ASSERT_EQ(readPlantText(*text, "p"), plant) << i << "\n" << *text;
        const auto merged = plantText(plant, &original);
        ASSERT_TRUE(merged) << i << ": " << merged.error().detail;
        ASSERT_EQ(readPlantText(*merged, "p"), plant) << i << "\n" << *merged;
    }
}

TEST(PlantFileText, ofAnUnchangedLayoutKeepsOrderUnknownKeysAndOmittedDefaults)
{
    const PlantDocument original = documentOf(originalText);
    EXPECT_EQ(plantText(original.layout(), &original), R"({
  "made_by": "surveyor",
  "version": 1,
  "format": "agv-plant",
  "size": {"height_mm": 2000, "unit note": [1, 2.5, 18446744073709551615, 0.1], "width_mm": 1000},
  "agvs": [
    {"colour": "red", "robot_host": "10.0.0.2", "id": 1},
    {
      "id": 2,
      "robot_host": "10.0.0.3",
      "reader": "10.0.1.3:8883",
      "owner": {"name": "B", "tel": null}
    }
  ],
  "floor_tags": {
    "list": [
      {"glue": true, "uid": "0000000000000AE4", "x_mm": 5, "y_mm": 6}
    ],
    "surveyed": "2024-05-01"
  },
  "anchors": [],
  "comment": "kept"
}
)");
}

TEST(PlantFileText, keepsTheUsualAddressOfARobotOmittedUntilTheConsoleMoves)
{
    const PlantDocument original = documentOf(R"({"format": "agv-plant", "version": 1,
  "size": {"width_mm": 1000, "height_mm": 1000},
  "agvs": [{"id": 3}], "listen": {"robots": "192.168.1.200:2001"}})");
    PlantLayout plant = original.layout();
    EXPECT_EQ(plant.agvs[0].robotHost, "192.168.1.4");
    EXPECT_NE(plantText(plant, &original).value().find(R"({"id": 3})"), std::string::npos);
    plant.robotListen.host = "10.0.0.1";
    const auto moved = plantText(plant, &original).value();
    EXPECT_NE(moved.find(R"({"id": 3, "robot_host": "192.168.1.4"})"), std::string::npos) << moved;
}

TEST(PlantFileText, keepsTheUnknownKeysOfEachThingWhenThingsMoveOrGo)
{
    const PlantDocument original = documentOf(originalText);
    PlantLayout plant = original.layout();
    std::swap(plant.agvs[0], plant.agvs[1]);
    plant.agvs[1].turnTime_s = 1.2;
    plant.floorTags.clear();
    const auto text = plantText(plant, &original).value();
    EXPECT_NE(text.find(R"({"colour": "red", "robot_host": "10.0.0.2", "id": 1, "sleeptime_ms": 1200})"),
              std::string::npos)
        << text;
    EXPECT_LT(text.find("\"owner\""), text.find("\"colour\"")) << text;
    EXPECT_EQ(readPlantText(text, "p"), plant);

    plant.agvs.erase(plant.agvs.begin());
    const auto shorter = plantText(plant, &original).value();
    EXPECT_EQ(shorter.find("\"owner\""), std::string::npos);
    EXPECT_NE(shorter.find("\"colour\""), std::string::npos);
}

TEST(PlantFileText, keepsUnknownKeysOfARenamedStation)
{
    const PlantDocument original =
        documentOf(R"({"format": "agv-plant", "version": 1, "size": {"width_mm": 1000, "height_mm": 1000},
                       "stations": [{"name": "Old", "plc": 7, "x_mm": 1, "y_mm": 1}]})");
    PlantLayout plant = original.layout();
    plant.stations[0].name = "New";
    EXPECT_NE(plantText(plant, &original)->find(R"({"name": "New", "plc": 7, "x_mm": 1, "y_mm": 1})"),
              std::string::npos);
}

TEST(PlantFileText, writesAGridAsAGridWhetherReadOrFound)
{
    const auto original =
        PlantDocument::fromFile(std::string(AGV_SOURCE_DIR) + "/resources/plant.json").value();
    for (const PlantDocument* const document : {static_cast<const PlantDocument*>(nullptr), &original}) {
        const auto text = plantText(original.layout(), document).value();
        EXPECT_NE(text.find("\"columns\": 31, \"rows\": 41, \"pitch_mm\": 100"), std::string::npos);
        EXPECT_EQ(text.find("\"list\""), std::string::npos);
    }
    PlantLayout moved = original.layout();
    moved.floorTags[700].position.x += 0.001;
    const auto text = plantText(moved, &original).value();
    EXPECT_EQ(text.find("\"columns\""), std::string::npos);
    EXPECT_EQ(readPlantText(text, "p"), moved);
}

TEST(PlantFileText, ofTheExamplesIsTheirOwnText)
{
    for (const char* const name : {"plant.json", "small-field.json"}) {
        const std::string path = std::string(AGV_SOURCE_DIR) + "/resources/" + name;
        const auto document = PlantDocument::fromFile(path).value();
        std::ifstream stream(path);
        const std::string asWritten(std::istreambuf_iterator<char>(stream), {});
        EXPECT_EQ(plantText(document.layout(), &document), asWritten);
    }
}

TEST(PlantFileText, refusesALayoutThatCouldNotBeReadBack)
{
    PlantLayout plant = documentOf(originalText).layout();
    plant.agvs[1].id = plant.agvs[0].id;
    EXPECT_NE(plantText(plant).error().detail.find("AGV number 1 is already used"), std::string::npos);
    plant = documentOf(originalText).layout();
    plant.agvs[0].track_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(plantText(plant).error().detail.find("/agvs/0/track_mm: must be a number (is null)"),
              std::string::npos);
    plant = documentOf(originalText).layout();
    plant.rssiTable.clear();
    EXPECT_FALSE(plantText(plant));
    plant = documentOf(originalText).layout();
    plant.stations.push_back({"S", StationKind::Other, {{0.1, 0.1}, 4.0}});
    EXPECT_NE(plantText(plant).error().detail.find("heading"), std::string::npos);
}

TEST(FileUnits, giveTheNumberPeopleWouldWrite)
{
    EXPECT_EQ(decimalText(toThousandths(0.2865)), "286.5");
    EXPECT_EQ(decimalText(toThousandths(0.0975)), "97.5");
    EXPECT_EQ(decimalText(toThousandths(1000.0)), "1000000");
    EXPECT_EQ(decimalText(toDegrees(-std::numbers::pi / 2)), "-90");
    EXPECT_EQ(decimalText(toDegrees(std::numbers::pi)), "180");
    EXPECT_EQ(decimalText(-0.0L), "0");
    EXPECT_EQ(fromThousandths(286.5L), 0.2865);
    EXPECT_EQ(fromDegrees(-180.0L), std::numbers::pi);
}

TEST(FileUnits, carryEveryBit)
{
    SplitMix64 random(3);
    for (int i = 0; i < 5'000; ++i) {
        const double value = random.uniform(-1.0, 1.0) * std::pow(10.0, intFrom(random, -12, 3));
        ASSERT_EQ(fromThousandths(toThousandths(value)), value);
        const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
        ASSERT_EQ(fromDegrees(toDegrees(angle)), angle);
    }
}
