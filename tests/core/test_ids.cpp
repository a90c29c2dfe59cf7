// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ids.h"

#include <gtest/gtest.h>

using namespace agv;

TEST(TagUid, keepsAll64BitsAndShowsTheLastThreeDigits)
{
    const auto uid = parseTagUid("e00401503A5BDAE4");
    ASSERT_TRUE(uid);
    EXPECT_EQ(fullText(*uid), "E00401503A5BDAE4");
    EXPECT_EQ(shortText(*uid), "AE4");
}

TEST(TagUid, refusesAnythingThatIsNotHexadecimal)
{
    for (const char* text : {"", "G", "E00401503A5BDAE4F", "0x12", " 12", "12 ", "-1", "+1"}) {
        const auto uid = parseTagUid(text);
        ASSERT_FALSE(uid) << text;
        EXPECT_EQ(uid.error().code, ErrorCode::BadInput);
        EXPECT_NE(uid.error().detail.find(text), std::string::npos);
    }
}
