// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/decarange_log.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::recording;

namespace {

const std::string header("T:090531087:DecaRangeRTLS:LogFile:\x01z\x02?m\x01\x00?\x01:Conf:Tag0:1:Chan2", 54);

DecaRangeLog readGood(std::string_view text)
{
    auto log = readDecaRangeLog(text);
    EXPECT_TRUE(log.has_value()) << (log ? "" : log.error().detail);
    return log.value_or(DecaRangeLog{});
}

std::vector<double> timesOf(const DecaRangeLog& log)
{
    std::vector<double> times;
    for (const RangeMeasurement& range : log.table.ranges)
        times.push_back(range.time_s);
    return times;
}

/// One exchange of two rows.
std::string exchange(std::string_view time, int sequence)
{
    const std::string end = ":" + std::to_string(sequence) + ":" + std::to_string(1000 + sequence) + "\r\n";
    return "T:" + std::string(time) + ":RR:0:0:760:760" + end + "T:" + std::string(time) +
           ":RR:0:1:4550:4550" + end;
}

} // namespace

TEST(DecaRangeLog, readsRangesBehindABinaryFirstLine)
{
    const DecaRangeLog log = readGood(header + "\r\nT:090531088:RR:2:3:760:810:229:3301\r\n");
    ASSERT_EQ(log.table.ranges.size(), 1U);
    const RangeMeasurement& range = log.table.ranges[0];
    EXPECT_DOUBLE_EQ(range.time_s, 9 * 3600 + 5 * 60 + 31.088);
    EXPECT_DOUBLE_EQ(range.range_m, 0.760) << "without the correction of the program";
    EXPECT_EQ(range.tag, 2);
    EXPECT_EQ(range.anchor, 3);
    EXPECT_EQ(range.sequence, 229);
    EXPECT_EQ(range.kind, RangeKind::TagAnchor);
    EXPECT_EQ(range.reportPeriod_s, 0.0);
    EXPECT_EQ(log.table.extra(0, *log.table.extraColumn("nranges")), "3301");
    EXPECT_EQ(log.table.extra(0, *log.table.extraColumn("corrected_m")), "0.81");
    EXPECT_TRUE(log.table.problems.empty());
}

TEST(DecaRangeLog, readsARecordThatFollowsOnTheFirstLine)
{
    EXPECT_EQ(readGood(header + exchange("090531088", 1)).table.ranges.size(), 2U);
}

TEST(DecaRangeLog, survivesLineEndsInTheBinaryVersion)
{
    for (const char byte : {'\r', '\n', '\0', ':', 'T'}) {
        std::string text = header + "\r\n" + exchange("090531088", 1);
        text[36] = byte;
        text[37] = byte;
        const DecaRangeLog log = readGood(text);
        EXPECT_EQ(log.table.ranges.size(), 2U) << static_cast<int>(byte);
        EXPECT_TRUE(log.table.problems.empty());
    }
}

TEST(DecaRangeLog, givesAllRowsOfAnExchangeTheMedianOfTheirTimes)
{
    const DecaRangeLog log =
        readGood("T:090531711:RR:0:0:780:780:232:3304\r\nT:090531712:RR:0:1:4550:4550:232:3304\r\n"
                 "T:230000000:RR:0:2:4550:4550:232:3304\r\nT:090531712:RR:0:3:6300:6300:232:3304\r\n");
    EXPECT_EQ(timesOf(log), std::vector<double>(4, 9 * 3600 + 5 * 60 + 31.712));
}

TEST(DecaRangeLog, keepsTheExchangesOfTagsApartThatAreWrittenInTurns)
{
    const DecaRangeLog log = readGood("T:090000000:RR:0:0:780:780:5:10\nT:090000050:RR:1:0:880:880:5:10\n"
                                      "T:090000001:RR:0:1:781:781:5:10\nT:090000051:RR:1:1:881:881:5:10\n");
    const std::vector<double> times = timesOf(log);
    EXPECT_EQ(times[0], times[2]);
    EXPECT_EQ(times[1], times[3]);
    EXPECT_NE(times[0], times[1]);
}

TEST(DecaRangeLog, takesTheTimeBeforeForAnImpossibleOne)
{
    const DecaRangeLog log = readGood(exchange("090000000", 1) + exchange("250000000", 2) +
                                      exchange("0900", 3) + exchange("090000600", 4));
    EXPECT_EQ(timesOf(log),
              (std::vector<double>{32400, 32400, 32400, 32400, 32400, 32400, 32400.6, 32400.6}));
    EXPECT_EQ(log.stepsBack, 0U);
}

TEST(DecaRangeLog, goesOnBehindMidnight)
{
    const DecaRangeLog log = readGood(exchange("235959900", 1) + exchange("000000100", 2));
    EXPECT_NEAR(timesOf(log)[2] - timesOf(log)[0], 0.2, 1e-9);
    EXPECT_EQ(log.stepsBack, 0U);
}

TEST(DecaRangeLog, comesBackFromOneWrongTime)
{
    const DecaRangeLog log =
        readGood(exchange("090000000", 1) + exchange("233000000", 2) + exchange("090000400", 3));
    EXPECT_NEAR(timesOf(log)[4] - timesOf(log)[0], 0.4, 1e-9);
}

TEST(DecaRangeLog, countsWhereRecordingsWereJoined)
{
    const DecaRangeLog log = readGood(exchange("114316510", 148) + exchange("114213768", 102));
    EXPECT_EQ(log.stepsBack, 1U);
    EXPECT_LT(timesOf(log)[2], timesOf(log)[0]) << "the times of the file are kept";
}

TEST(DecaRangeLog, keepsGrossRangesAndLeavesOutThoseThatAreNone)
{
    const DecaRangeLog log = readGood("T:090000000:RR:0:0:9800000:1:5:10\nT:090000000:RR:0:1:0:0:5:10\n"
                                      "T:090000000:RR:0:2:-1:-1:5:10\n");
    ASSERT_EQ(log.table.ranges.size(), 1U);
    EXPECT_DOUBLE_EQ(log.table.ranges[0].range_m, 9800.0);
    EXPECT_EQ(log.table.notMeasured, 2U);
}

TEST(DecaRangeLog, readsAnchorRangesAnchorsAndThePositionsOfTheProgram)
{
    const DecaRangeLog log =
        readGood("T:090000000:AP:1:5.5:0:1.7\nT:090000000:AP:0:0:0:1.3\nT:090000001:AP:1:5:0:1.7\n"
                 "T:090000100:RA:0:1:5010:0:7:20\nT:090000200:LE:3:1:229:[1.5,-2,0.25]:1:2:3:4\n"
                 "T:090000300:NL:3:1:230:[nan,nan,nan]:1:2:3:4\nT:090000300:RM:3:15:230:3302\n"
                 "T:090000300:TS:whatever\n");
    ASSERT_EQ(log.anchors.size(), 2U);
    EXPECT_EQ(log.anchors[1], (UwbAnchor{1, "A1", 5.0, 0.0, 1.7, true})) << "the last one counts";
    ASSERT_EQ(log.table.ranges.size(), 1U);
    EXPECT_EQ(log.table.ranges[0].kind, RangeKind::AnchorAnchor);
    EXPECT_EQ(log.table.ranges[0].tag, 0);
    EXPECT_EQ(log.table.ranges[0].anchor, 1);
    ASSERT_EQ(log.fixes.size(), 1U);
    EXPECT_EQ(log.fixes[0], (LoggedFix{32400.2, 3, 229, {1.5, -2.0, 0.25}}));
    EXPECT_EQ(log.otherRecords, 3U);
    EXPECT_TRUE(log.table.problems.empty());
}

TEST(DecaRangeLog, namesTheLineOfABrokenRecordAndGoesOn)
{
    const DecaRangeLog log = readGood(header + "\nT:090000000:RR:0:0:780\nT:090000000:RR:0:0:x:780:5:10\n"
                                               "T:090000000:AP:0:here\nT:090000000:LE:0:1:2:[1,2]\n"
                                               "T:090000000:RR:0:0:780:780:5:10T:0900");
    EXPECT_EQ(log.table.ranges.size(), 0U);
    ASSERT_EQ(log.table.problems.count(), 5U);
    EXPECT_EQ(log.table.problems.kept()[0].line, 2);
    EXPECT_EQ(log.table.problems.kept()[4].line, 6);
}

TEST(DecaRangeLog, refusesTextWithoutARecord)
{
    EXPECT_FALSE(readDecaRangeLog("").has_value());
    EXPECT_FALSE(readDecaRangeLog("t_s,tag,anchor,range_m\n").has_value());
    EXPECT_FALSE(looksLikeDecaRangeLog("mc 0f 00000663"));
    EXPECT_TRUE(looksLikeDecaRangeLog(header));
    EXPECT_TRUE(looksLikeDecaRangeLog(exchange("090000000", 1)));
}
