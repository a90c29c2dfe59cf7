// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_file.h"

#include <gtest/gtest.h>

namespace agv {
namespace {

std::string plantWith(const std::string& uwb)
{
    return R"({"format": "agv-plant", "version": 1, "size": {"width_mm": 1000, "height_mm": 1000},
"agvs": [{"id": 1, "robot_host": "10.0.0.2"}], "anchors": [{"id": 0, "x_mm": 0, "y_mm": 0}],
"uwb": )" + uwb +
           "}";
}

UwbSettings settingsOf(const std::string& uwb)
{
    const auto plant = readPlantText(plantWith(uwb), "p.json");
    EXPECT_TRUE(plant) << plant.error().detail;
    return plant ? plant->uwb : UwbSettings{};
}

std::string uwbError(const std::string& uwb)
{
    const auto plant = readPlantText(plantWith(uwb), "p.json");
    return plant ? "accepted" : plant.error().detail;
}

TEST(PlantFileUwb, IsTheFirstTrekUnitAndATagHeightWhenNothingIsSaid)
{
    EXPECT_EQ(settingsOf("{}"), UwbSettings{});
    EXPECT_EQ(UwbSettings{}.tagHeight_m, 0.3);
}

TEST(PlantFileUwb, NamesThePortTheDialectAndTheTags)
{
    const UwbSettings uwb = settingsOf(R"({"port": "/dev/ttyACM0", "usb_id": "1a86:7523",
        "serial_number": "77", "dialect": "ulm4", "tag_height_mm": 250, "tags": [
        {"id": 3, "label": "Front", "agv": 1, "along_mm": 100, "across_mm": -20}, {"id": 4, "z_mm": 1500}]})");
    EXPECT_EQ(uwb.port, (SerialPortChoice{"/dev/ttyACM0", UsbId{0x1a86, 0x7523}, "77"}));
    EXPECT_EQ(uwb.dialect, UwbDialect::UlmFour);
    EXPECT_EQ(uwb.tags, (std::vector<UwbTag>{{3, "Front", RobotId{1}, 0.25, {0.1, -0.02}},
                                             {4, "T4", std::nullopt, 1.5, {}}}));
}

TEST(PlantFileUwb, HoldsWhatIsAddedToTheRangesOfEachPair)
{
    const UwbSettings uwb = settingsOf(R"({"corrections": [{"anchor": 0, "tag": 3, "offset_mm": -120},
        {"anchor": 0, "tag": 200, "offset_mm": 35.5}]})");
    EXPECT_EQ(uwb.corrections, (std::vector<RangeCorrection>{{0, 3, -0.12}, {0, 200, 0.0355}}));
}

TEST(PlantFileUwb, SaysWhichCorrectionIsWrong)
{
    EXPECT_NE(uwbError(R"({"corrections": [{"anchor": 7, "tag": 3, "offset_mm": 1}]})")
                  .find("/uwb/corrections/0/anchor: there is no anchor number 7 in \"anchors\""),
              std::string::npos);
    EXPECT_NE(uwbError(R"({"corrections": [{"anchor": 0, "tag": 3, "offset_mm": 1},
                                          {"anchor": 0, "tag": 4, "offset_mm": 1},
                                          {"anchor": 0, "tag": 3, "offset_mm": 2}]})")
                  .find("/uwb/corrections/2/anchor: anchor 0 and tag 3 are already corrected by "
                        "/uwb/corrections/0"),
              std::string::npos);
    EXPECT_NE(uwbError(R"({"corrections": [{"anchor": 0, "tag": 256, "offset_mm": 1}]})")
                  .find("/uwb/corrections/0/tag: must be"),
              std::string::npos);
    EXPECT_NE(uwbError(R"({"corrections": [{"anchor": 0, "tag": 3, "offset_mm": 10001}]})")
                  .find("/uwb/corrections/0/offset_mm: must be"),
              std::string::npos);
    for (const char* incomplete : {R"({"tag": 3, "offset_mm": 1})", R"({"anchor": 0, "offset_mm": 1})",
                                   R"({"anchor": 0, "tag": 3})", "4"})
        EXPECT_NE(
            uwbError(R"({"corrections": [)" + std::string(incomplete) + "]}").find("/uwb/corrections/0"),
            std::string::npos)
            << incomplete;
}

TEST(PlantFileUwb, SaysWhatIsWrongAndWhere)
{
    EXPECT_NE(
        uwbError(R"({"usb_id": "0483"})").find("/uwb/usb_id: must be vendor and product in hexadecimal"),
        std::string::npos);
    for (const char* dialect : {"trek-2", "unknown", ""})
        EXPECT_NE(uwbError(R"({"dialect": ")" + std::string(dialect) + "\"}")
                      .find("/uwb/dialect: must be \"detect\", \"trek\", \"trek-1.06\""),
                  std::string::npos);
    EXPECT_NE(uwbError(R"({"tags": [{"id": 256}]})").find("/uwb/tags/0/id: must be"), std::string::npos);
    EXPECT_NE(uwbError(R"({"tags": [{"label": "x"}]})").find("/uwb/tags/0"), std::string::npos);
    EXPECT_NE(uwbError(R"({"tags": [{"id": 1}, {"id": 1}]})")
                  .find("/uwb/tags/1/id: tag number 1 is already used by /uwb/tags/0/id"),
              std::string::npos);
    EXPECT_NE(uwbError(R"({"tags": [{"id": 1, "agv": 2}]})")
                  .find("/uwb/tags/0/agv: there is no AGV number 2 in \"agvs\""),
              std::string::npos);
}

TEST(PlantFileUwb, IsWrittenBackWithItsUnknownKeysAndWithoutItsDefaults)
{
    const std::string text =
        plantWith(R"({"made_by": "x", "tags": [{"id": 1, "agv": 1, "owner": "B"}, {"id": 2}]})");
    const auto original = PlantDocument::fromText(text, "p.json").value();
    PlantLayout plant = original.layout();
    plant.uwb.tags[0].agv.reset();
    plant.uwb.port.serialNumber = "77";
    const std::string written = plantText(plant, &original).value();
    EXPECT_EQ(readPlantText(written, "p.json"), plant);
    EXPECT_NE(written.find("\"made_by\": \"x\""), std::string::npos) << written;
    EXPECT_NE(written.find(R"({"id": 1, "agv": 0, "owner": "B"})"), std::string::npos) << written;
    EXPECT_NE(written.find(R"({"id": 2})"), std::string::npos) << written;
    EXPECT_NE(written.find(R"("serial_number": "77")"), std::string::npos) << written;
    EXPECT_EQ(written.find("dialect"), std::string::npos) << written;
}

TEST(PlantFileUwb, KeepsTheUnknownKeysOfACorrectionThatIsChanged)
{
    const std::string text = plantWith(R"({"corrections": [{"anchor": 0, "tag": 3, "offset_mm": 10},
        {"anchor": 0, "tag": 4, "offset_mm": 20, "measured_by": "B"}]})");
    const auto original = PlantDocument::fromText(text, "p.json").value();
    PlantLayout plant = original.layout();
    plant.uwb.corrections = {{0, 4, 0.025}, {0, 9, -0.001}};
    const std::string written = plantText(plant, &original).value();
    EXPECT_EQ(readPlantText(written, "p.json"), plant);
    EXPECT_NE(written.find(R"({"anchor": 0, "tag": 4, "offset_mm": 25, "measured_by": "B"})"),
              std::string::npos)
        << written;
    EXPECT_EQ(readPlantText(plantText(plant, nullptr).value(), "p.json"), plant);
}

} // namespace
} // namespace agv
