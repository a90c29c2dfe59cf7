// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plant_command.h"

#include "core/plant_file.h"
#include "core/text_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include <unistd.h>

namespace agv::app {
namespace {

const std::string plantText = R"({
  "format": "agv-plant", "version": 1, "owner": "laboratory",
  "size": {"width_mm": 1000, "height_mm": 1000},
  "floor_tags": {"grid": {"columns": 2, "rows": 2, "pitch_mm": 100, "first_uid": "A0"}},
  "agvs": [{"id": 1, "robot_host": "10.0.0.2", "colour": "red"}]
}
)";

class PlantCommandTest : public testing::Test {
protected:
    void SetUp() override
    {
        m_folder = std::filesystem::temp_directory_path() /
                   ("agv-plant-" + std::to_string(::getpid()) + "-" +
                    testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(m_folder);
        write("plant.json", plantText);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::string path(const char* name) const { return (m_folder / name).string(); }
    void write(const char* name, const std::string& text) const
    {
        ASSERT_TRUE(writeTextFile(path(name), text));
    }
    std::string textOf(const char* name) const { return readTextFile(path(name), 100'000).value(); }
    int run(const PlantArguments& arguments)
    {
        m_out.str({});
        m_err.str({});
        return runPlant(arguments, m_out, m_err);
    }
    PlantArguments importing() const
    {
        return {PlantAction::ImportTags, {path("plant.json")}, path("tags.csv"), {}, false};
    }

    std::filesystem::path m_folder;
    std::ostringstream m_out;
    std::ostringstream m_err;
};

} // namespace

TEST_F(PlantCommandTest, ChecksEveryFileAndWarnsAboutUnknownKeys)
{
    write("bad.json", "{\"format\": \"agv-plant\",\n \"version\": 0}");
    EXPECT_EQ(
        run({PlantAction::Check, {path("bad.json"), path("plant.json"), path("none.json")}, {}, {}, false}),
        1);
    EXPECT_EQ(m_out.str(),
              path("plant.json") + ": ok, 4 floor tags, 1 AGV, 0 stations, 0 obstacles, 0 anchors\n");
    const std::string errors = m_err.str();
    EXPECT_TRUE(errors.starts_with(path("bad.json") + ":2:13: /version: must be between")) << errors;
    const auto owner = errors.find("warning: " + path("plant.json") + ":2:40: /owner: this key is unknown");
    const auto colour = errors.find("warning: " + path("plant.json") + ":5:48: /agvs/0/colour: this key");
    EXPECT_NE(colour, std::string::npos) << errors;
    EXPECT_LT(owner, colour) << errors;
    EXPECT_NE(errors.find(path("none.json") + ": cannot be opened"), std::string::npos) << errors;
    EXPECT_EQ(run({PlantAction::Check, {path("plant.json")}, {}, {}, false}), 0);
}

TEST_F(PlantCommandTest, SaysThatItsOutputDidNotArrive)
{
    m_out.setstate(std::ios::badbit);
    std::ostringstream err;
    for (const PlantAction action : {PlantAction::Check, PlantAction::ExportTags}) {
        err.str({});
        EXPECT_EQ(runPlant({action, {path("plant.json")}, {}, {}, false}, m_out, err), 1);
        EXPECT_NE(err.str().find("standard output: cannot be written"), std::string::npos) << err.str();
    }
}

TEST_F(PlantCommandTest, ExportsTheTagsAsATable)
{
    EXPECT_EQ(run({PlantAction::ExportTags, {path("plant.json")}, {}, {}, false}), 0);
    const std::string table = m_out.str();
    EXPECT_TRUE(table.starts_with("uid,x_mm,y_mm,number\n00000000000000A0,0,0,1\n00000000000000A1,0,100,2\n"))
        << table;
    EXPECT_EQ(run({PlantAction::ExportTags, {path("plant.json")}, {}, path("tags.csv"), false}), 0);
    EXPECT_EQ(textOf("tags.csv"), table);
}

TEST_F(PlantCommandTest, ATableThatWasExportedChangesNothingWhenItIsImported)
{
    ASSERT_EQ(run({PlantAction::ExportTags, {path("plant.json")}, {}, path("tags.csv"), false}), 0);
    const PlantLayout before = readPlantFile(path("plant.json")).value();
    EXPECT_EQ(run(importing()), 0) << m_err.str();
    EXPECT_EQ(readPlantFile(path("plant.json")), before);
    EXPECT_NE(textOf("plant.json").find("\"grid\""), std::string::npos);
}

TEST_F(PlantCommandTest, TakesSurveyedTagsOverAndKeepsTheRestOfTheFile)
{
    write("tags.csv", "x_mm;uid;y_mm\n10,5;A1;99,5\n500;B7;600\n");
    EXPECT_EQ(run(importing()), 0) << m_err.str();
    EXPECT_EQ(m_out.str(), path("plant.json") + ": 2 tags taken over, 2 floor tags now\n");
    const PlantLayout plant = readPlantFile(path("plant.json")).value();
    ASSERT_EQ(plant.floorTags.size(), 2U);
    EXPECT_EQ(plant.floorTags[0], (FloorTag{TagUid{0xA1}, {0.0105, 0.0995}, 1}));
    for (const char* const kept : {"\"owner\": \"laboratory\"", "\"colour\": \"red\""})
        EXPECT_NE(textOf("plant.json").find(kept), std::string::npos) << kept;
}

TEST_F(PlantCommandTest, MergesSurveyedTagsWithThoseThatAreThere)
{
    write("tags.csv", "uid,x_mm,y_mm\nA1,10.5,99.5\nB7,500,600\n");
    PlantArguments arguments = importing();
    arguments.merge = true;
    arguments.outFile = path("new.json");
    EXPECT_EQ(run(arguments), 0) << m_err.str();
    EXPECT_EQ(textOf("plant.json"), plantText);
    const PlantLayout plant = readPlantFile(path("new.json")).value();
    ASSERT_EQ(plant.floorTags.size(), 5U);
    EXPECT_EQ(plant.floorTags[1], (FloorTag{TagUid{0xA1}, {0.0105, 0.0995}, 2}));
    EXPECT_EQ(plant.floorTags[3].position, (Point2{0.1, 0.1}));
    EXPECT_EQ(plant.floorTags[4].uid, TagUid{0xB7});
}

TEST_F(PlantCommandTest, ChangesNothingWhenTheTableIsWrong)
{
    write("tags.csv", "uid,x_mm,y_mm\nA1,10,wide\n");
    EXPECT_EQ(run(importing()), 1);
    EXPECT_TRUE(m_err.str().find(path("tags.csv") + ":2: y_mm: must be a number") != std::string::npos)
        << m_err.str();
    write("tags.csv", "uid,x_mm,y_mm\nA1,10,1000.5\n");
    EXPECT_EQ(run(importing()), 1);
    EXPECT_NE(m_err.str().find("the tag at (10, 1000.5) mm is outside the plant"), std::string::npos)
        << m_err.str();
    EXPECT_EQ(textOf("plant.json"), plantText);
    PlantArguments none = importing();
    none.csvFile = path("none.csv");
    EXPECT_EQ(run(none), 1);
    EXPECT_NE(m_err.str().find("none.csv: cannot be opened"), std::string::npos);
}

} // namespace agv::app
