// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/json_turns.h"

#include "recording/recording_support.h"

namespace agv::recording {
namespace {

using test::largeField;
using test::NumbersAndRssi;
using test::parsed;
using test::readsOf;

TEST(JsonTurns, useTheRowsAndIgnoreTheTruth)
{
    const auto options = largeField();
    const TurnFile file = parsed(
        R"({"i": 0, "x": 1.0, "step": 12.0, "heading": 3, "rows": [[[81, 0], [82, 7]], [], [[83, 4]]]})",
        options);
    EXPECT_EQ(file.format, TurnFileFormat::JsonLines);
    ASSERT_EQ(file.turns.size(), 1U);
    ASSERT_TRUE(file.turns[0].record.has_value());
    const TurnRecord& record = *file.turns[0].record;
    ASSERT_EQ(record.stops.size(), 3U);
    EXPECT_EQ(readsOf(record.stops[0], options), (NumbersAndRssi{{81, 0}, {82, 7}}));
    EXPECT_TRUE(record.stops[1].reads.empty());
    EXPECT_DOUBLE_EQ(record.nominalStep, radFromDeg(45.0));
    EXPECT_EQ(record.turnTime_s, 1.125);
    EXPECT_FALSE(record.rotation.has_value());
}

TEST(JsonTurns, takeTheOptionalParameters)
{
    const TurnFile file =
        parsed(R"({"rows": [[["E004000000000001", 3, 31.5]]], "step_deg": 30, "turn_time_ms": 900.5,)"
               R"( "rotation": "cw", "kind": "measured", "unknown": [[2, "E004000000000003"]]})",
               largeField());
    const TurnRecord& record = file.turns.at(0).record.value();
    EXPECT_DOUBLE_EQ(record.nominalStep, radFromDeg(30.0));
    EXPECT_DOUBLE_EQ(*record.turnTime_s, 0.9005);
    EXPECT_EQ(record.rotation, Rotation::Clockwise);
    EXPECT_EQ(record.kind, TurnKind::Measured);
    EXPECT_EQ(record.stops[0].unknownIfUnseen,
              (std::vector{TagUid{0xE004000000000002}, TagUid{0xE004000000000003}}));
    EXPECT_EQ(record.stops[0].reads[0].time, Time{} + std::chrono::microseconds(31500));
    EXPECT_FALSE(parsed(R"({"rows": [[[1, 0]]], "turn_time_ms": null})", largeField())
                     .turns[0]
                     .record->turnTime_s.has_value());
}

TEST(JsonTurns, aBadLineNamesItsNumberAndReasonAndStopsNoOther)
{
    const TurnFile file =
        parsed("{\"rows\": [[[1, 0]]]}\n\n{\"rows\": [[[1, 9]]]}\n{\"rows\": [[[2, 1]]]}\n", largeField());
    ASSERT_EQ(file.turns.size(), 3U);
    EXPECT_TRUE(file.turns[0].record.has_value());
    ASSERT_FALSE(file.turns[1].record.has_value());
    EXPECT_EQ(file.turns[1].record.error().line, 3);
    EXPECT_NE(file.turns[1].record.error().reason.find("RSSI"), std::string::npos);
    EXPECT_TRUE(file.turns[2].record.has_value());
    EXPECT_EQ(file.turns[2].line, 4);
}

TEST(JsonTurns, refuseEveryOtherShape)
{
    const std::string deep(200'000, '[');
    const std::vector<std::string> bad{
        "{",
        "{}",
        R"({"rows": []})",
        R"({"rows": 3})",
        R"({"rows": [3]})",
        R"({"rows": [[3]]})",
        R"({"rows": [[[1]]]})",
        R"({"rows": [[[1, 0, 0, 0]]]})",
        R"({"rows": [[[0, 0]]]})",
        R"({"rows": [[[1.5, 0]]]})",
        R"({"rows": [[["xyz", 0]]]})",
        R"({"rows": [[[{"a": [1]}, 0]]]})",
        R"({"rows": [[[99999999999, 0]]]})",
        R"({"rows": [[[1, -1]]]})",
        R"({"rows": [[[1, 8]]]})",
        R"({"rows": [[[1, "0"]]]})",
        R"({"rows": [[[1, 0, "x"]]]})",
        R"({"rows": [[[1, 0, 1e300]]]})",
        R"({"rows": [[[1, 1e999]]]})",
        R"({"rows": [[[1, 0]]], "step_deg": 0})",
        R"({"rows": [[[1, 0]]], "step_deg": "45"})",
        R"({"rows": [[[1, 0]]], "step_deg": 181})",
        R"({"rows": [[[1, 0]]], "turn_time_ms": -1})",
        R"({"rows": [[[1, 0]]], "rotation": "left"})",
        R"({"rows": [[[1, 0]]], "rotation": 1})",
        R"({"rows": [[[1, 0]]], "kind": "fast"})",
        R"({"rows": [[[1, 0]]], "unknown": [[1], [2]]})",
        R"({"rows": [[[1, 0]]], "unknown": [1]})",
        "{\"rows\": [[" + deep,
        "{\"rows\": [[[" + deep + std::string(deep.size(), ']') + ", 0]]]}",
    };
    for (const std::string& text : bad) {
        const TurnFile file = parsed(text, largeField());
        ASSERT_EQ(file.turns.size(), 1U) << text;
        EXPECT_FALSE(file.turns[0].record.has_value()) << text;
    }
}

TEST(JsonTurns, aWrittenTurnReadsBackTheSame)
{
    const auto options = largeField();
    TurnRecord record;
    record.nominalStep = radFromDeg(22.5);
    record.rotation = Rotation::Clockwise;
    record.turnTime_s = 1.25;
    record.stops.resize(2);
    record.stops[0].reads = {{Time{} + std::chrono::seconds(5), TagUid{0xE004000000000007}, 3},
                             {Time{} + std::chrono::milliseconds(5031), TagUid{0xE004000000000008}, 0}};
    record.stops[1].unknownIfUnseen = {TagUid{0xE004000000000009}};
    const TurnRecord back = parsed(toJsonLine(record), options).turns.at(0).record.value();
    EXPECT_DOUBLE_EQ(back.nominalStep, record.nominalStep);
    EXPECT_EQ(back.rotation, record.rotation);
    EXPECT_DOUBLE_EQ(*back.turnTime_s, 1.25);
    ASSERT_EQ(back.stops.size(), 2U);
    EXPECT_EQ(back.stops[0].reads[1].uid, record.stops[0].reads[1].uid);
    EXPECT_EQ(back.stops[0].reads[1].time, Time{} + std::chrono::milliseconds(31));
    EXPECT_EQ(back.stops[1].unknownIfUnseen, record.stops[1].unknownIfUnseen);
}

TEST(JsonTurns, aWrittenTurnReadsBackWhateverTheOrderOfItsReads)
{
    const auto turn = parsed(R"({"rows": [[[1, 3, 4000], [2, 1, 250]], [[3, 0]]]})", largeField());
    const TurnRecord record = turn.turns.at(0).record.value();
    const auto back = parsed(toJsonLine(record), largeField()).turns.at(0).record;
    ASSERT_TRUE(back.has_value()) << back.error().reason;
    EXPECT_EQ(back->stops[0].reads[0].time, Time{} + std::chrono::milliseconds(4000));
    EXPECT_EQ(back->stops[0].reads[1].time, Time{} + std::chrono::milliseconds(250));
    EXPECT_EQ(back->stops[1].reads[0].time, Time{});
}

} // namespace
} // namespace agv::recording
