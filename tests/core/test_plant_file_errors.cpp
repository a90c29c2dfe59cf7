// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_file.h"

#include <gtest/gtest.h>

#include <string>

using namespace agv;

namespace {

/// A small plant file, one line per thing, for tests that spoil one of them.
const std::string goodText = R"({
  "format": "agv-plant",
  "version": 1,
  "name": "Test",
  "size": {"width_mm": 1000, "height_mm": 2000},
  "floor_tags": {
    "grid": {"columns": 3, "rows": 3, "pitch_mm": 100, "first_uid": "E004015000000001"},
    "list": [
      {"uid": "E00401503A5BDAE4", "x_mm": 500, "y_mm": 600},
      {"uid": "E00401503A5BD586", "x_mm": 500, "y_mm": 700, "number": 77}
    ]
  },
  "stations": [{"name": "S", "kind": "mixing", "x_mm": 500, "y_mm": 1900}],
  "obstacles": [{"name": "Pillar", "outline_mm": [[0, 0], [100, 0], [0, 100]]}],
  "agvs": [
    {"id": 1, "robot_host": "10.0.0.2", "reader": "10.0.1.2:8883"},
    {"id": 2, "robot_host": "10.0.0.3", "reader": "10.0.1.3:8883", "track_mm": 286.5}
  ],
  "rssi_table": [{"upper_edge_mm": 140, "rssi": 0}, {"upper_edge_mm": 70, "rssi": 5}],
  "anchors": [{"id": 0, "x_mm": 0, "y_mm": 0}, {"id": 1, "x_mm": 0, "y_mm": 0}],
  "listen": {"robots": "127.0.0.1:2001", "telemetry_port": 2000}
}
)";

std::string spoilt(const std::string& what, const std::string& by)
{
    const auto at = goodText.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return std::string(goodText).replace(at, what.size(), by);
}

std::string errorOf(const std::string& text)
{
    const auto plant = readPlantText(text, "p.json");
    if (plant)
        return "accepted";
    EXPECT_EQ(plant.error().code, ErrorCode::BadInput);
    return plant.error().detail;
}

struct Mistake {
    const char* name;
    std::string what;
    std::string by;
    std::string message;
};

class PlantFileMistake : public testing::TestWithParam<Mistake> {};

} // namespace

TEST(PlantFile, acceptsTheTextThatTheMistakesAreMadeIn)
{
    const auto document = PlantDocument::fromText(goodText, "p.json");
    ASSERT_TRUE(document) << document.error().detail;
    EXPECT_TRUE(document->warnings().empty());
    EXPECT_EQ(document->layout().floorTags.size(), 11U);
    EXPECT_EQ(document->layout().floorTags[9].number, 10);
    EXPECT_EQ(document->layout().floorTags[10].number, 77);
}

TEST_P(PlantFileMistake, isReportedAtItsPlace)
{
    EXPECT_EQ(errorOf(spoilt(GetParam().what, GetParam().by)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Each, PlantFileMistake,
    testing::Values(
        Mistake{"wrongType", R"("track_mm": 286.5)", R"("track_mm": "wide")",
                R"(p.json:17:80: /agvs/1/track_mm: must be a number (is "wide"))"},
        Mistake{"outOfRange", R"("track_mm": 286.5)", R"("track_mm": -5)",
                "p.json:17:80: /agvs/1/track_mm: must be between 50 and 2000 (is -5)"},
        Mistake{"rangeOfDouble", R"("track_mm": 286.5)", R"("track_mm": 1e400)",
                "p.json:17:80: /agvs/1/track_mm: must be between 50 and 2000 (is 1e+400)"},
        Mistake{"sleeptimeNoTurnMayHave", R"("track_mm": 286.5)", R"("sleeptime_ms": 99)",
                "p.json:17:84: /agvs/1/sleeptime_ms: must be between 100 and 10000 (is 99)"},
        Mistake{"sleeptimeTooLong", R"("track_mm": 286.5)", R"("sleeptime_ms": 10001)",
                "p.json:17:84: /agvs/1/sleeptime_ms: must be between 100 and 10000 (is 10001)"},
        Mistake{"turnSpeedTooLow", R"("track_mm": 286.5)", R"("turn_speed_mm_s": 9)",
                "p.json:17:87: /agvs/1/turn_speed_mm_s: must be between 10 and 250 (is 9)"},
        Mistake{"turnSpeedNoTurnMayHave", R"("track_mm": 286.5)", R"("turn_speed_mm_s": 251)",
                "p.json:17:87: /agvs/1/turn_speed_mm_s: must be between 10 and 250 (is 251)"},
        Mistake{"fraction", R"("id": 2)", R"("id": 2.5)",
                "p.json:17:12: /agvs/1/id: must be a whole number (is 2.5)"},
        Mistake{"missingKey", R"("id": 2, )", "",
                R"(p.json:17:5: /agvs/1: the key "id" is missing; add it with a number)"},
        Mistake{
            "missingSize", R"("size": {"width_mm": 1000, "height_mm": 2000},)", "",
            R"(p.json:1:1: the key "size" is missing; add "size": {"width_mm": 3000, "height_mm": 4000})"},
        Mistake{"notAnObject", R"({"width_mm": 1000, "height_mm": 2000})", "[1000, 2000]",
                "p.json:5:11: /size: must be an object in braces (is an array)"},
        Mistake{"notAnArray", R"([{"name": "S", "kind": "mixing", "x_mm": 500, "y_mm": 1900}])", "{}",
                "p.json:13:15: /stations: must be an array in brackets (is an object)"},
        Mistake{"elementNotAnObject", R"([{"name": "S", "kind": "mixing", "x_mm": 500, "y_mm": 1900}])",
                "[7]", "p.json:13:16: /stations/0: must be an object in braces (is 7)"},
        Mistake{"textWanted", R"("name": "Test")", R"("name": null)",
                "p.json:4:11: /name: must be a text in quotation marks (is null)"},
        Mistake{
            "unknownKind", R"("mixing")", R"("blending")",
            "p.json:13:38: /stations/0/kind: must be \"colour\", \"mixing\", \"storage\", \"charging\" or "
            "\"other\" (is \"blending\")"},
        Mistake{
            "noFormat", R"("format": "agv-plant",)", "",
            "p.json:1:1: the key \"format\" is missing; add \"format\": \"agv-plant\"; without it this is no "
            "plant file"},
        Mistake{"otherFormat", R"("agv-plant")", R"("run")",
                R"(p.json:2:13: /format: must be "agv-plant" (is "run"); this is no plant file)"},
        Mistake{
            "newerVersion", R"("version": 1)", R"("version": 2)",
            "p.json:3:14: /version: the file has version 2 and was made by a newer console; this one reads "
            "version 1. Update the console"},
        Mistake{"versionZero", R"("version": 1)", R"("version": 0)",
                "p.json:3:14: /version: must be between 1 and 2147483647 (is 0)"},
        Mistake{"sameAgv", R"("id": 2)", R"("id": 1)",
                "p.json:17:12: /agvs/1/id: AGV number 1 is already used by /agvs/0/id"},
        Mistake{"sameReader", "10.0.1.3", "10.0.1.2",
                "p.json:17:51: /agvs/1/reader: the reader address 10.0.1.2:8883 is already used by "
                "/agvs/0/reader"},
        Mistake{"sameRobot", "10.0.0.3", "10.0.0.2",
                "p.json:17:29: /agvs/1/robot_host: the robot address 10.0.0.2 is already used by "
                "/agvs/0/robot_host; the console could not tell the two robots apart"},
        Mistake{"noRobot", R"("10.0.0.3")", R"("")",
                "p.json:17:29: /agvs/1/robot_host: must be the address the robot connects from, in numbers "
                "such as \"192.168.1.2\" (is \"\")"},
        Mistake{"robotByName", R"("10.0.0.3")", R"("agv2.plant")",
                "p.json:17:29: /agvs/1/robot_host: must be the address the robot connects from, in numbers "
                "such as \"192.168.1.2\" (is \"agv2.plant\")"},
        Mistake{"robotMistyped", R"("10.0.0.3")", R"("10.0.0.300")",
                "p.json:17:29: /agvs/1/robot_host: must be the address the robot connects from, in numbers "
                "such as \"192.168.1.2\" (is \"10.0.0.300\")"},
        Mistake{"noRobotBeyondTheOldRule", R"("id": 2, "robot_host": "10.0.0.3")", R"("id": 9)",
                R"(p.json:17:5: /agvs/1: the key "robot_host" is missing; add it with a text in quotation )"
                R"(marks)"},
        Mistake{"usualRobotAddressIsTaken", R"("id": 2, "robot_host": "10.0.0.3")",
                R"("id": 2}, {"id": 3, "robot_host": "127.0.0.3")",
                "p.json:17:40: /agvs/2/robot_host: the robot address 127.0.0.3 is already used by "
                "/agvs/1/robot_host; the console could not tell the two robots apart"},
        Mistake{"sameAnchor", R"({"id": 1, "x)", R"({"id": 0, "x)",
                "p.json:20:55: /anchors/1/id: anchor number 0 is already used by /anchors/0/id"},
        Mistake{"sameTagInList", "E00401503A5BD586", "e00401503a5bdae4",
                "p.json:10:15: /floor_tags/list/1/uid: tag E00401503A5BDAE4 is already used by "
                "/floor_tags/list/0/uid; every tag has its own UID"},
        Mistake{
            "sameTagAsGrid", "E00401503A5BD586", "E004015000000009",
            "p.json:10:15: /floor_tags/list/1/uid: tag E004015000000009 is already used by /floor_tags/grid "
            "(tag 9); every tag has its own UID"},
        Mistake{"badUid", "E00401503A5BD586", "E00401503A5BD58G",
                "p.json:10:15: /floor_tags/list/1/uid: must be a tag UID, 1 to 16 hexadecimal digits such as "
                "\"E00401503A5BDAE4\" (is \"E00401503A5BD58G\")"},
        Mistake{"tagOutside", R"("y_mm": 700)", R"("y_mm": 2000.5)",
                "p.json:10:7: /floor_tags/list/1: the tag at (500, 2000.5) mm is outside the plant, which "
                "reaches "
                "from (0, 0) to (1000, 2000) mm; correct it or /size"},
        Mistake{"gridOutside", R"("columns": 3)", R"("columns": 12)",
                "p.json:7:25: /floor_tags/grid/columns: tag 36 of the grid at (1100, 200) mm is outside the "
                "plant, "
                "which reaches from (0, 0) to (1000, 2000) mm; correct it or /size"},
        Mistake{"hugeGrid", R"("columns": 3, "rows": 3)", R"("columns": 9999, "rows": 9999)",
                "p.json:7:39: /floor_tags/grid/rows: gives 99980001 tags; at most 250000 are allowed"},
        Mistake{"uidOverflow", "E004015000000001", "FFFFFFFFFFFFFFFF",
                "p.json:7:69: /floor_tags/grid/first_uid: is too large for 9 tags counted up from it"},
        Mistake{
            "stationOutside", R"("y_mm": 1900)", R"("y_mm": -1)",
            "p.json:13:16: /stations/0: the station at (500, -1) mm is outside the plant, which reaches from "
            "(0, 0) to (1000, 2000) mm; correct it or /size"},
        Mistake{"twoCorners", "[[0, 0], [100, 0], [0, 100]]", "[[0, 0], [100, 0]]",
                "p.json:14:50: /obstacles/0/outline_mm: must have 3 points [x, y] or more (is 2)"},
        Mistake{"badCorner", "[100, 0]", "[100]",
                "p.json:14:59: /obstacles/0/outline_mm/1: must be a point [x, y] in mm (is an array)"},
        Mistake{"badCornerValue", "[100, 0]", "[100, true]",
                "p.json:14:65: /obstacles/0/outline_mm/1/1: must be a number (is true)"},
        Mistake{
            "risingEdges", R"("upper_edge_mm": 70)", R"("upper_edge_mm": 140)",
            "p.json:19:71: /rssi_table/1/upper_edge_mm: must be below the edge before it; the steps go from "
            "far to near"},
        Mistake{"rssiOfEight", R"("rssi": 5)", R"("rssi": 8)",
                "p.json:19:83: /rssi_table/1/rssi: must be between 0 and 7 (is 8)"},
        Mistake{"noSteps", R"([{"upper_edge_mm": 140, "rssi": 0}, {"upper_edge_mm": 70, "rssi": 5}])", "[]",
                "p.json:19:17: /rssi_table: must have one step or more; leave the key out for the built-in "
                "table"},
        Mistake{"readerWithoutPort", "10.0.1.3:8883", "10.0.1.3",
                "p.json:17:51: /agvs/1/reader: must be \"address:port\" with a port from 1 to 65535, such as "
                "\"192.168.0.100:8883\" (is \"10.0.1.3\")"},
        Mistake{"readerPortZero", "10.0.1.3:8883", "10.0.1.3:0",
                "p.json:17:51: /agvs/1/reader: must be \"address:port\" with a port from 1 to 65535, such as "
                "\"192.168.0.100:8883\" (is \"10.0.1.3:0\")"},
        Mistake{"listenPort", "127.0.0.1:2001", "127.0.0.1:65536",
                "p.json:21:24: /listen/robots: must be \"address:port\" with a port from 0 to 65535, such as "
                "\"127.0.0.1:2001\" (is \"127.0.0.1:65536\")"},
        Mistake{"listenByName", "127.0.0.1:2001", "plant-pc:2001",
                "p.json:21:24: /listen/robots: must begin with an address of this computer in numbers, such "
                "as 127.0.0.1, or 0.0.0.0 for all (is \"plant-pc:2001\")"},
        Mistake{"telemetryPort", "2000}\n}", "70000}\n}",
                "p.json:21:60: /listen/telemetry_port: must be between 0 and 65535 (is 70000)"},
        Mistake{"turnFasterThanMax", R"("track_mm": 286.5)", R"("max_speed_mm_s": 50)",
                "p.json:17:86: /agvs/1/max_speed_mm_s: the turn speed must not be above the greatest speed"},
        Mistake{"sameKeyTwice", R"("track_mm": 286.5)", R"("id": 3)",
                "p.json:17:68: /agvs/1/id: the key is already used at 17:6; remove one of the two"},
        Mistake{"missingComma", "\"Test\",", "\"Test\"",
                "p.json:5:3: not JSON: a comma is missing before this key"},
        Mistake{"trailingComma", "\"telemetry_port\": 2000}", "\"telemetry_port\": 2000,}",
                "p.json:21:65: not JSON: remove the comma before this brace"},
        Mistake{"nan", "286.5", "NaN",
                "p.json:17:80: not JSON: expected a number, a text in quotation marks, true, false, null, "
                "[...] or {...}"},
        Mistake{"overflow", "286.5", "1e99999",
                "p.json:17:80: the number is too large; no value of a plant file comes near"},
        Mistake{"truncated", goodText.substr(300), "",
                "p.json:10:9: the text ends too early; a bracket, brace or quotation mark is not closed"},
        Mistake{"notUtf8", "Test", "T\xC3",
                "p.json:4:13: the byte is not UTF-8 text; save the file with UTF-8 encoding"},
        Mistake{"empty", goodText, "", "p.json:1:1: the file is empty"},
        Mistake{"secondValue", "2000}\n}", "2000}\n} 7",
                "p.json:22:3: not JSON: nothing may follow the end of the plant"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(PlantFile, reportsTheMistakeThatStandsFirstInTheText)
{
    std::string text = spoilt(R"("telemetry_port": 2000)", R"("telemetry_port": -1)");
    text.replace(text.find("\"rssi\": 5"), 9, "\"rssi\": 9");
    EXPECT_EQ(errorOf(text), "p.json:19:83: /rssi_table/1/rssi: must be between 0 and 7 (is 9)");
}

TEST(PlantFile, countsColumnsInCharacters)
{
    EXPECT_EQ(errorOf(spoilt(R"("name": "Test")", R"("name": "M\u00e4rz \u00dc \ud83d\ude00", "size": 0)")),
              "p.json:5:3: /size: the key is already used at 4:44; remove one of the two");
    EXPECT_EQ(errorOf(spoilt(R"("name": "Test")", "\"name\": \"\u00e4\U0001F600\", \"anchors\": 0")),
              "p.json:20:3: /anchors: the key is already used at 4:17; remove one of the two");
}

TEST(PlantFile, refusesNestingThatCouldExhaustTheStack)
{
    const std::string deep = std::string(100'000, '[');
    EXPECT_EQ(errorOf(spoilt("\"Test\"", deep)), "p.json:4:73: nested deeper than 64 levels");
}

TEST(PlantFile, everyTruncationIsRefusedWithAPlace)
{
    for (std::size_t length = 0; length + 2 < goodText.size(); ++length)
        EXPECT_TRUE(errorOf(goodText.substr(0, length)).starts_with("p.json:")) << length;
}

TEST(PlantFile, refusesEveryMalformedUtf8Sequence)
{
    for (const char* const bytes : {"\x80", "\xC0\x80", "\xC3(", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE2\x82",
                                    "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"})
        EXPECT_EQ(errorOf(spoilt("Test", bytes)),
                  "p.json:4:12: the byte is not UTF-8 text; save the file with UTF-8 encoding");
    for (const char* const good : {"\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x98\x80", "\xF4\x8F\xBF\xBF"})
        EXPECT_EQ(errorOf(spoilt("Test", good)), "accepted");
}

TEST(PlantFile, acceptsAByteOrderMark) { EXPECT_EQ(errorOf("\xEF\xBB\xBF" + goodText), "accepted"); }

TEST(PlantFile, warnsAboutUnknownKeysAndGuessesTheOneThatWasMeant)
{
    const auto document =
        PlantDocument::fromText(spoilt("\"track_mm\"", "\"trak_mm\": 1, \"colour\""), "p.json");
    ASSERT_TRUE(document);
    EXPECT_EQ(
        document->warnings(),
        (std::vector<std::string>{"p.json:17:68: /agvs/1/trak_mm: this key is unknown and has no effect; "
                                  "did you mean \"track_mm\"?",
                                  "p.json:17:82: /agvs/1/colour: this key is unknown and has no effect"}));
}

TEST(PlantFile, namesNoMoreThanFiftyUnknownKeys)
{
    std::string keys;
    for (int i = 0; i < 60; ++i)
        keys += "\"unknown" + std::to_string(i) + "\": 0, ";
    const auto document =
        PlantDocument::fromText(spoilt("\"name\": \"Test\"", keys + "\"name\": \"\""), "p.json");
    ASSERT_TRUE(document);
    ASSERT_EQ(document->warnings().size(), 51U);
    EXPECT_EQ(document->warnings().back(), "p.json: 10 more unknown keys");
}
