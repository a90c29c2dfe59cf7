// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/reader_line.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace agv;
using namespace agv::protocol;

namespace {

constexpr TagUid tag{0xE00402000018313EU};

void expectReport(std::string_view line, const ReaderReport& expected)
{
    const auto report = decodeReaderLine(line);
    ASSERT_TRUE(report) << line << ": " << toText(report.error());
    EXPECT_EQ(*report, expected) << line;
}

void expectError(std::string_view line, ReaderLineError expected)
{
    const auto report = decodeReaderLine(line);
    ASSERT_FALSE(report) << line;
    EXPECT_STREQ(toText(report.error()), toText(expected)) << line;
}

} // namespace

TEST(ReaderLine, decodesACompleteReadWithBothChannels)
{
    expectReport("SCAN:+UID=E00402000018313E,+RSSI=7/6", CompleteRead{tag, 7, 6});
}

TEST(ReaderLine, acceptsEveryRssiOfBothChannels)
{
    for (int main = 0; main <= 7; ++main) {
        const std::string line = "SCAN:+UID=E00402000018313E,+RSSI=" + std::to_string(main);
        expectReport(line, CompleteRead{tag, main, -1});
        for (int auxiliary = 0; auxiliary <= 7; ++auxiliary)
            expectReport(line + "/" + std::to_string(auxiliary), CompleteRead{tag, main, auxiliary});
    }
}

TEST(ReaderLine, acceptsAMissingCommaAndAMissingAuxiliaryChannel)
{
    expectReport("SCAN:+UID=E00402000018313E+RSSI=3", CompleteRead{tag, 3, -1});
    expectReport("SCAN:+UID=E00402000018313E+RSSI=3/2", CompleteRead{tag, 3, 2});
    expectReport("SCAN:+UID=E00402000018313E,+RSSI=3", CompleteRead{tag, 3, -1});
}

TEST(ReaderLine, acceptsHexadecimalDigitsOfEitherCase)
{
    expectReport("SCAN:+UID=e00402000018313e,+RSSI=7/6", CompleteRead{tag, 7, 6});
    expectReport("SCAN:-UID=E00401503a5bDaE4", IncompleteRead{TagUid{0xE00401503A5BDAE4U}});
}

TEST(ReaderLine, ignoresBlanksAroundTheLineAndItsSeparators)
{
    expectReport("  SCAN:+UID= E00402000018313E , +RSSI= 7 / 6 \t", CompleteRead{tag, 7, 6});
    expectReport(" OK ", ReaderOk{});
}

TEST(ReaderLine, keepsAllDigitsOfTheUid)
{
    expectReport("SCAN:+UID=0000000000000000,+RSSI=0/0", CompleteRead{TagUid{0}, 0, 0});
    expectReport("SCAN:+UID=FFFFFFFFFFFFFFFF,+RSSI=0/0", CompleteRead{TagUid{0xFFFFFFFFFFFFFFFFU}, 0, 0});
}

TEST(ReaderLine, decodesTheSuccessorsInventory)
{
    expectReport("+TAGS=2", InventoryCount{2});
    expectReport("+TAGS=0", InventoryCount{0});
    expectReport("+TAGS=9999", InventoryCount{9999});
    expectReport("+UID=E00402000018313E,+RSSI=5/4", CompleteRead{tag, 5, 4});
    expectError("+TAGS=10000", ReaderLineError::BadCount);
    expectError("+TAGS=x", ReaderLineError::BadCount);
    expectError("+TAGS=-1", ReaderLineError::BadCount);
    expectError("+TAGS=2,3", ReaderLineError::TrailingText);
}

TEST(ReaderLine, decodesTheRc522Reader)
{
    expectReport("Card read UID: 233,148,35,65", Rc522Read{TagUid{0xE9942341U}});
    expectReport("Card read UID:0, 0,0 ,255", Rc522Read{TagUid{0xFFU}});
    expectError("Card read UID: 256,148,35,65", ReaderLineError::BadUid);
    expectError("Card read UID: 1233,148,35,65", ReaderLineError::BadUid);
    expectError("Card read UID: 233;148;35;65", ReaderLineError::BadUid);
    expectError("Card read UID: ,148,35,65", ReaderLineError::BadUid);
    expectError("Card read UID: 233,148,35,65,1", ReaderLineError::TrailingText);
}

TEST(ReaderLine, namesABadUid)
{
    expectError("SCAN:+UID=E0040200001831,+RSSI=7/6", ReaderLineError::BadUid);
    expectError("SCAN:+UID=E00402000018313E0,+RSSI=7/6", ReaderLineError::BadUid);
    expectError("SCAN:+UID=E0040200G018313E,+RSSI=7/6", ReaderLineError::BadUid);
    expectError("SCAN:+UID=E0040200 0018313E,+RSSI=7/6", ReaderLineError::BadUid);
    expectError("SCAN:+UID=,+RSSI=7/6", ReaderLineError::BadUid);
    expectError("SCAN:-UID=E00401503A5BDAE4F", ReaderLineError::BadUid);
    expectError("SCAN:?UID=E00402000018313E,+RSSI=7/6", ReaderLineError::BadUid);
}

TEST(ReaderLine, namesABadRssi)
{
    expectError("SCAN:+UID=E00402000018313E,+RSSI=8/6", ReaderLineError::BadRssi);
    expectError("SCAN:+UID=E00402000018313E,+RSSI=7/8", ReaderLineError::BadRssi);
    expectError("SCAN:+UID=E00402000018313E,+RSSI=07/6", ReaderLineError::BadRssi);
    expectError("SCAN:+UID=E00402000018313E,+RSSI=-1/6", ReaderLineError::BadRssi);
    expectError("SCAN:+UID=E00402000018313E,+RSSI=/6", ReaderLineError::BadRssi);
    expectError("SCAN:+UID=E00402000018313E,RSSI=7/6", ReaderLineError::BadRssi);
    expectError("SCAN:+UID=E00402000018313E 7/6", ReaderLineError::BadRssi);
}

TEST(ReaderLine, namesTwoLinesThatRanIntoEachOther)
{
    expectError("SCAN:+UID=E00402000018313E,+RSSI=7/6SCAN:+UID=E00402000018313E,+RSSI=7/6",
                ReaderLineError::TrailingText);
    expectError("SCAN:-UID=E00401503A5BDAE4,+RSSI=7/6", ReaderLineError::TrailingText);
    expectError("SCAN:+UID=E00402000018313E,+RSSI=7/6/5", ReaderLineError::TrailingText);
    expectError("OKOK", ReaderLineError::TrailingText);
}

TEST(ReaderLine, namesNoise)
{
    for (const char* const line :
         {"", "   ", "AT+Scan=OFF", "AT+Scan=AC,RSSI", "8313E,+RSSI=7/6", "xSCAN:+UID=", "ERROR",
          "scan:+UID=E00402000018313E,+RSSI=7/6", "-UID=E00401503A5BDAE4", "ok"})
        expectError(line, ReaderLineError::Noise);
}

TEST(ReaderLine, takesAnyByteThatIsNotPrintableAsciiForNoise)
{
    const std::string good = "SCAN:+UID=E00402000018313E,+RSSI=7/6";
    for (const int byte : {0x00, 0x01, 0x0B, 0x1B, 0x7F, 0x80, 0xC3, 0xFF}) {
        for (std::size_t at = 0; at <= good.size(); ++at) {
            std::string line = good;
            line.insert(at, 1, static_cast<char>(byte));
            expectError(line, ReaderLineError::Noise);
        }
    }
}

TEST(ReaderLine, callsEveryTruncationOfEveryFormTruncatedUnlessItIsAWholeReportItself)
{
    const std::set<std::string> alsoWhole = {"SCAN:+UID=E00402000018313E,+RSSI=7",
                                             "+UID=E00402000018313E,+RSSI=7", "+TAGS=1", "+TAGS=12",
                                             "Card read UID: 233,148,35,6"};
    for (const std::string& line :
         {std::string("SCAN:+UID=E00402000018313E,+RSSI=7/6"), std::string("SCAN:-UID=E00401503A5BDAE4"),
          std::string("OK"), std::string("+UID=E00402000018313E,+RSSI=7/6"), std::string("+TAGS=123"),
          std::string("Card read UID: 233,148,35,65")}) {
        ASSERT_TRUE(decodeReaderLine(line)) << line;
        for (std::size_t length = 1; length < line.size(); ++length) {
            const std::string cut = line.substr(0, length);
            if (alsoWhole.contains(cut))
                EXPECT_TRUE(decodeReaderLine(cut)) << cut;
            else
                expectError(cut, ReaderLineError::Truncated);
        }
    }
}

TEST(ReaderLine, decodesWhatItEncodes)
{
    const std::vector<std::pair<ReaderReport, std::string>> lines = {
        {CompleteRead{tag, 7, 6}, "SCAN:+UID=E00402000018313E,+RSSI=7/6"},
        {CompleteRead{tag, 0, -1}, "SCAN:+UID=E00402000018313E,+RSSI=0"},
        {CompleteRead{TagUid{0}, 0, 0}, "SCAN:+UID=0000000000000000,+RSSI=0/0"},
        {IncompleteRead{TagUid{0xE00401503A5BDAE4U}}, "SCAN:-UID=E00401503A5BDAE4"},
        {ReaderOk{}, "OK"},
        {InventoryCount{0}, "+TAGS=0"},
        {InventoryCount{9999}, "+TAGS=9999"},
        {Rc522Read{TagUid{0xE9942341U}}, "Card read UID: 233,148,35,65"},
        {Rc522Read{TagUid{0}}, "Card read UID: 0,0,0,0"},
        {Rc522Read{TagUid{0xFFFFFFFFU}}, "Card read UID: 255,255,255,255"},
    };
    for (const auto& [report, line] : lines) {
        EXPECT_EQ(encodeReaderLine(report), line);
        expectReport(line, report);
    }
}

TEST(ReaderLine, hasWordsForEveryError)
{
    std::set<std::string> words;
    for (std::size_t i = 0; i < readerLineErrorCount; ++i)
        words.insert(toText(static_cast<ReaderLineError>(i)));
    EXPECT_EQ(words.size(), readerLineErrorCount);
    EXPECT_FALSE(words.contains("unknown"));
}
