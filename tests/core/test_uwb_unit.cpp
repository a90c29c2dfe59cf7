// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/uwb_unit.h"

#include <gtest/gtest.h>

using namespace agv;

TEST(UwbConfiguration, countsTheAddressFromItsMostSignificantBitInBit4)
{
    EXPECT_EQ(decodeUwbConfiguration(0x10).address, 4);
    EXPECT_EQ(decodeUwbConfiguration(0x20).address, 2);
    EXPECT_EQ(decodeUwbConfiguration(0x40).address, 1);
    EXPECT_EQ(decodeUwbConfiguration(0x70).address, 7);
}

TEST(UwbConfiguration, saysModeChannelAndRole)
{
    EXPECT_EQ(decodeUwbConfiguration(0x00), (UwbConfiguration{false, 2, UwbRole::Tag, 0}));
    EXPECT_EQ(decodeUwbConfiguration(0x0A), (UwbConfiguration{true, 2, UwbRole::Anchor, 0}));
    EXPECT_EQ(decodeUwbConfiguration(0x44), (UwbConfiguration{false, 5, UwbRole::Tag, 1}));
    EXPECT_DOUBLE_EQ(decodeUwbConfiguration(0x02).reportPeriod_s(), 0.1);
    EXPECT_DOUBLE_EQ(decodeUwbConfiguration(0x00).reportPeriod_s(), 0.28);
}

TEST(UwbConfiguration, isTheSameAfterEncodingAndIgnoresTheOtherBits)
{
    for (unsigned byte = 0; byte < 256; ++byte) {
        const auto decoded = decodeUwbConfiguration(static_cast<std::uint8_t>(byte));
        EXPECT_EQ(encodeUwbConfiguration(decoded), byte & 0x7EU);
        EXPECT_EQ(decodeUwbConfiguration(encodeUwbConfiguration(decoded)), decoded);
    }
}

TEST(UwbDialect, hasANameForEveryDialectThatReadsBack)
{
    for (std::size_t i = 0; i < uwbDialectCount; ++i) {
        const auto dialect = static_cast<UwbDialect>(i);
        EXPECT_EQ(parseUwbDialect(toText(dialect)), dialect);
    }
    EXPECT_EQ(parseUwbDialect("ulm"), std::nullopt);
    EXPECT_FALSE(isClone(UwbDialect::Trek));
    EXPECT_TRUE(isClone(UwbDialect::UlmFour));
}
