// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/reader_stream.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace agv;
using namespace agv::protocol;
using namespace std::chrono_literals;
using Reports = std::vector<ReaderReport>;

namespace {

const std::string read7 = "SCAN:+UID=E00402000018313E,+RSSI=7/6";
const std::string read5 = "SCAN:+UID=E00401503A5BD691,+RSSI=5/4";
const std::string incompleteLine = "SCAN:-UID=E00401503A5BDAE4";
const CompleteRead report7{TagUid{0xE00402000018313EU}, 7, 6};
const CompleteRead report5{TagUid{0xE00401503A5BD691U}, 5, 4};
const IncompleteRead incompleteReport{TagUid{0xE00401503A5BDAE4U}};

Reports reportsOf(ReaderStream& stream, std::string_view bytes)
{
    Reports reports;
    stream.feed(bytes, [&reports](const ReaderReport& report) { reports.push_back(report); });
    return reports;
}

std::uint64_t dropped(const ReaderStream& stream, ReaderLineError error)
{
    return stream.counts().dropped[static_cast<std::size_t>(error)];
}

} // namespace

TEST(ReaderStream, countsWhatItPassesOn)
{
    ReaderStream stream;
    const Reports reports = reportsOf(stream, "OK\r" + read7 + "\r" + incompleteLine + "\r\n+TAGS=1\n" +
                                                  read5 + "\nCard read UID: 233,148,35,65\r");
    EXPECT_EQ(reports, (Reports{ReaderOk{}, report7, incompleteReport, InventoryCount{1}, report5,
                                Rc522Read{TagUid{0xE9942341U}}}));
    EXPECT_EQ(stream.counts().complete, 3U);
    EXPECT_EQ(stream.counts().incomplete, 1U);
    EXPECT_EQ(stream.counts().other, 2U);
    EXPECT_EQ(stream.counts().droppedTotal(), 0U);
    EXPECT_EQ(dropDetail(stream.counts()), "");
}

TEST(ReaderStream, countsEverythingItDropsByItsReason)
{
    ReaderStream stream;
    const Reports reports =
        reportsOf(stream, "8313E,+RSSI=7/6\rAT+Scan=OFF\r\xff\xfe\rSCAN:+UID=E004,+RSSI=7/6\r"
                          "SCAN:+UID=E00402000018313E,+RSSI=9/6\rSCAN:+UID=E00402000018\r+TAGS=many\rOKOK\r" +
                              std::string(300, 'x') + "\r" + read7 + "\r");
    EXPECT_EQ(reports, Reports{report7});
    EXPECT_EQ(dropped(stream, ReaderLineError::Noise), 3U);
    EXPECT_EQ(dropped(stream, ReaderLineError::BadUid), 1U);
    EXPECT_EQ(dropped(stream, ReaderLineError::BadRssi), 1U);
    EXPECT_EQ(dropped(stream, ReaderLineError::Truncated), 1U);
    EXPECT_EQ(dropped(stream, ReaderLineError::TrailingText), 1U);
    EXPECT_EQ(dropped(stream, ReaderLineError::Overlong), 1U);
    EXPECT_EQ(dropped(stream, ReaderLineError::BadCount), 1U);
    EXPECT_EQ(stream.counts().droppedTotal(), 9U);
    EXPECT_EQ(dropDetail(stream.counts()),
              "3 noise, 1 bad UID, 1 bad RSSI, 1 truncated, 1 trailing text, 1 over-long, 1 bad tag count");
}

TEST(ReaderStream, doesNotLoseAReadToWhatStandsBeforeIt)
{
    ReaderStream stream;
    EXPECT_EQ(reportsOf(stream, "\xff\x80 " + read7 + "\r"), Reports{report7});
    EXPECT_EQ(dropped(stream, ReaderLineError::Noise), 1U);
    EXPECT_EQ(reportsOf(stream, "SCAN:+UID=E0040200" + read5 + "\r"), Reports{report5});
    EXPECT_EQ(dropped(stream, ReaderLineError::Truncated), 1U);
    EXPECT_EQ(reportsOf(stream, "OK" + read7 + read5 + "\r"), (Reports{ReaderOk{}, report7, report5}));
    EXPECT_EQ(stream.counts().droppedTotal(), 2U);
}

TEST(ReaderStream, forgetsHalfALineButNoCountOnReset)
{
    ReaderStream stream;
    reportsOf(stream, read7 + "\rnoise\r" + std::string(300, 'x') + "\rSCAN:+UID=E0");
    const auto before = stream.counts();
    stream.reset();
    EXPECT_EQ(stream.counts(), before);
    EXPECT_EQ(reportsOf(stream, read5 + "\r"), Reports{report5});
}

TEST(ReaderStream, givesTheSameReportsAndCountsAtEverySplit)
{
    const std::string bytes = "13E,+RSSI=7/6\rOK<\\r>" + read7 + "\r\n" + incompleteLine + "\n\xff" + read5 +
                              "\r" + read7 + "<\\r>" + std::string(260, 'x') + "\r+TAGS=1\r" + read5 +
                              "\r\nSCAN:+UID=E00";
    ReaderStream whole;
    const Reports expected = reportsOf(whole, bytes);
    ASSERT_EQ(expected,
              (Reports{ReaderOk{}, report7, incompleteReport, report5, report7, InventoryCount{1}, report5}));
    for (std::size_t i = 0; i <= bytes.size(); ++i) {
        ReaderStream stream;
        Reports reports = reportsOf(stream, bytes.substr(0, i));
        const Reports rest = reportsOf(stream, bytes.substr(i));
        reports.insert(reports.end(), rest.begin(), rest.end());
        ASSERT_EQ(reports, expected) << "split at " << i;
        ASSERT_EQ(stream.counts(), whole.counts()) << "split at " << i;
    }
    ReaderStream stream;
    Reports reports;
    for (const char byte : bytes)
        stream.feed(std::string_view(&byte, 1),
                    [&reports](const ReaderReport& report) { reports.push_back(report); });
    EXPECT_EQ(reports, expected);
    EXPECT_EQ(stream.counts(), whole.counts());
}

TEST(ReaderStream, stampsAReadWithTheArrivalOfTheFirstByteOfItsLine)
{
    std::vector<Time> times;
    const auto note = [&times](const ReaderReport&, Time firstByte) { times.push_back(firstByte); };
    ReaderStream stream;
    stream.feed(read7 + "\r" + read5.substr(0, 9), Time{} + 1ms, note);
    stream.feed(read5.substr(9, 9), Time{} + 2ms, note);
    stream.feed(read5.substr(18), Time{} + 3ms, note);
    stream.feed("\r", Time{} + 4ms, note);
    stream.feed("\n" + read7 + "\r", Time{} + 5ms, note);
    EXPECT_EQ(times, (std::vector<Time>{Time{} + 1ms, Time{} + 1ms, Time{} + 5ms}));
}

TEST(ReaderStream, stampsTheNextReadAnewAfterAReset)
{
    std::vector<Time> times;
    const auto note = [&times](const ReaderReport&, Time firstByte) { times.push_back(firstByte); };
    ReaderStream stream;
    stream.feed("SCAN:", Time{} + 1ms, note);
    stream.reset();
    stream.feed(read7, Time{} + 7ms, note);
    stream.feed("\r", Time{} + 8ms, note);
    EXPECT_EQ(times, std::vector<Time>{Time{} + 7ms});
}
