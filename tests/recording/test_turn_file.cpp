// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/turn_file.h"

#include "recording/recording_support.h"

namespace agv::recording {
namespace {

using test::largeField;
using test::parsed;
using test::smallField;

TEST(TurnFile, formatIsToldFromTheContentEvenWhenLinesAreBad)
{
    EXPECT_EQ(parsed("garbage\n{\"rows\": [[[1, 0]]]}\n", largeField()).format, TurnFileFormat::JsonLines);
    EXPECT_EQ(parsed("0 5 0\n45 5 0\n45 ???\n", largeField()).format, TurnFileFormat::Emulator);
    EXPECT_EQ(parsed("0 SCAN:+UID=5+RSSI=0<\\r>\n", largeField()).format, TurnFileFormat::Emulator);
    EXPECT_EQ(parsed("ID,ST\n5,0\n", largeField()).format, TurnFileFormat::Table);
    EXPECT_EQ(parsed("OK\n# stop 1\nSCAN:+UID=E00401503A5BDAE4,+RSSI=3/2\n", smallField()).format,
              TurnFileFormat::Capture);
}

TEST(TurnFile, withoutTurnsIsRefusedWithWhatWasExpected)
{
    for (const char* text :
         {"", "\n\n", "hello world\n", "\x01\x02\x03", "SCAN:+UID=E00401503A5BDAE4,+RSSI=3/2\n"}) {
        const auto file = parseTurns(text, largeField());
        ASSERT_FALSE(file.has_value()) << text;
        EXPECT_EQ(file.error().code, ErrorCode::BadInput);
        EXPECT_NE(file.error().detail.find("expected"), std::string::npos);
    }
}

TEST(TurnFile, ofBytesThatAreNoTextIsRefusedWholeUnlessItIsACapture)
{
    using namespace std::string_literals;
    EXPECT_FALSE(parseTurns("{\"rows\": [[[1, 0]]]}\n{\0\x1f"s, largeField()).has_value());
    const auto capture =
        parseTurns("# stop 1\nSC\0AN\nSCAN:+UID=E004000000000001,+RSSI=3/2\n"s, largeField());
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->turns.at(0).record->stops.at(0).reads.size(), 1U);
}

TEST(TurnFile, ofAnotherPlantIsRefusedButSingleForeignTagsAreNot)
{
    const TurnFile wrong = parsed("{\"rows\": [[[40, 0], [41, 1], [1, 1]]]}", smallField());
    ASSERT_FALSE(wrong.turns.at(0).record.has_value());
    EXPECT_NE(wrong.turns[0].record.error().reason.find("2 of 3 reads"), std::string::npos)
        << wrong.turns[0].record.error().reason;
    EXPECT_TRUE(
        parsed("{\"rows\": [[[40, 0], [2, 1], [1, 1]]]}", smallField()).turns.at(0).record.has_value());
    const TurnFile capture = parsed("# stop 1\nSCAN:+UID=E004000000000005,+RSSI=3/2\n", smallField());
    ASSERT_FALSE(capture.turns.at(0).record.has_value());
    EXPECT_NE(capture.turns[0].record.error().reason.find("E004000000000005"), std::string::npos);
}

TEST(TurnFile, thatIsEmptyIsCalledSo)
{
    for (const char* text : {"", "\n", " \r\n\n"}) {
        const auto file = parseTurns(text, smallField());
        ASSERT_FALSE(file.has_value());
        EXPECT_TRUE(file.error().detail.starts_with("holds no turns, it is empty; expected")) << text;
    }
}

TEST(TurnFile, thatCannotBeReadNamesThePath)
{
    const auto missing = readTurnFile("no/such/file.jsonl", largeField());
    ASSERT_FALSE(missing.has_value());
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
    EXPECT_NE(missing.error().detail.find("no/such/file.jsonl"), std::string::npos);
    const auto folder = readTurnFile(AGV_TEST_DATA, largeField());
    ASSERT_FALSE(folder.has_value());
    EXPECT_EQ(folder.error().code, ErrorCode::BadInput);
    const auto script = readTurnFile(AGV_SOURCE_DIR "/LICENSE", largeField());
    ASSERT_FALSE(script.has_value());
    EXPECT_NE(script.error().detail.find("LICENSE: holds no turns"), std::string::npos)
        << script.error().detail;
}

} // namespace
} // namespace agv::recording
