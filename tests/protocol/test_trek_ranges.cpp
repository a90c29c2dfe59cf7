// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_ranges.h"

#include "protocol/trek_samples.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::protocol;
using namespace std::chrono_literals;

namespace {

TrekReport reportOf(int tag, int sequence, Duration arrival)
{
    TrekReport report;
    report.range_mm = {1000, 2000, 0, 4000};
    report.mask = report.usable = 0x0B;
    report.tag = static_cast<std::int16_t>(tag);
    report.sequence = static_cast<std::int16_t>(sequence & 0xFF);
    report.firstByte = Time{} + arrival;
    return report;
}

RangeSet rangesOf(TrekRanges& ranges, std::string_view line)
{
    TrekStream stream;
    RangeSet set;
    stream.feed(std::string(line) + "\n", Time{} + 10s, [&](const TrekReport& r) { set = ranges.read(r); });
    return set;
}

} // namespace

TEST(TrekRanges, givesTheUsableRangesInMetresWithTheirAnchors)
{
    TrekRanges ranges;
    ranges.setReportPeriod(0.1);
    const RangeSet set = ranges.read(reportOf(7, 9, 5s));
    ASSERT_EQ(set.size(), 3U);
    EXPECT_EQ(set[0], (RangeMeasurement{4.9, 1.0, 0.1, 7, 0, 9, RangeKind::TagAnchor}));
    EXPECT_EQ(set[1], (RangeMeasurement{4.9, 2.0, 0.1, 7, 1, 9, RangeKind::TagAnchor}));
    EXPECT_EQ(set[2], (RangeMeasurement{4.9, 4.0, 0.1, 7, 3, 9, RangeKind::TagAnchor}));
}

TEST(TrekRanges, readsEveryDialect)
{
    TrekRanges ranges;
    EXPECT_EQ(rangesOf(ranges, samples::trek).size(), 4U);
    EXPECT_EQ(rangesOf(ranges, samples::trekRaw).size(), 0U) << "repeats its mc without correction";
    EXPECT_EQ(rangesOf(ranges, samples::ulmFour).size(), 3U);
    EXPECT_EQ(rangesOf(ranges, samples::ulmEight).size(), 6U);
    EXPECT_EQ(rangesOf(ranges, samples::esp32).size(), 3U);
    const RangeSet imu = rangesOf(ranges, samples::imuFour);
    ASSERT_EQ(imu.size(), 2U);
    EXPECT_EQ(imu[1].anchor, 2);
    EXPECT_DOUBLE_EQ(imu[1].range_m, 1.25);
    const RangeSet old = rangesOf(ranges, samples::trekOld);
    ASSERT_EQ(old.size(), 1U);
    EXPECT_EQ(old[0].anchor, 3);
    EXPECT_EQ(old[0].tag, 1);
}

TEST(TrekRanges, knowsThePairsOfAnchorAnchorRanges)
{
    TrekRanges ranges;
    ranges.setReportPeriod(0.1);
    const RangeSet set = rangesOf(ranges, samples::trekAnchors);
    ASSERT_EQ(set.size(), 3U);
    EXPECT_EQ(set[0], (RangeMeasurement{10.0, 1.753, 0.0, 0, 1, 0x51, RangeKind::AnchorAnchor}));
    EXPECT_EQ(set[1].tag, 0);
    EXPECT_EQ(set[1].anchor, 2);
    EXPECT_EQ(set[2].tag, 1);
    EXPECT_EQ(set[2].anchor, 2);
    EXPECT_TRUE(ranges.tags().empty()) << "tag 0 was not heard";
}

TEST(TrekRanges, countsTheGapsOfEachTagForItself)
{
    TrekRanges ranges;
    for (const int sequence : {254, 255, 0, 1, 4, 5})
        ranges.read(reportOf(0, sequence, 0s));
    for (const int sequence : {10, 20})
        ranges.read(reportOf(1, sequence, 0s));
    EXPECT_EQ(ranges.traffic(0).missed, 2U);
    EXPECT_EQ(ranges.traffic(0).reports, 6U);
    EXPECT_EQ(ranges.traffic(0).lastSequence, 5);
    EXPECT_EQ(ranges.traffic(1).missed, 9U);
    EXPECT_EQ(ranges.tags(), (std::vector<int>{0, 1}));
}

TEST(TrekRanges, countsRepeatedReportsAndRestartsOfATagAsWhatTheyAre)
{
    TrekRanges ranges;
    for (const int sequence : {50, 50, 51, 3, 4})
        ranges.read(reportOf(0, sequence, 0s));
    EXPECT_EQ(ranges.traffic(0).repeated, 1U);
    EXPECT_EQ(ranges.traffic(0).restarts, 1U);
    EXPECT_EQ(ranges.traffic(0).missed, 0U);
}

TEST(TrekRanges, doesNotCallTheLinesOfOneExchangeOfFirmware106Repeated)
{
    TrekRanges ranges;
    for (int anchor = 0; anchor < 4; ++anchor) {
        TrekReport report = reportOf(0, 8, 1s);
        report.kind = TrekLineKind::Single;
        report.rangeCount = 1;
        report.firstAnchor = static_cast<std::uint8_t>(anchor);
        ASSERT_EQ(ranges.read(report).size(), 1U);
    }
    EXPECT_EQ(ranges.traffic(0).repeated, 0U);
    EXPECT_EQ(ranges.traffic(0).missed, 0U);
}

TEST(TrekRanges, measuresThePeriodOfATagThroughLostReportsAndLateReads)
{
    TrekRanges ranges;
    const std::vector<std::pair<int, Duration>> heard{{0, 0ms},    {1, 280ms},  {2, 560ms},  {5, 1400ms},
                                                      {6, 1690ms}, {7, 1960ms}, {8, 2640ms}, {9, 2645ms}};
    for (const auto& [sequence, arrival] : heard)
        ranges.read(reportOf(0, sequence, arrival));
    EXPECT_NEAR(ranges.traffic(0).reportPeriod_s, 0.280, 0.001);
}

TEST(TrekRanges, takesNothingOffBeforeThePeriodIsKnownAndOnePeriodAfter)
{
    TrekRanges ranges;
    std::vector<RangeMeasurement> first;
    for (int i = 0; i < 6; ++i)
        first.push_back(ranges.read(reportOf(0, i, i * 100ms))[0]);
    EXPECT_EQ(first[2].reportPeriod_s, 0.0);
    EXPECT_DOUBLE_EQ(first[2].time_s, 0.2);
    EXPECT_NEAR(first[5].reportPeriod_s, 0.1, 1e-6);
    EXPECT_NEAR(first[5].time_s, 0.4, 1e-6);
    for (std::size_t i = 1; i < first.size(); ++i)
        EXPECT_GE(first[i].time_s, first[i - 1].time_s) << "time never falls";
}

TEST(TrekRanges, beginsANewSequenceAfterAReconnection)
{
    TrekRanges ranges;
    ranges.read(reportOf(0, 10, 0s));
    ranges.reset();
    ranges.read(reportOf(0, 90, 60s));
    EXPECT_EQ(ranges.traffic(0).missed, 0U);
    EXPECT_EQ(ranges.traffic(0).reports, 2U);
}

TEST(TrekRanges, takesTheClockOfTheUnitForCapturesWithoutTimes)
{
    TrekRanges ranges(TrekRanges::TimeBase::DeviceClock);
    TrekStream stream;
    std::vector<double> times;
    const std::string lines = samples::trekThree + "\n" +
                              "mc 07 000004de 00000901 000008a3 00000000 6cc6 0b 00a0648f a12:0\n"
                              "mc 07 000004c7 000008e9 0000089a 00000000 6ccc 0c 00a064f3 a12:0\n";
    stream.feed(lines, Time{}, [&](const TrekReport& r) { times.push_back(ranges.read(r)[0].time_s); });
    ASSERT_EQ(times.size(), 3U);
    EXPECT_NEAR(times[0], 0xa0642b / 1e3, 1e-9);
    EXPECT_NEAR(times[1] - times[0], 0.1, 1e-9);
    EXPECT_NEAR(times[2] - times[1], 0.1, 1e-9);
}
