// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_dialect.h"

#include "protocol/trek_samples.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::protocol;
using namespace agv::protocol::samples;

namespace {

class TrekDialect : public testing::Test {
protected:
    UwbDialect after(std::string_view line)
    {
        m_stream.feed(std::string(line) + "\r\n", Time{}, [this](const TrekReport& r) { m_last = r; });
        return m_stream.dialect().dialect();
    }
    TrekStream m_stream;
    TrekReport m_last;
};

const std::string nothingMeasured = "mc 00 00000000 00000000 00000000 00000000 095f c1 00024c24 a0:0";
const std::string ulmWithoutPower = "mc 00 00000807 00000991 00000815 0000095e 00b6 b7 00021332 t0:0";

} // namespace

TEST_F(TrekDialect, isFoundFromTheFirstLineThatTells)
{
    const std::vector<std::pair<std::string, UwbDialect>> lines{
        {trek, UwbDialect::Trek},        {trekRaw, UwbDialect::Trek},
        {trekAnchors, UwbDialect::Trek}, {trekOld, UwbDialect::TrekOld},
        {ulmFour, UwbDialect::UlmFour},  {ulmEight, UwbDialect::UlmEight},
        {ulmText, UwbDialect::UlmFour},  {ulmWithoutPower, UwbDialect::UlmFour},
        {esp32, UwbDialect::Esp32},      {imuFour, UwbDialect::Imu},
        {imuEight, UwbDialect::Imu},     {nothingMeasured, UwbDialect::Unknown},
        {"hello", UwbDialect::Unknown},
    };
    for (const auto& [line, dialect] : lines) {
        m_stream = TrekStream{};
        EXPECT_EQ(after(line), dialect) << line;
        EXPECT_EQ(std::string_view(m_stream.dialect().evidence()).empty(), dialect == UwbDialect::Unknown);
    }
}

TEST_F(TrekDialect, givesAllRangesOfTheVeryLineThatFoundIt)
{
    after(ulmWithoutPower);
    EXPECT_EQ(m_last.usable, 0x0F);
}

TEST_F(TrekDialect, isNotChangedByOneDamagedLine)
{
    after(trek);
    EXPECT_EQ(after(ulmWithoutPower), UwbDialect::Trek);
    EXPECT_EQ(m_last.usable, 0x00) << "the mask counts";
    EXPECT_EQ(m_stream.dialect().contradictions(), 1U);
    after(trek);
    after(ulmWithoutPower);
    EXPECT_EQ(after(ulmWithoutPower), UwbDialect::Trek);
    EXPECT_EQ(m_stream.dialect().contradictions(), 3U);
}

TEST_F(TrekDialect, changesAfterThreeLinesThatSayTheSame)
{
    after(trek);
    after(ulmWithoutPower);
    after(ulmWithoutPower);
    EXPECT_EQ(after(ulmWithoutPower), UwbDialect::UlmFour);
    EXPECT_EQ(m_last.usable, 0x0F);
    after(trek);
    after(trek);
    EXPECT_EQ(after(trek), UwbDialect::Trek);
}

TEST_F(TrekDialect, ofEightRangesIsNotDoubtedByTheTextThatBothClonesPrint)
{
    after(ulmEight);
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(after(ulmText), UwbDialect::UlmEight);
    EXPECT_EQ(m_stream.dialect().contradictions(), 0U);
}

TEST_F(TrekDialect, canBeOverriddenAndStaysSo)
{
    m_stream.dialect().setOverride(UwbDialect::Trek);
    EXPECT_EQ(after(ulmWithoutPower), UwbDialect::Trek);
    EXPECT_EQ(m_last.usable, 0x00);
    EXPECT_EQ(m_stream.dialect().detected(), UwbDialect::UlmFour);
    m_stream.reset();
    EXPECT_EQ(m_stream.dialect().dialect(), UwbDialect::Trek);
    m_stream.dialect().setOverride(std::nullopt);
    EXPECT_EQ(after(ulmWithoutPower), UwbDialect::UlmFour);
}

TEST_F(TrekDialect, canBeOverriddenWithoutLosingLinesOfAnotherForm)
{
    m_stream.dialect().setOverride(UwbDialect::UlmFour);
    for (const std::string& line : trekReports)
        after(line);
    EXPECT_EQ(m_stream.counts().reports, trekReports.size());
}
