// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/capture_turns.h"
#include "recording/capture_writer.h"
#include "recording/recording_support.h"

namespace agv::recording {
namespace {

using namespace std::chrono_literals;
using test::dataFile;
using test::NumbersAndRssi;
using test::parsed;
using test::readsOf;
using test::smallField;

TEST(CaptureTurns, readTheMarksTheTimesAndTheReads)
{
    const auto options = smallField();
    const TurnFile file = dataFile("capture_small_field.txt", options);
    EXPECT_EQ(file.format, TurnFileFormat::Capture);
    ASSERT_EQ(file.turns.size(), 1U);
    const TurnRecord& record = file.turns[0].record.value();
    EXPECT_EQ(record.stops.size(), 9U);
    EXPECT_EQ(record.rotation, Rotation::Clockwise);
    EXPECT_EQ(record.kind, TurnKind::Timed);
    EXPECT_EQ(record.turnTime_s, 1.125);
    EXPECT_EQ(record.stops[0].reads.front().time, Time{} + 231250us);
    for (const TurnStop& stop : record.stops) {
        EXPECT_EQ(stop.reads.size() % 3, 0U);
        EXPECT_GE(stop.reads.size(), 9U);
        EXPECT_EQ(stop.movingReads.size(), 1U);
    }
}

TEST(CaptureTurns, handMadeFilesNeedStopMarksOnly)
{
    const auto options = smallField();
    const TurnFile file = parsed("SCAN:+UID=E00401503A5BDAE4,+RSSI=1/1\n"
                                 "# stop\r\nSCAN:+UID=E00401503A5BDAE4,+RSSI=3/2<\\r>\r\n"
                                 "# stop 3\nSCAN:+UID=E00401503A5BD586+RSSI=4/2\nOK\nnoise\n"
                                 "# stop 1\nSCAN:+UID=E00401503A5BDBF4,+RSSI=5/2\n",
                                 options);
    ASSERT_EQ(file.turns.size(), 2U);
    const TurnRecord& first = file.turns[0].record.value();
    ASSERT_EQ(first.stops.size(), 3U);
    EXPECT_EQ(readsOf(first.stops[0], options), (NumbersAndRssi{{1, 3}}));
    EXPECT_TRUE(first.stops[1].reads.empty());
    EXPECT_EQ(readsOf(first.stops[2], options), (NumbersAndRssi{{2, 4}}));
    EXPECT_NEAR(first.nominalStep, radFromDeg(45.0), 1e-12);
    EXPECT_EQ(readsOf(file.turns[1].record->stops[0], options), (NumbersAndRssi{{3, 5}}));
}

TEST(CaptureTurns, aRetakeReplacesTheReadsOfItsStop)
{
    const auto options = smallField();
    const TurnFile file = parsed("# stop 1\nSCAN:+UID=E00401503A5BDAE4,+RSSI=3/2\n"
                                 "# stop 2\nSCAN:+UID=E00401503A5BDAE4,+RSSI=4/2\n"
                                 "# retake 1\nSCAN:+UID=E00401503A5BD586,+RSSI=5/2\n"
                                 "# stop 3\n# end\n",
                                 options);
    const TurnRecord& record = file.turns.at(0).record.value();
    ASSERT_EQ(record.stops.size(), 3U);
    EXPECT_EQ(readsOf(record.stops[0], options), (NumbersAndRssi{{2, 5}}));
    EXPECT_EQ(readsOf(record.stops[1], options), (NumbersAndRssi{{1, 4}}));
}

TEST(CaptureTurns, badMarksAndAbortedTurnsNameTheirLine)
{
    for (const char* bad : {"# stop 0", "# stop -1", "# stop x", "# stop 9999", "# retake 2", "# aborted"}) {
        const TurnFile file =
            parsed(std::string("# turn\n# stop 1\n") + bad + "\n# turn\n# stop 1\n", smallField());
        ASSERT_EQ(file.turns.size(), 2U) << bad;
        ASSERT_FALSE(file.turns[0].record.has_value()) << bad;
        EXPECT_EQ(file.turns[0].record.error().line, 3) << bad;
        EXPECT_TRUE(file.turns[1].record.has_value()) << bad;
    }
    for (const char* bad : {"step_deg=0", "step_deg=x", "turn_time_ms=-1", "rotation=left", "kind=other"}) {
        const TurnFile file = parsed(std::string("# turn ") + bad + "\n# stop 1\n", smallField());
        EXPECT_FALSE(file.turns.at(0).record.has_value()) << bad;
    }
    EXPECT_TRUE(parsed("# turn later=1\n# stop 1\n", smallField()).turns.at(0).record.has_value());
    EXPECT_FALSE(parsed("# turn\n# end\n", smallField()).turns.at(0).record.has_value());
}

TEST(CaptureTurns, needADecoder)
{
    TurnFileOptions options = smallField();
    options.decodeReaderLine = nullptr;
    EXPECT_FALSE(parseTurns("# stop 1\n", options).has_value());
}

/// Feeds the same capture in pieces of every size.
std::string captured(std::size_t pieceSize)
{
    std::string text;
    const Time begin = Time{} + 10s;
    CaptureWriter writer([&](std::string_view line) { text += line; }, begin);
    TurnParameters parameters;
    parameters.rotation = Rotation::Clockwise;
    parameters.stopsPerTurn = 16;
    writer.turn(parameters, begin);
    writer.stop(1, begin + 200ms);
    const std::string_view bytes = "SCAN:+UID=E00401503A5BDAE4,+RSSI=3/2\r\n# stop 7\r\xFF\x01@5 x\n";
    for (std::size_t at = 0; at < bytes.size(); at += pieceSize)
        writer.bytes(bytes.substr(at, pieceSize), begin + 212500us);
    writer.moving(begin + 1500ms);
    writer.stop(2, begin + 2700ms);
    writer.end(begin + 30s);
    return text;
}

TEST(CaptureWriter, writesWhatTheReaderOfCapturesReads)
{
    const auto options = smallField();
    const TurnRecord record = parsed(captured(1000), options).turns.at(0).record.value();
    EXPECT_NEAR(record.nominalStep, radFromDeg(22.5), 1e-12);
    EXPECT_EQ(record.rotation, Rotation::Clockwise);
    EXPECT_EQ(record.turnTime_s, 1.125);
    ASSERT_EQ(record.stops.size(), 2U) << "a line of the reader must never pass for a mark";
    EXPECT_EQ(readsOf(record.stops[0], options), (NumbersAndRssi{{1, 3}}));
    EXPECT_EQ(record.stops[0].reads[0].time, Time{} + 212500us);
}

TEST(CaptureWriter, doesNotDependOnHowTheBytesAreCut)
{
    const std::string whole = captured(1000);
    EXPECT_NE(whole.find("\\xFF\\x01@5 x"), std::string::npos);
    for (std::size_t size = 1; size < 70; ++size)
        EXPECT_EQ(captured(size), whole) << size;
}

TEST(CaptureWriter, cutsEndlessLines)
{
    std::string text;
    CaptureWriter writer([&](std::string_view line) { text += line; }, Time{});
    writer.bytes(std::string(2000, 'x'), Time{});
    EXPECT_GE(std::ranges::count(text, '\n'), 4);
}

} // namespace
} // namespace agv::recording
