// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "app/sleeptime_file.h"
#include "core/plant_file.h"
#include "core/text_file.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace agv::app {
namespace {

constexpr const char* plantWithAComment = R"({
  "format": "agv-plant", "version": 1, "name": "Hall 2",
  "size": {"width_mm": 1000, "height_mm": 1000},
  "floor_tags": {"grid": {"columns": 3, "rows": 3, "pitch_mm": 100, "first_uid": "E00401503B000001"}},
  "agvs": [{"id": 1, "reader": "127.0.0.2:8883", "sleeptime_ms": 1150, "painted": "red"},
           {"id": 2, "reader": "127.0.0.3:8883", "sleeptime_ms": 1200}]
})";

class SleeptimeFile : public testing::Test {
protected:
    SleeptimeFile()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "agv-sleeptime-XXXXXX").string();
        m_folder = ::mkdtemp(pattern.data());
        path = m_folder / "plant.json";
    }
    ~SleeptimeFile() override
    {
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    std::string text() const { return readTextFile(path, maxPlantFileBytes).value_or(""); }

    std::filesystem::path path;

private:
    std::filesystem::path m_folder;
};

TEST_F(SleeptimeFile, ChangesOneAgvAndKeepsTheRestWithItsUnknownKeys)
{
    ASSERT_TRUE(writeTextFile(path, plantWithAComment));
    const Result<double> before = writeSleeptime(path, RobotId{1}, 1.201, 0.1);
    ASSERT_TRUE(before) << before.error().detail;
    EXPECT_DOUBLE_EQ(*before, 1.15);
    const Result<PlantLayout> plant = readPlantFile(path);
    ASSERT_TRUE(plant) << plant.error().detail;
    EXPECT_DOUBLE_EQ(plant->agvs[0].turnTime_s, 1.201);
    EXPECT_DOUBLE_EQ(plant->agvs[1].turnTime_s, 1.2);
    EXPECT_EQ(plant->name, "Hall 2");
    EXPECT_NE(text().find("\"painted\": \"red\""), std::string::npos) << text();
}

TEST_F(SleeptimeFile, WritesTheWheelSpeedItBelongsToWhenThatIsAnother)
{
    ASSERT_TRUE(writeTextFile(path, plantWithAComment));
    ASSERT_TRUE(writeSleeptime(path, RobotId{2}, 2.4, 0.05));
    const Result<PlantLayout> plant = readPlantFile(path);
    ASSERT_TRUE(plant) << plant.error().detail;
    EXPECT_DOUBLE_EQ(plant->agvs[1].turnTime_s, 2.4);
    EXPECT_DOUBLE_EQ(plant->agvs[1].turnSpeed_m_s, 0.05);
    EXPECT_DOUBLE_EQ(plant->agvs[0].turnSpeed_m_s, 0.1);
}

TEST_F(SleeptimeFile, KeepsWhatSomebodyElseChangedSinceTheStart)
{
    ASSERT_TRUE(writeTextFile(path, plantWithAComment));
    ASSERT_TRUE(writeSleeptime(path, RobotId{2}, 1.3, 0.1));
    ASSERT_TRUE(writeSleeptime(path, RobotId{1}, 1.2, 0.1));
    const Result<PlantLayout> plant = readPlantFile(path);
    ASSERT_TRUE(plant) << plant.error().detail;
    EXPECT_DOUBLE_EQ(plant->agvs[1].turnTime_s, 1.3);
}

TEST_F(SleeptimeFile, TakenBackItReadsAsBefore)
{
    ASSERT_TRUE(writeTextFile(path, plantWithAComment));
    const Result<double> before = writeSleeptime(path, RobotId{1}, 1.201, 0.1);
    ASSERT_TRUE(before);
    ASSERT_TRUE(writeSleeptime(path, RobotId{1}, *before, 0.1));
    EXPECT_EQ(readPlantFile(path).value(), readPlantText(plantWithAComment, "plant").value());
}

TEST_F(SleeptimeFile, AnAgvThatIsGoneLeavesTheFileAsItIs)
{
    ASSERT_TRUE(writeTextFile(path, plantWithAComment));
    const Result<double> result = writeSleeptime(path, RobotId{7}, 1.2, 0.1);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::NotFound);
    EXPECT_NE(result.error().detail.find("no longer has an AGV 7"), std::string::npos)
        << result.error().detail;
    EXPECT_EQ(text(), plantWithAComment);
}

TEST_F(SleeptimeFile, AFileThatBecameInvalidIsNamedAndLeftAsItIs)
{
    ASSERT_TRUE(writeTextFile(path, "{"));
    const Result<double> result = writeSleeptime(path, RobotId{1}, 1.2, 0.1);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().detail.find("plant.json"), std::string::npos) << result.error().detail;
    EXPECT_EQ(text(), "{");
}

TEST_F(SleeptimeFile, AFileThatIsGoneIsNotMadeAnew)
{
    const Result<double> result = writeSleeptime(path, RobotId{1}, 1.2, 0.1);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::NotFound);
    EXPECT_FALSE(std::filesystem::exists(path));
}

} // namespace
} // namespace agv::app
