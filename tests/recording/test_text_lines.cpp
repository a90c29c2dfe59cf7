// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/text_lines.h"

#include <gtest/gtest.h>

namespace agv::recording {
namespace {

TEST(TextLines, endAtEveryKindOfLineEndAndKeepTheirNumbers)
{
    const auto lines = linesOf("\xEF\xBB\xBF"
                               "a\nb\r\nc\r\re");
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[0].text, "a");
    EXPECT_EQ(lines[1].text, "b");
    EXPECT_EQ(lines[2].text, "c");
    EXPECT_EQ(lines[3].text, "");
    EXPECT_EQ(lines[4].text, "e");
    EXPECT_EQ(lines[4].number, 5);
    EXPECT_TRUE(linesOf("").empty());
    EXPECT_EQ(linesOf("a\n").size(), 1U);
}

TEST(TextLines, numbersMustBeWhole)
{
    EXPECT_EQ(parseInteger("12"), 12);
    EXPECT_EQ(parseInteger("-3"), -3);
    EXPECT_FALSE(parseInteger("12x").has_value());
    EXPECT_FALSE(parseInteger("").has_value());
    EXPECT_FALSE(parseInteger("99999999999").has_value());
    EXPECT_EQ(parseNumber("2.250000e+01"), 22.5);
    EXPECT_FALSE(parseNumber("nan").has_value());
    EXPECT_FALSE(parseNumber("inf").has_value());
}

TEST(TextLines, areShownShortAndPrintable)
{
    EXPECT_EQ(inQuotes("a\tb\xFF"), "'a?b?'");
    EXPECT_EQ(inQuotes(std::string(50, 'x')), "'" + std::string(40, 'x') + "...'");
}

} // namespace
} // namespace agv::recording
