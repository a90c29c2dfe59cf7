// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json_location.h"

#include <gtest/gtest.h>

using namespace agv;

namespace {

std::string valueAt(std::string_view json, std::string_view pointer, int occurrence = 1)
{
    const auto offset = locateValue(json, pointer, occurrence);
    return offset ? std::string(json.substr(*offset, 3)) : "nothing";
}

} // namespace

TEST(JsonLocation, findsValuesInObjectsAndArrays)
{
    constexpr std::string_view json = R"( {"a": [10, {"b": 200}, [[], 300]], "c": "x]}", "d": 400})";
    EXPECT_EQ(valueAt(json, ""), "{\"a");
    EXPECT_EQ(valueAt(json, "/a/0"), "10,");
    EXPECT_EQ(valueAt(json, "/a/1/b"), "200");
    EXPECT_EQ(valueAt(json, "/a/2/1"), "300");
    EXPECT_EQ(valueAt(json, "/d"), "400");
}

TEST(JsonLocation, findsTheKeyOfAMember)
{
    constexpr std::string_view json = R"({"a": {"long key": 1}})";
    EXPECT_EQ(json.substr(locateKey(json, "/a/long key").value(), 10), "\"long key\"");
    EXPECT_EQ(locateKey("[7, 8]", "/1"), 4U);
}

TEST(JsonLocation, readsEscapesOfPointersAndOfText)
{
    EXPECT_EQ(valueAt(R"({"a/b": 100, "c~d": 200, "": 300})", "/a~1b"), "100");
    EXPECT_EQ(valueAt(R"({"a/b": 100, "c~d": 200, "": 300})", "/c~0d"), "200");
    EXPECT_EQ(valueAt(R"({"a/b": 100, "c~d": 200, "": 300})", "/"), "300");
    EXPECT_EQ(valueAt(R"({"\"\\\n": 100})", "/\"\\\n"), "100");
    EXPECT_EQ(valueAt(R"({"\u00e4\u20ac\ud83d\ude00": 100})", "/\u00e4\u20ac\U0001F600"), "100");
    EXPECT_EQ(pointerToken("a/b~c"), "a~1b~0c");
}

TEST(JsonLocation, countsEqualKeys)
{
    constexpr std::string_view json = R"({"a": 100, "b": {"a": 0}, "a": 200})";
    EXPECT_EQ(valueAt(json, "/a", 2), "200");
    EXPECT_EQ(valueAt(json, "/a", 3), "nothing");
}

TEST(JsonLocation, findsNothingThatIsNotThere)
{
    for (const char* const pointer :
         {"/b", "/a/0", "/c/2", "/c/x", "/c/-1", "/c/0/0", "/c/99999999999999999999"})
        EXPECT_EQ(valueAt(R"({"a": 1, "c": [1, 2]})", pointer), "nothing") << pointer;
    EXPECT_EQ(valueAt("[]", "/0"), "nothing");
}

TEST(JsonLocation, survivesTextsThatAreCutAnywhere)
{
    constexpr std::string_view json = R"({"a": [1, {"b\u00e4\"": [true]}], "c": "x"})";
    for (std::size_t length = 0; length <= json.size(); ++length) {
        for (const char* const pointer : {"/a/1/b\u00e4\"/0", "/c", "/a/5", "/x"}) {
            const auto found = locateValue(json.substr(0, length), pointer);
            EXPECT_LE(found.value_or(0), length);
        }
    }
}

TEST(TextPlace, countsLinesAndCharacters)
{
    constexpr std::string_view text = "ab\n\u00e4\u20acc\n";
    EXPECT_EQ(placeAt(text, 0), (TextPlace{1, 1}));
    EXPECT_EQ(placeAt(text, 3), (TextPlace{2, 1}));
    EXPECT_EQ(placeAt(text, 8), (TextPlace{2, 3}));
    EXPECT_EQ(placeAt(text, 10), (TextPlace{3, 1}));
    EXPECT_EQ(placeAt(text, 1000), (TextPlace{3, 1}));
}
