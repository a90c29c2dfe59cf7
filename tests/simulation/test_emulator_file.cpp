// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/emulator_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <sstream>

using namespace agv;
using namespace agv::simulation;

namespace {

std::string contentOf(const std::filesystem::path& path)
{
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::vector<std::string> linesOf(const EmulatorOptions& options)
{
    std::istringstream text(emulatorText(options).value());
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

class EmulatorFiles : public testing::Test {
protected:
    std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        ("emulator-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    void SetUp() override { std::filesystem::remove_all(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
};

} // namespace

TEST(Emulator, equalsTheReferenceVectors)
{
    std::ifstream file(std::string(AGV_TEST_DATA) + "/vectors/emulator.json");
    ASSERT_TRUE(file);
    const nlohmann::json vectors = nlohmann::json::parse(file);
    ASSERT_EQ(vectors["cases"].size(), 7U);
    for (const auto& example : vectors["cases"]) {
        EmulatorOptions options;
        options.columns = options.rows = example["field"] == "3x3" ? 3 : 11;
        options.centre = {metresFromMm(example["x"]), metresFromMm(example["y"])};
        options.bearing = radFromDeg(example["bearing"]);
        options.step = radFromDeg(example["step"]);
        options.antennaRadius_m = metresFromMm(example["R"]);
        options.stops = static_cast<int>(example["rows"].size());
        std::vector<std::vector<EmulatorReading>> expected;
        for (const auto& row : example["rows"]) {
            expected.emplace_back();
            for (const auto& reading : row)
                expected.back().push_back({reading[0], reading[1]});
        }
        EXPECT_EQ(emulateTurn(options), expected) << example["x"] << " " << example["bearing"];
    }
}

TEST(Emulator, writesFilteredLinesAsTheAppendixDoes)
{
    const auto lines = linesOf({});
    EXPECT_EQ(lines[0], "0  28 0 ");
    EXPECT_EQ(lines[2], "0  39 4 ");
    EXPECT_EQ(lines[6], "45  28 0 ");
    EXPECT_EQ(lines.back().substr(0, 4), "360 ");
}

TEST(Emulator, writesReaderLikeLinesAsTheAppendixDoes)
{
    EmulatorOptions options;
    options.readerLike = true;
    EXPECT_EQ(linesOf(options)[2], "0 SCAN:+UID=39+RSSI=4<\\r>");
    options.hexadecimal = true;
    EXPECT_EQ(linesOf(options)[2], "0 SCAN:+UID=0000000000000027+RSSI=4<\\r>");
}

TEST(Emulator, writesHexadecimalNumbersInFilteredLines)
{
    EmulatorOptions options;
    options.hexadecimal = true;
    EXPECT_EQ(linesOf(options)[2], "0  0000000000000027 4 ");
}

TEST(Emulator, writesOnlyChangesWhenAsked)
{
    // Vector: stop 0 reads 39:4 and 51:1 above zero; at stop 1 29 rises to 4, 39 falls to 0, 40 rises to 5,
    // 51 falls to 0.
    EmulatorOptions options;
    options.changesOnly = true;
    options.stops = 2;
    EXPECT_EQ(linesOf(options), (std::vector<std::string>{"0  39 4 ", "0  51 1 ", "45  29 4 ", "45  39 0 ",
                                                          "45  40 5 ", "45  51 0 "}));
}

TEST(Emulator, sideFileHasTagsSizeAndStartPose)
{
    EXPECT_EQ(emulatorSideText({}), "   121\n   100\n0.3927\n2.250000e+01\n5.150000e+01\n");
    EmulatorOptions options;
    options.columns = options.rows = 3;
    options.centre = {0.1, 0.1};
    options.bearing = 0.0;
    EXPECT_EQ(emulatorSideText(options), "     9\n    20\n0.0000\n    10\n    10\n");
}

TEST(Emulator, refusesFieldsAndPosesThatMakeNoSense)
{
    EmulatorOptions options;
    options.columns = 0;
    EXPECT_EQ(emulatorText(options).error().code, ErrorCode::BadInput);
    options = {};
    options.stops = 0;
    EXPECT_FALSE(emulateTurn(options));
    options = {};
    options.centre.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(emulateTurn(options));
}

TEST_F(EmulatorFiles, areWrittenIntoANewFolder)
{
    const auto paths = writeEmulatorFiles(folder / "new", {});
    ASSERT_TRUE(paths) << paths.error().detail;
    EXPECT_EQ(paths->readings.filename(), "Meas_StartingProc_like_reader_real_data11.txt");
    EXPECT_EQ(paths->side.filename(), "NumTags11.txt");
    EXPECT_EQ(contentOf(paths->readings), emulatorText({}).value());
    EXPECT_EQ(contentOf(paths->side), emulatorSideText({}));
}

TEST_F(EmulatorFiles, areRefusedWhereNoTagIsInRange)
{
    EmulatorOptions options;
    options.centre = {5.0, 0.5};
    const auto paths = writeEmulatorFiles(folder / "new", options);
    ASSERT_FALSE(paths);
    EXPECT_EQ(paths.error().code, ErrorCode::BadInput);
    EXPECT_EQ(
        paths.error().detail,
        "no tag of the 11x11 field comes into range at any stop, so the file would be empty: choose a place "
        "on the field, which goes to x 1000, y 1000 mm");
    EXPECT_FALSE(std::filesystem::exists(folder / "new"));
}

TEST_F(EmulatorFiles, nameTheFolderThatCannotBeMade)
{
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "file") << "in the way";
    const auto paths = writeEmulatorFiles(folder / "file" / "sub", {});
    ASSERT_FALSE(paths);
    EXPECT_EQ(paths.error().code, ErrorCode::Io);
    EXPECT_NE(paths.error().detail.find("sub"), std::string::npos);
}
