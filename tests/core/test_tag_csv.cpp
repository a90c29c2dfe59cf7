// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/tag_csv.h"

#include <gtest/gtest.h>

using namespace agv;

namespace {

const std::vector<FloorTag> twoTags{{TagUid{0xE00401503A5BDAE4}, {0.0123, -0.5}, 1},
                                    {TagUid{0xE00401503A5BD586}, {1.0, 2.25}, 7}};

std::string tagCsvError(std::string_view text)
{
    const auto tags = readTagCsv(text, "t.csv");
    return tags ? "accepted" : tags.error().detail;
}

} // namespace

TEST(TagCsv, readsCommasWithDecimalPoints)
{
    EXPECT_EQ(
        readTagCsv("uid,x_mm,y_mm,number\nE00401503A5BDAE4,12.3,-500,1\nE00401503A5BD586,1000,2250,7\n", "t"),
        twoTags);
}

TEST(TagCsv, readsSemicolonsWithDecimalCommasAndWindowsLineEnds)
{
    EXPECT_EQ(readTagCsv("\xEF\xBB\xBFnumber;uid;x_mm;y_mm\r\n1;E00401503A5BDAE4;12,3;-500\r\n\r\n"
                         "7;e00401503a5bd586;1000,0;2250",
                         "t"),
              twoTags);
}

TEST(TagCsv, readsQuotedFieldsWithCommasInside)
{
    EXPECT_EQ(readTagCsv("\"UID\", X_mm ,y_mm,note,number\n\"E00401503A5BDAE4\",12.3,-500,\"a, b\",1\n"
                         "E00401503A5BD586,1000,2250,,7\n",
                         "t"),
              twoTags);
}

TEST(TagCsv, numbersTagsByTheirPlaceWhenThereIsNoNumber)
{
    const auto tags = readTagCsv("uid,x_mm,y_mm\nA,0,0\nB,0,0\n", "t");
    ASSERT_TRUE(tags);
    EXPECT_EQ((*tags)[1].number, 2);
}

TEST(TagCsv, namesLineAndReasonOfWhatIsWrong)
{
    EXPECT_EQ(tagCsvError(""), "t.csv:1: is empty; expected a header such as uid,x_mm,y_mm,number");
    EXPECT_EQ(tagCsvError("\n\n"), "t.csv:2: is empty; expected a header such as uid,x_mm,y_mm,number");
    EXPECT_EQ(tagCsvError("A,0,0\n"),
              "t.csv:1: the header has no column uid; expected uid,x_mm,y_mm,number (is 'A,0,0')");
    EXPECT_EQ(tagCsvError("uid,x_mm\n"),
              "t.csv:1: the header has no column y_mm; expected uid,x_mm,y_mm,number (is 'uid,x_mm')");
    EXPECT_EQ(tagCsvError("uid,x_mm,y_mm,uid\n"), "t.csv:1: the header has the column uid twice; remove one");
    const std::string header = "uid,x_mm,y_mm,number\nA,0,0,1\n";
    EXPECT_EQ(
        tagCsvError(header + "B,0\n"),
        "t.csv:3: has 2 fields, the header has 4; numbers with a decimal comma need semicolons between the "
        "fields");
    EXPECT_EQ(tagCsvError(header + "XYZ,0,0,1\n"),
              "t.csv:3: uid: must be 1 to 16 hexadecimal digits (is 'XYZ')");
    EXPECT_EQ(tagCsvError(header + "B,wide,0,1\n"),
              "t.csv:3: x_mm: must be a number between -1000000 and 1000000 (is 'wide')");
    for (const char* const bad : {"nan", "inf", "1e9", "", "1.5mm", "0x10"})
        EXPECT_TRUE(
            tagCsvError(header + "B,0," + bad + ",1\n").starts_with("t.csv:3: y_mm: must be a number"))
            << bad;
    EXPECT_EQ(tagCsvError(header + "B,0,0,-1\n"),
              "t.csv:3: number: must be a whole number from 0 to 1000000000 (is '-1')");
    EXPECT_EQ(tagCsvError(header + "\na,0,0,1\n"),
              "t.csv:4: uid: tag 000000000000000A is already in line 2; every tag has its own UID");
    EXPECT_EQ(tagCsvError("uid;x_mm;y_mm\nA;0\n"), "t.csv:2: has 2 fields, the header has 3");
}

TEST(TagCsv, writesWhatItReads)
{
    EXPECT_EQ(writeTagCsv(twoTags), "uid,x_mm,y_mm,number\nE00401503A5BDAE4,12.3,-500,1\n"
                                    "E00401503A5BD586,1000,2250,7\n");
    SplitMix64 random(7);
    std::vector<FloorTag> tags;
    for (int i = 0; i < 2000; ++i)
        tags.push_back({TagUid{random.next()}, {random.uniform(-9, 9), random.normal() * 1e-4}, i});
    EXPECT_EQ(readTagCsv(writeTagCsv(tags), "t"), tags);
}
