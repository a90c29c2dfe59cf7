// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/range_table.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::recording;

namespace {

RangeTable readTable(std::string_view text)
{
    auto table = readRangeCsv(text);
    EXPECT_TRUE(table.has_value()) << (table ? "" : table.error().detail);
    return table.value_or(RangeTable{});
}

std::string tableError(std::string_view text)
{
    const auto table = readRangeCsv(text);
    EXPECT_FALSE(table.has_value());
    return table ? std::string() : table.error().detail;
}

} // namespace

TEST(RangeCsv, readsTimesIdsAndRanges)
{
    const RangeTable table = readTable("t_s,tag,anchor,range_m\n0.1279,0,105,2.9552\n-1.5,3,7,1e1\n");
    ASSERT_EQ(table.ranges.size(), 2U);
    EXPECT_EQ(table.ranges[0],
              (RangeMeasurement{.time_s = 0.1279, .range_m = 2.9552, .tag = 0, .anchor = 105}));
    EXPECT_EQ(table.ranges[1], (RangeMeasurement{.time_s = -1.5, .range_m = 10.0, .tag = 3, .anchor = 7}));
    EXPECT_TRUE(table.problems.empty());
}

TEST(RangeCsv, carriesOtherColumnsThrough)
{
    const RangeTable table =
        readTable("point,t_s,tag,anchor,range_m,seq,nlos_label\n1,5,0,2,1.5,229,1\n7b,6,0,2,1.6,,0\n");
    EXPECT_EQ(table.extraColumns, (std::vector<std::string>{"point", "nlos_label"}));
    EXPECT_EQ(table.ranges[0].sequence, 229);
    EXPECT_EQ(table.ranges[1].sequence, -1);
    EXPECT_EQ(table.extra(1, *table.extraColumn("point")), "7b");
    EXPECT_EQ(table.extra(0, *table.extraColumn("nlos_label")), "1");
    EXPECT_EQ(table.extraColumn("run"), std::nullopt);
}

TEST(RangeCsv, readsWhatSpreadsheetsWrite)
{
    const RangeTable table = readTable("\xEF\xBB\xBFT_s;Tag;Anchor;Range_m;note\r\n0,5;1;2;3,25;\"a;b "
                                       "\"\"c\"\"\"\r\n\r\n# remark\r\n1,5;1;2;3,5;\r\n");
    ASSERT_EQ(table.ranges.size(), 2U);
    EXPECT_DOUBLE_EQ(table.ranges[0].time_s, 0.5);
    EXPECT_DOUBLE_EQ(table.ranges[0].range_m, 3.25);
    EXPECT_EQ(table.extra(0, 0), "a;b \"c\"");
}

TEST(RangeCsv, leavesOutRowsWithoutARangeAndCountsThem)
{
    const RangeTable table =
        readTable("t_s,tag,anchor,range_m\n0,0,0,\n0,0,1,nan\n0,0,2,0\n0,0,3,-1\n0,0,4,2.5\n");
    ASSERT_EQ(table.ranges.size(), 1U);
    EXPECT_EQ(table.notMeasured, 4U);
    EXPECT_TRUE(table.problems.empty());
}

TEST(RangeCsv, namesTheLineOfABadRowAndGoesOn)
{
    const RangeTable table = readTable(
        "t_s,tag,anchor,range_m\nx,0,0,1\n1,0,0,1\n1,-1,0,1\n1,0,A0,1\n1,0,0,far\n1,0\n2,0,0,9.8e3\n");
    EXPECT_EQ(table.ranges.size(), 2U) << "a gross outlier is kept";
    ASSERT_EQ(table.problems.count(), 5U);
    const auto& problems = table.problems.kept();
    EXPECT_EQ(problemText("r.csv", problems[0]), "r.csv:2: t_s: must be a number (is 'x')");
    EXPECT_EQ(problemText("r.csv", problems[1]), "r.csv:4: tag: must be a whole number from 0 (is '-1')");
    EXPECT_EQ(problemText("r.csv", problems[2]), "r.csv:5: anchor: must be a whole number from 0 (is 'A0')");
    EXPECT_EQ(problemText("r.csv", problems[3]), "r.csv:6: range_m: must be a number (is 'far')");
    EXPECT_EQ(problemText("r.csv", problems[4]), "r.csv:7: has 2 fields, the header has 4");
}

TEST(RangeCsv, keepsTheFirstHundredProblemsAndCountsAll)
{
    std::string text = "t_s,tag,anchor,range_m\n1,0,0,1\n";
    for (int i = 0; i < 5000; ++i)
        text += "bad\n";
    const RangeTable table = readTable(text);
    EXPECT_EQ(table.problems.count(), 5000U);
    EXPECT_EQ(table.problems.kept().size(), 100U);
}

TEST(RangeCsv, refusesTextWithoutItsColumnsOrAnyGoodRow)
{
    EXPECT_EQ(tableError(""), "is empty; expected a header and rows");
    EXPECT_EQ(tableError("\n\nt_s,tag,range_m\n1,0,1\n"),
              "3: the header has no column anchor; expected t_s,tag,anchor,range_m");
    EXPECT_EQ(tableError("t_s,tag,anchor,range_m\n1,0\n"), "2: has 2 fields, the header has 4");
    EXPECT_TRUE(readTable("t_s,tag,anchor,range_m\n").ranges.empty());
}

TEST(RangeCsv, isTheSameAfterWriting)
{
    RangeTable table;
    table.extraColumns = {"run", "note"};
    table.ranges = {
        {.time_s = 32731.088,
         .range_m = 0.1 + 0.2,
         .reportPeriod_s = 0.28,
         .tag = 1,
         .anchor = 2,
         .sequence = 255},
        {.time_s = 1.0 / 3.0, .range_m = 1e-3, .tag = 0, .anchor = 1, .kind = RangeKind::AnchorAnchor}};
    table.extras = {"a,b", "-1.5", "", "say \"x\""};
    const RangeTable again = readTable(writeRangeCsv(table));
    EXPECT_EQ(again.ranges, table.ranges);
    EXPECT_EQ(again.extraColumns, table.extraColumns);
    EXPECT_EQ(again.extras, table.extras);
}

TEST(RangeCsv, writesOnlyTheColumnsThatHaveSomething)
{
    RangeTable table;
    table.ranges = {{.time_s = 0.5, .range_m = 2.25, .tag = 3, .anchor = 1}};
    EXPECT_EQ(writeRangeCsv(table), "t_s,tag,anchor,range_m\n0.5,3,1,2.25\n");
}
