// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_stream.h"

#include "core/random.h"
#include "protocol/trek_samples.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::protocol;
using namespace agv::protocol::samples;
using namespace std::chrono_literals;

namespace {

std::string lines(const std::vector<std::string>& texts, std::string_view end = "\r\n")
{
    std::string bytes;
    for (const std::string& text : texts)
        bytes += text + std::string(end);
    return bytes;
}

/// What each dialect's port looks like.
const std::vector<std::pair<std::string, std::string>> streams{
    {"trek", lines({trek, trekRaw, trekAnchors, trekThree, "T00012ab3 poll", "me 01 02", "boot v2.10"})},
    {"trek 1.06", lines({trekOld, "ma00 t01 00000651 000005e8 0004 02 00003a82 404f 404f a0", trekOld})},
    {"ulm1", lines({ulmFour, ulmText, ulmFour, ulmText})},
    {"ulm3", lines({ulmEight, ulmText, ulmEight, ulmText})},
    {"esp32", lines({esp32, esp32})},
    {"imu", lines({imuFour, imuEight, imuFour})},
    {"mixed ends", trek + "\r" + trekThree + "\n" + trek + "\r\n\r\n" + trek + "\n\r" + trek + "\r\n"},
    {"noise", "\xff\x00 x\r\n" + trek + "\r\nmc 0f 0000" + trek + "\r\n\x80\x81" + trek + "\xfe\r\n" + trek +
                  trekThree + "\r\n" + std::string(700, 'z') + "\r\n" + trek + "\r\n" +
                  std::string(600, '\xee') + trek + "\r\n"},
    {"no ends at all", trekOld + trekOld + trekOld + trekOld + trekOld + trekOld + trekOld + trekOld +
                           trekOld + trekOld + trekOld + trekOld},
};

std::uint64_t dropped(const TrekStream::Counts& counts, TrekDrop drop)
{
    return counts.dropped[static_cast<std::size_t>(drop)];
}

} // namespace

TEST(TrekStream, givesTheSameReportsAndCountsAtEverySplitPosition)
{
    for (const auto& [name, bytes] : streams) {
        const Heard whole = hear(bytes);
        for (std::size_t i = 0; i <= bytes.size(); ++i)
            ASSERT_EQ(hear(bytes, {i}), whole) << name << " cut at " << i;
    }
}

TEST(TrekStream, givesTheSameReportsAndCountsAtEveryPairOfSplitPositions)
{
    const std::string bytes = lines({trek, ulmEight, imuFour});
    const Heard whole = hear(bytes);
    ASSERT_EQ(whole.reports.size(), 3U);
    for (std::size_t i = 0; i <= bytes.size(); ++i)
        for (std::size_t j = i; j <= bytes.size(); ++j)
            ASSERT_EQ(hear(bytes, {i, j}), whole) << "cut at " << i << " and " << j;
}

TEST(TrekStream, givesTheSameReportsAndCountsInBurstsOfEverySize)
{
    for (const auto& [name, bytes] : streams) {
        const Heard whole = hear(bytes);
        for (std::size_t size = 1; size <= 130; ++size)
            ASSERT_EQ(hearInBursts(bytes, size), whole) << name << " in bursts of " << size;
    }
}

TEST(TrekStream, losesNothingOfUsbTransfersThatSplitEveryLine)
{
    std::string bytes;
    std::vector<std::size_t> cuts;
    for (int i = 0; i < 200; ++i) {
        cuts.push_back(bytes.size() + 64);
        bytes += (i % 3 == 0 ? trekThree : i % 3 == 1 ? trek : trekRaw) + "\r\n";
        cuts.push_back(bytes.size());
    }
    const Heard heard = hear(bytes, cuts);
    EXPECT_EQ(heard.reports.size(), 200U);
    EXPECT_EQ(heard.counts.damaged() + heard.counts.skipped(), 0U);
}

TEST(TrekStream, findsEveryReportInNoiseAndCountsTheRest)
{
    const Heard heard = hear(streams[7].second);
    EXPECT_EQ(heard.reports.size(), 7U);
    EXPECT_EQ(heard.counts.reports, 7U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::Noise), 3U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::Truncated), 1U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::Overlong), 2U);
    EXPECT_EQ(heard.counts.damaged(), 6U);
    EXPECT_EQ(dropDetail(heard.counts), "3 noise, 1 truncated, 2 over-long");
}

TEST(TrekStream, countsTheOtherTextOfThePortByItsKind)
{
    const Heard heard = hear(lines({"T00012ab3 late", "me 00 01", ulmText, "nVer.  2.10  TREK\x0a", "hello",
                                    "", "  ", "mc 0f 00000663",
                                    "mc 0f 0000066g 000005a3 00000512 000004cb "
                                    "095f c1 00024c24 a0:0",
                                    "\x01\x02"}));
    EXPECT_EQ(dropped(heard.counts, TrekDrop::TimeoutNote), 1U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::EventCounters), 1U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::CloneText), 1U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::HandshakeReply), 1U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::OtherText), 1U);
    EXPECT_EQ(heard.counts.skipped(), 5U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::Truncated), 1U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::BadField), 1U);
    EXPECT_EQ(dropped(heard.counts, TrekDrop::Noise), 1U);
    EXPECT_EQ(heard.counts.damaged(), 3U);
    EXPECT_EQ(dropDetail({}), "");
}

TEST(TrekStream, findsAReportBehindAnyAmountOfNoiseWithoutALineEnd)
{
    for (const std::size_t n : {1U, 400U, 447U, 448U, 449U, 450U, 508U, 511U, 512U, 513U, 1000U, 5000U}) {
        for (const char noise : {'z', '\xff', 'm'}) {
            const std::string bytes = std::string(n, noise) + trek + "\r\n" + trek + "\r\n";
            const Heard heard = hear(bytes);
            ASSERT_EQ(heard.reports.size(), 2U) << n << " times " << noise;
            ASSERT_EQ(heard.counts.damaged() + heard.counts.skipped(), 1U) << n << " times " << noise;
        }
    }
}

TEST(TrekStream, losesNoWholeReportInRandomNoiseBetweenThem)
{
    SplitMix64 random(7);
    std::string bytes;
    std::size_t sent = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto length = static_cast<std::size_t>(random.uniform(0.0, 40.0));
        // Noise before the line, with line ends of its own now and then; never a prefix that could be a
        // report.
        for (std::size_t n = 0; n < length; ++n)
            bytes += static_cast<char>(random.next() & 0xFFU);
        bytes += trekReports[random.next() % trekReports.size()] + "\r\n";
        ++sent;
    }
    EXPECT_EQ(hear(bytes).reports.size(), sent);
    EXPECT_EQ(hearInBursts(bytes, 16), hear(bytes));
}

TEST(TrekStream, stampsAReportWithTheArrivalOfItsFirstByte)
{
    const std::string bytes = "xx" + trek + "\r\n" + trekThree + "\r\n";
    // Pieces arrive at 1, 2, 3, ... ms.
    const auto times = [&bytes](const std::vector<std::size_t>& cuts) {
        std::vector<Duration> result;
        for (const TrekReport& report : hear(bytes, cuts, true).reports)
            result.push_back(report.firstByte.time_since_epoch());
        return result;
    };
    using Times = std::vector<Duration>;
    EXPECT_EQ(times({}), (Times{1ms, 1ms}));
    EXPECT_EQ(times({2}), (Times{2ms, 2ms})) << "what stood before the report came earlier";
    EXPECT_EQ(times({1, 3}), (Times{2ms, 3ms}));
    EXPECT_EQ(times({2, 18, 34, 50, 66}), (Times{2ms, 6ms}));
    EXPECT_EQ(times({2, 66, 67}), (Times{2ms, 4ms}));
}

TEST(TrekStream, stampsAReportRightBehindOverlongNoise)
{
    const std::string bytes = std::string(600, 'z') + trek + "\r\n";
    const Heard heard = hear(bytes, {512, 560, 599, 600, 620}, true);
    ASSERT_EQ(heard.reports.size(), 1U);
    EXPECT_EQ(heard.reports[0].firstByte.time_since_epoch(), 5ms);
}

TEST(TrekStream, forgetsAHalfLineAndTheDialectButNoCountOnReset)
{
    TrekStream stream;
    std::size_t reports = 0;
    const auto count = [&reports](const TrekReport&) { ++reports; };
    stream.feed(ulmFour + "\r\nnoise\r\nmc 00 00", Time{}, count);
    const auto before = stream.counts();
    EXPECT_EQ(stream.dialect().dialect(), UwbDialect::UlmFour);
    stream.reset();
    EXPECT_EQ(stream.counts(), before);
    EXPECT_EQ(stream.dialect().dialect(), UwbDialect::Unknown);
    stream.feed(trek + "\r\n", Time{}, count);
    EXPECT_EQ(reports, 2U);
    EXPECT_EQ(stream.counts().damaged(), before.damaged());
}

TEST(TrekStream, readsTheLastLineOfAFileWithoutItsEnd)
{
    TrekStream stream;
    std::size_t reports = 0;
    const auto count = [&reports](const TrekReport&) { ++reports; };
    stream.feed(trek, Time{}, count);
    EXPECT_EQ(reports, 0U);
    stream.finish(count);
    EXPECT_EQ(reports, 1U);
}

TEST(TrekStream, usesTheMaskOfTrekAndTheRangesThemselvesOfClones)
{
    EXPECT_EQ(hear(trekThree + "\n").reports.at(0).usable, 0x07);
    EXPECT_EQ(hear(ulmFour + "\n").reports.at(0).usable, 0x0B);
    EXPECT_EQ(hear(ulmEight + "\n").reports.at(0).usable, 0x9F);
    EXPECT_EQ(hear(esp32 + "\n").reports.at(0).usable, 0x0B);
    EXPECT_EQ(hear(trekOld + "\n").reports.at(0).usable, 0x01);
    EXPECT_EQ(hear(imuFour + "\n").reports.at(0).usable, 0x05);
    EXPECT_EQ(hear(trekAnchors + "\n").reports.at(0).usable, 0x0E);
}

TEST(TrekStream, usesNoRangeThatIsNotPositive)
{
    const std::string line = "mc 0f 00000000 fffffff6 ffffffff 000004cb 095f c1 00024c24 a0:0\n";
    EXPECT_EQ(hear(line).reports.at(0).usable, 0x08);
}

TEST(TrekStream, givesTheClockOfTheUnitInMilliseconds)
{
    EXPECT_EQ(hear(trek + "\n").reports.at(0).deviceTime_ms, 0x24c24);
    EXPECT_EQ(hear(trekRaw + "\n").reports.at(0).deviceTime_ms, -1) << "antenna delays, not a time";
    EXPECT_EQ(hear(ulmFour + "\n").reports.at(0).deviceTime_ms, 21332);
    EXPECT_EQ(hear(esp32 + "\n").reports.at(0).deviceTime_ms, -1);
    EXPECT_EQ(hear(trekOld + "\n").reports.at(0).deviceTime_ms, 0x3a82);
    EXPECT_EQ(hear(imuFour + "\n").reports.at(0).deviceTime_ms, 981937);
}
