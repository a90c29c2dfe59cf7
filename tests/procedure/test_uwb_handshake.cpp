// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/uwb_handshake.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::procedure;
using namespace std::chrono_literals;
using State = UwbHandshakeState;
using Action = UwbHandshakeAction;

namespace {

constexpr Time start{};
const std::string report = "mc 0f 00000663 000005a3 00000512 000004cb 095f c1 00024c24 a0:0\r\n";
/// Anchor 0 at 6.81 Mb/s on channel 2: the configuration byte is a line feed.
const std::string answer210 = "nVer.  2.10  TREK\x0a\r\n";
const std::string answer225 = std::string("nVer.2.25mx TREK\0\x4c\r\n", 20);

UwbHandshake asked()
{
    UwbHandshake handshake;
    handshake.opened(true, start);
    EXPECT_EQ(handshake.bytes(report, UwbDialect::Trek, start + 100ms), Action::SendRequest);
    return handshake;
}

} // namespace

TEST(UwbHandshake, asksATrekUnitAsSoonAsItsReportsSayThatItIsOne)
{
    UwbHandshake handshake;
    EXPECT_EQ(handshake.opened(true, start), Action::None);
    EXPECT_EQ(handshake.state(), State::Listening);
    EXPECT_EQ(handshake.bytes("mc 0f 0000", UwbDialect::Unknown, start + 10ms), Action::None);
    EXPECT_EQ(handshake.bytes(report, UwbDialect::Trek, start + 100ms), Action::SendRequest);
    EXPECT_EQ(handshake.state(), State::Asked);
    EXPECT_EQ(UwbHandshake::request, "decA$");
}

TEST(UwbHandshake, asksATrekPortThatSaysNothingAfterASecond)
{
    UwbHandshake handshake;
    handshake.opened(true, start);
    EXPECT_EQ(handshake.deadline(), start + 1s);
    EXPECT_EQ(handshake.onTimer(start + 999ms), Action::None);
    EXPECT_EQ(handshake.onTimer(start + 1s), Action::SendRequest);
}

TEST(UwbHandshake, readsVersionAndConfigurationAndWaitsForTheSilenceToEnd)
{
    UwbHandshake handshake = asked();
    EXPECT_EQ(handshake.bytes(answer210, UwbDialect::Trek, start + 110ms), Action::None);
    EXPECT_EQ(handshake.state(), State::Quiet);
    ASSERT_TRUE(handshake.unit());
    EXPECT_EQ(handshake.unit()->version, "Ver.  2.10  TREK");
    EXPECT_EQ(handshake.unit()->configuration, (UwbConfiguration{true, 2, UwbRole::Anchor, 0}));
    EXPECT_TRUE(handshake.isSilenceExpected(start + 1099ms));
    EXPECT_FALSE(handshake.isSilenceExpected(start + 1100ms));
    EXPECT_EQ(handshake.deadline(), start + 1100ms);
    EXPECT_EQ(handshake.onTimer(start + 1100ms), Action::None);
    EXPECT_EQ(handshake.state(), State::Known);
    EXPECT_EQ(handshake.deadline(), std::nullopt);
}

TEST(UwbHandshake, readsTheVersionOfFirmware225WithAndWithoutItsSixteenthByte)
{
    for (const std::string& answer : {answer225, std::string("nVer.2.25mx TREK\x4c\r\n")}) {
        UwbHandshake handshake = asked();
        handshake.bytes(answer, UwbDialect::Trek, start + 110ms);
        ASSERT_TRUE(handshake.unit());
        EXPECT_EQ(handshake.unit()->version, "Ver.2.25mx TREK");
        EXPECT_EQ(handshake.unit()->configuration, (UwbConfiguration{false, 5, UwbRole::Anchor, 1}));
    }
}

TEST(UwbHandshake, readsEveryConfigurationByte)
{
    for (int byte = 0; byte < 256; ++byte) {
        for (const std::string& begin : {std::string("nVer.  2.10  TREK"), std::string("nVer.2.25mx TREK")}) {
            UwbHandshake handshake = asked();
            handshake.bytes(begin + static_cast<char>(byte) + "\r\n", UwbDialect::Trek, start + 110ms);
            ASSERT_TRUE(handshake.unit()) << byte;
            EXPECT_EQ(handshake.unit()->configuration,
                      decodeUwbConfiguration(static_cast<std::uint8_t>(byte)));
        }
    }
}

TEST(UwbHandshake, findsTheAnswerBetweenReportsAtEverySplit)
{
    const std::string bytes = report + "nVer" + answer225 + report;
    for (std::size_t i = 0; i <= bytes.size(); ++i) {
        for (std::size_t j = i; j <= bytes.size(); ++j) {
            UwbHandshake handshake = asked();
            handshake.bytes(bytes.substr(0, i), UwbDialect::Trek, start + 110ms);
            handshake.bytes(bytes.substr(i, j - i), UwbDialect::Trek, start + 111ms);
            handshake.bytes(bytes.substr(j), UwbDialect::Trek, start + 112ms);
            ASSERT_TRUE(handshake.unit()) << i << " " << j;
            ASSERT_EQ(handshake.unit()->version, "Ver.2.25mx TREK");
        }
    }
}

TEST(UwbHandshake, sendsNothingToAClone)
{
    for (const UwbDialect dialect :
         {UwbDialect::UlmFour, UwbDialect::UlmEight, UwbDialect::Esp32, UwbDialect::Imu}) {
        UwbHandshake handshake;
        handshake.opened(true, start);
        EXPECT_EQ(handshake.bytes("...", dialect, start + 10ms), Action::None);
        EXPECT_EQ(handshake.state(), State::NotAsked);
        EXPECT_NE(handshake.reason().find(toText(dialect)), std::string::npos);
        EXPECT_EQ(handshake.onTimer(start + 1h), Action::None);
    }
}

TEST(UwbHandshake, sendsNothingToAForeignPortWhateverItsReports)
{
    UwbHandshake handshake;
    EXPECT_EQ(handshake.opened(false, start), Action::None);
    EXPECT_EQ(handshake.bytes(report, UwbDialect::Trek, start + 10ms), Action::None);
    EXPECT_EQ(handshake.onTimer(start + 1h), Action::None);
    EXPECT_EQ(handshake.state(), State::NotAsked);
    EXPECT_FALSE(handshake.reason().empty());
}

TEST(UwbHandshake, asksAnyUnitWhenTheOperatorWantsIt)
{
    UwbHandshake handshake;
    EXPECT_EQ(handshake.ask(start), Action::None) << "no port";
    handshake.opened(false, start);
    EXPECT_EQ(handshake.ask(start + 1s), Action::SendRequest);
    EXPECT_EQ(handshake.ask(start + 2s), Action::None) << "asked already";
    handshake.bytes(answer210, UwbDialect::UlmFour, start + 1010ms);
    handshake.onTimer(start + 2s);
    EXPECT_EQ(handshake.state(), State::Known);
    EXPECT_EQ(handshake.ask(start + 9s), Action::SendRequest);
    EXPECT_FALSE(handshake.unit()) << "what it said before may have changed";
}

TEST(UwbHandshake, asksASecondTimeAndThenGoesOnWithoutAnAnswer)
{
    UwbHandshake handshake = asked();
    EXPECT_EQ(handshake.onTimer(start + 1599ms), Action::None);
    EXPECT_EQ(handshake.onTimer(start + 1600ms), Action::SendRequest);
    EXPECT_EQ(handshake.onTimer(start + 3100ms), Action::None);
    EXPECT_EQ(handshake.state(), State::Unanswered);
    EXPECT_FALSE(handshake.reason().empty());
    EXPECT_EQ(handshake.deadline(), std::nullopt);
}

TEST(UwbHandshake, doesNotAskAgainWhatTurnsOutToBeAClone)
{
    UwbHandshake handshake;
    handshake.opened(true, start);
    EXPECT_EQ(handshake.onTimer(start + 1s), Action::SendRequest) << "it said nothing";
    handshake.bytes("$NKT0,", UwbDialect::UlmFour, start + 2s);
    EXPECT_EQ(handshake.onTimer(start + 2500ms), Action::None);
    EXPECT_EQ(handshake.state(), State::Unanswered);
}

TEST(UwbHandshake, takesAnAnswerAfterTheSilenceAsKnownAtOnce)
{
    UwbHandshake handshake = asked();
    handshake.bytes(answer210, UwbDialect::Trek, start + 1300ms);
    EXPECT_EQ(handshake.state(), State::Known);
}

TEST(UwbHandshake, forgetsTheUnitWhenThePortIsClosed)
{
    UwbHandshake handshake = asked();
    handshake.bytes(answer210, UwbDialect::Trek, start + 110ms);
    handshake.closed();
    EXPECT_EQ(handshake.state(), State::Closed);
    EXPECT_FALSE(handshake.unit());
    EXPECT_EQ(handshake.deadline(), std::nullopt);
    EXPECT_EQ(handshake.bytes(answer210, UwbDialect::Trek, start + 120ms), Action::None);
    EXPECT_EQ(handshake.onTimer(start + 1h), Action::None);
}
