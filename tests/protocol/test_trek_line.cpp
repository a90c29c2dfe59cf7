// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_line.h"

#include "protocol/trek_samples.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::protocol;
using namespace agv::protocol::samples;

namespace {

TrekReport decoded(std::string_view line)
{
    TrekReport report;
    const auto length = decodeTrekReport(line, report);
    EXPECT_TRUE(length.has_value()) << line;
    EXPECT_EQ(length.value_or(0), line.size()) << line;
    return report;
}

TrekDrop errorOf(std::string_view line)
{
    TrekReport report;
    const auto length = decodeTrekReport(line, report);
    EXPECT_FALSE(length.has_value()) << line;
    return length ? TrekDrop::OtherText : length.error();
}

} // namespace

TEST(TrekLine, readsEveryFieldOfARangeReport)
{
    const TrekReport report = decoded(trek);
    EXPECT_EQ(report.kind, TrekLineKind::Corrected);
    EXPECT_EQ(report.mask, 0x0F);
    EXPECT_EQ(report.rangeCount, 4);
    EXPECT_EQ(report.range_mm, (std::array<std::int32_t, 8>{0x663, 0x5a3, 0x512, 0x4cb, 0, 0, 0, 0}));
    EXPECT_EQ(report.rangeNumber, 0x095f);
    EXPECT_EQ(report.sequence, 0xc1);
    EXPECT_EQ(report.debug, 0x00024c24U);
    EXPECT_EQ(report.role, UwbRole::Anchor);
    EXPECT_EQ(report.tag, 0);
    EXPECT_EQ(report.unit, 0);
    EXPECT_FALSE(report.power);
}

TEST(TrekLine, tellsTheKindsApart)
{
    EXPECT_EQ(decoded(trekRaw).kind, TrekLineKind::Raw);
    EXPECT_EQ(decoded(trekAnchors).kind, TrekLineKind::Anchors);
    EXPECT_EQ(decoded(trekOld).kind, TrekLineKind::Single);
    EXPECT_EQ(decoded(imuFour).kind, TrekLineKind::Imu);
}

TEST(TrekLine, readsRangesAsSignedMillimetres)
{
    EXPECT_EQ(decoded(ulmFour).range_mm[2], -1);
    EXPECT_EQ(decoded("mc 01 fffffff6 00000000 00000000 00000000 0000 00 00000000 l7:3").range_mm[0], -10);
}

TEST(TrekLine, readsIdsOfOneToThreeDigits)
{
    EXPECT_EQ(decoded(trekThree).tag, 12);
    const TrekReport eight = decoded(ulmEight);
    EXPECT_EQ(eight.tag, 1);
    EXPECT_EQ(eight.unit, 0);
    const std::string front = trek.substr(0, trek.size() - 4);
    EXPECT_EQ(decoded(front + "l255:17").tag, 255);
    EXPECT_EQ(decoded(front + "l255:17").role, UwbRole::Listener);
    EXPECT_EQ(errorOf(front + "a256:0"), TrekDrop::BadField);
}

TEST(TrekLine, readsEightRangesAndTheReceivePowerOfClones)
{
    const TrekReport report = decoded(ulmEight);
    EXPECT_EQ(report.rangeCount, 8);
    EXPECT_EQ(report.range_mm, (std::array<std::int32_t, 8>{0x807, 0x991, 0x815, 0x95e, 1, 0, -1, 0x9a4}));
    EXPECT_EQ(report.power, 0);
    EXPECT_EQ(decoded(ulmFour).power, 0x1f40);
}

TEST(TrekLine, readsTheLineOfFirmware106)
{
    const TrekReport report = decoded(trekOld);
    EXPECT_EQ(report.firstAnchor, 3);
    EXPECT_EQ(report.rangeCount, 1);
    EXPECT_EQ(report.tag, 1);
    EXPECT_EQ(report.unit, 0);
    EXPECT_EQ(report.range_mm[0], 0x650) << "the corrected one, not the raw one";
    EXPECT_EQ(report.sequence, 2);
    EXPECT_EQ(report.rangeNumber, 3);
}

TEST(TrekLine, readsTheCommaFormsWithFourAndEightRanges)
{
    const TrekReport four = decoded(imuFour);
    EXPECT_EQ(four.rangeCount, 4);
    EXPECT_EQ(four.mask, 0x05);
    EXPECT_EQ(four.range_mm[0], 630);
    EXPECT_EQ(four.range_mm[2], 1250);
    EXPECT_EQ(four.deviceTime_ms, 981937);
    EXPECT_EQ(four.motionCount, 6);
    EXPECT_FLOAT_EQ(four.motion[2], 9.075048F);
    EXPECT_EQ(four.tag, 0);

    const TrekReport eight = decoded(imuEight);
    EXPECT_EQ(eight.rangeCount, 8);
    EXPECT_EQ(eight.mask, 0x0F);
    EXPECT_EQ(eight.motionCount, 12);
    EXPECT_FLOAT_EQ(eight.motion[11], -4.479F);
    EXPECT_EQ(eight.tag, 3);
}

TEST(TrekLine, readsCommaFormsWithoutATimeAndWithNineSensors)
{
    const TrekReport noTime = decoded("mi,null,null,1.5,2.5,1,2,3,4,5,6,7,8,9,T4");
    EXPECT_EQ(noTime.deviceTime_ms, -1);
    EXPECT_EQ(noTime.mask, 0x0C);
    EXPECT_EQ(noTime.motionCount, 9);
    const TrekReport timed = decoded("mi,3.5,0.5,1.5,2.5,null,1,2,3,4,5,6,7,8,9,T4");
    EXPECT_EQ(timed.deviceTime_ms, 3500);
    EXPECT_EQ(timed.mask, 0x07);
    EXPECT_EQ(timed.motionCount, 9);
}

TEST(TrekLine, callsEveryShorterLineTruncatedOrBad)
{
    for (const std::string& line : {trek, trekRaw, trekAnchors, trekOld, esp32, imuFour, imuEight}) {
        for (std::size_t n = 0; n < line.size(); ++n) {
            const TrekDrop drop = errorOf(line.substr(0, n));
            EXPECT_TRUE(drop == TrekDrop::Truncated || drop == TrekDrop::BadField) << line.substr(0, n);
        }
    }
}

TEST(TrekLine, refusesACharacterThatDoesNotBelongAtEveryPlace)
{
    TrekReport report;
    for (const std::string& line : {trek, trekOld, ulmEight.substr(0, ulmEight.size() - 5)}) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            std::string damaged = line;
            damaged[i] = 'x';
            EXPECT_FALSE(decodeTrekReport(damaged, report)) << damaged;
        }
    }
}

TEST(TrekLine, endsWhereTheNextTextBegins)
{
    TrekReport report;
    for (const std::string& line : trekReports)
        for (const std::string& next : {trek, trekOld, imuFour, ulmText, std::string("T0000abcd poll"),
                                        std::string("me 01"), std::string("\xff"), std::string(" ")})
            EXPECT_EQ(decodeTrekReport(line + next, report).value_or(0), line.size()) << line + next;
    EXPECT_EQ(decodeTrekReport(trek + "x", report).value_or(0), trek.size());
    EXPECT_FALSE(decodeTrekReport(imuFour + "x", report)) << "the tag may have been damaged";
}

TEST(TrekLine, isTheSameAfterEncoding)
{
    for (const std::string& line : trekReports) {
        const TrekReport report = decoded(line);
        EXPECT_EQ(decoded(encodeTrekReport(report)), report) << line;
    }
    EXPECT_EQ(encodeTrekReport(decoded(trek)), trek);
    EXPECT_EQ(encodeTrekReport(decoded(trekRaw)), trekRaw);
    EXPECT_EQ(encodeTrekReport(decoded(ulmFour)), ulmFour);
}

TEST(TrekLine, isAsLongAsTheProtocolSays)
{
    EXPECT_EQ(trek.size() + 2, 65U);
    EXPECT_EQ(trekThree.size() + 2, 66U);
    EXPECT_EQ(ulmEight.size() + 2, 107U);
}

TEST(TrekTime, isDecimalInClonesAndHexadecimalInTrek)
{
    EXPECT_EQ(trekTime_ms(0x00021332, UwbDialect::Trek), 0x21332U);
    EXPECT_EQ(trekTime_ms(0x00021332, UwbDialect::UlmFour), 21332U);
    EXPECT_EQ(trekTime_ms(0x0002133a, UwbDialect::UlmFour), std::nullopt);
    EXPECT_EQ(trekTime_ms(0, UwbDialect::Esp32), std::nullopt);
    for (const UwbDialect dialect : {UwbDialect::Trek, UwbDialect::UlmFour, UwbDialect::UlmEight})
        for (const std::uint32_t ms : {0U, 9U, 10U, 65536U, 99999999U})
            EXPECT_EQ(trekTime_ms(trekTimeField(ms, dialect), dialect), ms);
}
