// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/table_turns.h"

#include "recording/recording_support.h"

namespace agv::recording {
namespace {

using test::NumbersAndRssi;
using test::parsed;
using test::readsOf;
using test::smallField;

std::vector<int> unknownNumbers(const TurnStop& stop, const TurnFileOptions& options)
{
    std::vector<int> numbers;
    for (const FloorTag& tag : options.tags) {
        if (std::ranges::find(stop.unknownIfUnseen, tag.uid) != stop.unknownIfUnseen.end())
            numbers.push_back(tag.number);
    }
    return numbers;
}

TEST(TableTurns, readTheRecordedTableOfTheSeed)
{
    const auto options = smallField();
    const TurnFile file = test::dataFile("table10.csv", options);
    EXPECT_EQ(file.format, TurnFileFormat::Table);
    ASSERT_EQ(file.turns.size(), 1U);
    const TurnRecord& record = file.turns[0].record.value();
    ASSERT_EQ(record.stops.size(), 8U);
    EXPECT_EQ(readsOf(record.stops[0], options), (NumbersAndRssi{{4, 0}, {1, 0}, {5, 1}, {2, 7}, {3, 0}}));
    EXPECT_EQ(readsOf(record.stops[1], options), (NumbersAndRssi{{5, 2}, {3, 3}}));
    EXPECT_EQ(readsOf(record.stops[4], options),
              (NumbersAndRssi{{9, 2}, {7, 0}, {8, 6}, {6, 0}, {4, 0}, {5, 2}}));
}

TEST(TableTurns, tagsThatTheOldProgramCouldNotRecordAreUnknownNotMissed)
{
    const auto options = smallField();
    const TurnFile file = test::dataFile("table10.csv", options);
    const std::vector<std::vector<int>> expected{{}, {2}, {2}, {1}, {2}, {}, {2}, {}};
    for (std::size_t stop = 0; stop < expected.size(); ++stop)
        EXPECT_EQ(unknownNumbers(file.turns[0].record->stops[stop], options), expected[stop]) << stop;
}

TEST(TableTurns, otherWidthsHaveNoDefectOfTheOldProgram)
{
    const TurnFile file = parsed("4;5;2;3\n", smallField());
    EXPECT_TRUE(file.turns.at(0).record->stops[0].unknownIfUnseen.empty());
}

TEST(TableTurns, takeAnySeparatorQuotesTitlesAndUids)
{
    const auto options = smallField();
    for (const std::string text :
         {"4,1,2,7\n", "4;1;2;7\r\n", "4\t1\t2\t7\n", " \"4\" , \"1\" ,2,7", "ID 1,ID 2,ST 1,ST 2\n4,1,2,7",
          "# note, with comma\n4,1,2,7", "E00401503A5BD689,E00401503A5BDAE4,2,7"}) {
        const TurnFile file = parsed(text, options);
        ASSERT_EQ(file.turns.size(), 1U) << text;
        ASSERT_TRUE(file.turns[0].record.has_value()) << text << file.turns[0].record.error().reason;
        ASSERT_EQ(file.turns[0].record->stops.size(), 1U) << text;
        EXPECT_EQ(readsOf(file.turns[0].record->stops[0], options), (NumbersAndRssi{{4, 2}, {1, 7}})) << text;
    }
}

TEST(TableTurns, anEmptyLinePartsTwoTurnsAndEmptyCellsAreAStopWithoutReads)
{
    const auto options = smallField();
    const TurnFile file = parsed("4,1,2,7\n,,,\n4,,2,\n\n\n5,,1,\n", options);
    ASSERT_EQ(file.turns.size(), 2U);
    ASSERT_EQ(file.turns[0].record->stops.size(), 3U);
    EXPECT_TRUE(file.turns[0].record->stops[1].reads.empty());
    EXPECT_EQ(file.turns[1].line, 6);
    EXPECT_EQ(readsOf(file.turns[1].record->stops[0], options), (NumbersAndRssi{{5, 1}}));
}

TEST(TableTurns, aBadCellNamesLineAndColumnAndStopsOnlyItsTurn)
{
    const std::vector<std::pair<std::string, std::string>> bad{
        {"4,1,2,8", "column 4"},          {"4,1,2,", "column 4"}, {"4,x,2,7", "column 2"},
        {"0,1,2,7", "column 1"},          {",1,2,7", "column 1"}, {"4,1,2,7,1", "5 in all"},
        {"4,1,2,2,7,7", "the row has 6"},
    };
    for (const auto& [row, reason] : bad) {
        const TurnFile file = parsed("4,1,2,7\n" + row + "\n\n5,4,1,1\n", smallField());
        ASSERT_EQ(file.turns.size(), 2U) << row;
        ASSERT_FALSE(file.turns[0].record.has_value()) << row;
        EXPECT_EQ(file.turns[0].record.error().line, 2) << row;
        EXPECT_NE(file.turns[0].record.error().reason.find(reason), std::string::npos)
            << file.turns[0].record.error().reason;
        EXPECT_TRUE(file.turns[1].record.has_value()) << row;
    }
}

TEST(TableTurns, aWrittenTableHasTheSeedsColumnsAndIsReadAgain)
{
    const auto options = smallField();
    const auto uid = [&](std::size_t number) { return options.tags[number - 1].uid; };
    const std::vector<StopRow> rows{{1, {{uid(2), 5}, {uid(1), 0}}, 9, true}, {2, {}, 0, true}};
    const std::string text = tableText(rows);
    EXPECT_EQ(text, "E00401503A5BD586,E00401503A5BDAE4,,,,,,5,0,,,,,\r\n,,,,,,,,,,,,,\r\n");
    const TurnFile file = parsed(text, options);
    ASSERT_EQ(file.turns.at(0).record->stops.size(), 2U);
    EXPECT_EQ(readsOf(file.turns[0].record->stops[0], options), (NumbersAndRssi{{2, 5}, {1, 0}}));
    // Only the old program lost tags, and it wrote numbers.
    EXPECT_TRUE(file.turns[0].record->stops[0].unknownIfUnseen.empty());
}

TEST(TableTurns, aWrittenTableIsWidenedForAStopWithMoreTags)
{
    const auto options = smallField();
    StopRow row{1, {}, 9, true};
    for (std::size_t k = 0; k < 9; ++k)
        row.tags.emplace_back(options.tags[k].uid, static_cast<int>(k % 8));
    const TurnFile file = parsed(tableText(std::vector{row, StopRow{2, {}, 0, true}}), options);
    ASSERT_EQ(file.turns.at(0).record->stops.size(), 2U);
    EXPECT_EQ(file.turns[0].record->stops[0].reads.size(), 9U);
}

} // namespace
} // namespace agv::recording
