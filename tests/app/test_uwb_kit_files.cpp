// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "app/uwb_kit_files.h"
#include "core/plant_file.h"
#include "core/text_file.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace agv::app {
namespace {

constexpr const char* plantWithAComment = R"({
  "format": "agv-plant", "version": 1, "name": "Hall 2",
  "size": {"width_mm": 9000, "height_mm": 6000},
  "floor_tags": {"grid": {"columns": 3, "rows": 3, "pitch_mm": 100, "first_uid": "E00401503B000001"}},
  "agvs": [{"id": 1, "reader": "127.0.0.2:8883", "painted": "red"}],
  "anchors": [{"id": 0, "label": "North", "x_mm": 0, "y_mm": 0, "z_mm": 2000},
              {"id": 5, "label": "East", "x_mm": 4000, "y_mm": 0, "z_mm": 2000}],
  "uwb": {"port": "/dev/ttyACM7",
          "tags": [{"id": 2, "label": "Cart", "agv": 1, "z_mm": 450}],
          "corrections": [{"anchor": 0, "tag": 2, "offset_mm": 35}, {"anchor": 5, "tag": 9, "offset_mm": -20}]}
})";

class UwbKitFiles : public testing::Test {
protected:
    UwbKitFiles()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "agv-uwb-kit-XXXXXX").string();
        folder = ::mkdtemp(pattern.data());
        const Result<PlantLayout> read = readPlantText(plantWithAComment, "plant.json");
        EXPECT_TRUE(read) << read.error().detail;
        plant = read.value_or(PlantLayout{});
    }
    ~UwbKitFiles() override
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    }
    std::filesystem::path file(const std::string& name, const std::string& text) const
    {
        EXPECT_TRUE(writeTextFile(folder / name, text));
        return folder / name;
    }
    std::string textOf(const std::filesystem::path& path) const
    {
        return readTextFile(path, maxPlantFileBytes).value_or("");
    }

    std::filesystem::path folder;
    PlantLayout plant;
};

TEST_F(UwbKitFiles, ATableReplacesTheAnchorsAndTheCorrectionsOfThoseThatAreGone)
{
    const auto kit = importUwb(file("a.csv", "anchor,x_m,y_m,z_m\n0,1,2,3\n1,4,5,2\n"), plant);
    ASSERT_TRUE(kit) << kit.error().detail;
    ASSERT_EQ(kit->anchors.size(), 2U);
    EXPECT_DOUBLE_EQ(kit->anchors[0].y, 2.0);
    EXPECT_EQ(kit->anchors[1].label, "A1");
    EXPECT_EQ(kit->settings.corrections, (std::vector<RangeCorrection>{{0, 2, 0.035}}));
    EXPECT_EQ(kit->settings.tags, plant.uwb.tags);
    EXPECT_TRUE(kit->notes.empty());
}

TEST_F(UwbKitFiles, TheAnchorsOfTheExistingProgramBringTheirCorrectionsAndLeaveThoseOfOtherTags)
{
    const auto kit =
        importUwb(file("TREKanc_config.xml",
                       "<config>\n<anc ID=\"0\" label=\"\" x=\"0\" y=\"0\" z=\"2\" t0=\"3\"/>\n"
                       "<anc ID=\"5\" label=\"E\" x=\"4\" y=\"0\" z=\"2\"/>\n<anc ID=\"x\"/>\n</config>\n"),
                  plant);
    ASSERT_TRUE(kit) << kit.error().detail;
    ASSERT_EQ(kit->anchors.size(), 2U);
    EXPECT_EQ(kit->settings.corrections, (std::vector<RangeCorrection>{{5, 9, -0.02}, {0, 0, 0.03}}));
    ASSERT_EQ(kit->notes.size(), 1U);
    EXPECT_NE(kit->notes[0].find("TREKanc_config.xml:4: "), std::string::npos) << kit->notes[0];
}

TEST_F(UwbKitFiles, TheTagsOfTheExistingProgramGiveLabelsAndAreAddedWithTheUsualHeight)
{
    const auto kit = importUwb(file("TREKtag_config.xml", "<config><tag_cfg size=\"0.15\" history=\"20\"/>"
                                                          "<tag ID=\"2\" label=\"New name\"/>"
                                                          "<tag ID=\"a\" label=\"Ten\"/></config>"),
                               plant);
    ASSERT_TRUE(kit) << kit.error().detail;
    ASSERT_EQ(kit->settings.tags.size(), 2U);
    EXPECT_EQ(kit->settings.tags[0].label, "New name");
    EXPECT_EQ(kit->settings.tags[0].agv, RobotId{1});
    EXPECT_DOUBLE_EQ(kit->settings.tags[0].z_m, 0.45);
    EXPECT_EQ(kit->settings.tags[1].id, 10);
    EXPECT_DOUBLE_EQ(kit->settings.tags[1].z_m, plant.uwb.tagHeight_m);
    ASSERT_EQ(kit->notes.size(), 1U);
    EXPECT_NE(kit->notes[0].find("300 mm"), std::string::npos) << kit->notes[0];
}

TEST_F(UwbKitFiles, APlantFileBringsItsKitButNotItsPort)
{
    PlantLayout here = plant;
    here.anchors.clear();
    here.uwb = {};
    here.uwb.port.path = "/dev/ttyUSB1";
    const auto imported = importUwb(file("plant.json", plantWithAComment), here);
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported->anchors, plant.anchors);
    EXPECT_EQ(imported->settings.corrections, plant.uwb.corrections);
    EXPECT_EQ(imported->settings.port.path, "/dev/ttyUSB1");
}

TEST_F(UwbKitFiles, WhatCannotBeReadNamesFileAndLine)
{
    const auto table = importUwb(file("a.csv", "anchor,x_m,y_m,z_m\n0,1,far,3\n"), plant);
    ASSERT_FALSE(table);
    EXPECT_NE(table.error().detail.find("a.csv:2: "), std::string::npos) << table.error().detail;
    const auto xml = importUwb(file("b.xml", "<html/>"), plant);
    ASSERT_FALSE(xml);
    EXPECT_NE(xml.error().detail.find("b.xml"), std::string::npos) << xml.error().detail;
    const auto missing = importUwb(folder / "none.csv", plant);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
    const auto empty = importUwb(file("c.json", R"({"format": "agv-plant", "version": 1, "name": "Hall",
        "size": {"width_mm": 900, "height_mm": 600}, "agvs": []})"),
                                 plant);
    ASSERT_FALSE(empty);
}

TEST_F(UwbKitFiles, ATableTooFarOutForAPlantFileIsRefused)
{
    const auto kit = importUwb(file("far.csv", "anchor,x_m,y_m,z_m\n0,1e9,2,3\n"), plant);
    ASSERT_FALSE(kit);
    EXPECT_NE(kit.error().detail.find("far.csv"), std::string::npos) << kit.error().detail;
}

TEST_F(UwbKitFiles, WhatIsExportedIsImportedTheSame)
{
    for (const char* const name : {"anchors.csv", "anchors.xml"}) {
        const auto written = exportUwb(folder / name, plant.anchors, plant.uwb);
        ASSERT_TRUE(written) << written.error().detail;
        PlantLayout without = plant;
        without.anchors.clear();
        const auto kit = importUwb(folder / name, without);
        ASSERT_TRUE(kit) << kit.error().detail;
        EXPECT_EQ(kit->anchors, plant.anchors) << name;
    }
}

TEST_F(UwbKitFiles, AnExportThatCannotBeWrittenSaysWhere)
{
    const auto written = exportUwb(folder / "no such folder" / "a.csv", plant.anchors, plant.uwb);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().detail.find("no such folder"), std::string::npos) << written.error().detail;
}

TEST_F(UwbKitFiles, SavingChangesTheKitAloneAndKeepsUnknownKeys)
{
    const auto path = file("plant.json", plantWithAComment);
    plant.anchors[0].x = 0.25;
    plant.uwb.tags[0].label = "Trolley";
    ASSERT_TRUE(saveUwb(path, plant.anchors, plant.uwb));
    const Result<PlantLayout> read = readPlantFile(path);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read->anchors, plant.anchors);
    EXPECT_EQ(read->uwb, plant.uwb);
    EXPECT_NE(textOf(path).find("\"painted\": \"red\""), std::string::npos) << textOf(path);
}

TEST_F(UwbKitFiles, ASaveThatFailsLeavesTheFileAsItWas)
{
    const auto path = file("plant.json", plantWithAComment);
    plant.anchors[1].id = plant.anchors[0].id;
    ASSERT_FALSE(saveUwb(path, plant.anchors, plant.uwb));
    EXPECT_EQ(textOf(path), plantWithAComment);
}

} // namespace
} // namespace agv::app
