// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/trek_config.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::recording;

namespace {

TrekAnchorConfig anchorsOf(std::string_view text)
{
    auto config = readTrekAnchorConfig(text);
    EXPECT_TRUE(config.has_value()) << (config ? "" : config.error().detail);
    return config.value_or(TrekAnchorConfig{});
}

TrekTagConfig tagsOf(std::string_view text)
{
    auto config = readTrekTagConfig(text);
    EXPECT_TRUE(config.has_value()) << (config ? "" : config.error().detail);
    return config.value_or(TrekTagConfig{});
}

} // namespace

TEST(TrekAnchorConfig, readsPlacesInMetresAndCorrectionsInCentimetres)
{
    const TrekAnchorConfig config = anchorsOf(
        "<config>\n <anc ID=\"0\" label=\"A0\" x=\"0\" y=\"0\" z=\"2\" t0=\"0\" t1=\"-12\" t7=\"3.5\"/>\n"
        " <anc y=\"0.5\" x=\"5\" ID=\"3\" label=\"Tor &amp; &#xE4;\"/>\n</config>\n");
    ASSERT_EQ(config.anchors.size(), 2U);
    EXPECT_EQ(config.anchors[0], (UwbAnchor{0, "A0", 0.0, 0.0, 2.0, true}));
    EXPECT_EQ(config.anchors[1], (UwbAnchor{3, "Tor & \xC3\xA4", 5.0, 0.5, 0.0, true}));
    ASSERT_EQ(config.corrections.size(), 2U);
    EXPECT_EQ(config.corrections[0], (RangeCorrection{0, 1, -0.12}));
    EXPECT_EQ(config.corrections[1], (RangeCorrection{0, 7, 0.035}));
}

TEST(TrekAnchorConfig, namesTheLineOfABadAnchorAndGoesOn)
{
    const TrekAnchorConfig config =
        anchorsOf("<config>\n<anc ID=\"0\" x=\"wide\"/>\n<anc x=\"1\"/>\n<anc ID=\"1\"/>\n"
                  "<anc ID=\"1\"/>\n<anc ID=\"2\" t3=\"1e9\"/>\n</config>");
    ASSERT_EQ(config.anchors.size(), 1U);
    EXPECT_EQ(config.anchors[0].label, "A1");
    ASSERT_EQ(config.problems.count(), 4U);
    EXPECT_EQ(problemText("a.xml", config.problems.kept()[0]),
              "a.xml:2: <anc>: x must be a number within +-1000 (is 'wide')");
    EXPECT_EQ(config.problems.kept()[1].line, 3);
    EXPECT_EQ(config.problems.kept()[2].line, 5);
    EXPECT_EQ(config.problems.kept()[3].line, 6);
}

TEST(TrekAnchorConfig, refusesWhatIsNoXmlOrNotOfItsKindWithTheLine)
{
    EXPECT_TRUE(
        readTrekAnchorConfig("<config>\n<anc ID=\"0\"\n").error().detail.starts_with("3: is not XML") ||
        readTrekAnchorConfig("<config>\n<anc ID=\"0\"\n").error().detail.starts_with("2: is not XML"));
    for (const char* const text :
         {"", "hello", "<plant/>", "<config/>", "<config><tag ID=\"1\"/></config>"}) {
        const auto config = readTrekAnchorConfig(text);
        ASSERT_FALSE(config.has_value()) << text;
        EXPECT_EQ(config.error().code, ErrorCode::BadInput);
        EXPECT_TRUE(config.error().detail.starts_with("1: ")) << config.error().detail;
    }
}

TEST(TrekAnchorConfig, isTheSameAfterWriting)
{
    const std::vector<UwbAnchor> anchors{{0, "A0", 0.1, -2.5, 1.3, true},
                                         {3, "<\"T&r\">", 5.0, 0.0, 1.7, true}};
    const std::vector<RangeCorrection> corrections{{0, 1, -0.12}, {3, 0, 0.035}};
    const TrekAnchorConfig config = anchorsOf(writeTrekAnchorConfig(anchors, corrections));
    EXPECT_EQ(config.anchors, anchors);
    EXPECT_EQ(config.corrections, corrections);
    EXPECT_TRUE(config.problems.empty());
}

TEST(TrekTagConfig, readsHexadecimalIds)
{
    const TrekTagConfig config =
        tagsOf("<config><tag_cfg size=\"0.25\" history=\"30\"/><tag ID=\"5\" label=\"Tag 5\"/>"
               "<tag ID=\"1f\" label=\"AGV\"/></config>");
    EXPECT_DOUBLE_EQ(config.drawnSize_m, 0.25);
    EXPECT_EQ(config.history, 30);
    EXPECT_EQ(config.tags, (std::vector<TrekTag>{{5, "Tag 5"}, {31, "AGV"}}));
}

TEST(TrekTagConfig, keepsItsDefaultsWhereTheSettingsAreBad)
{
    const TrekTagConfig config = tagsOf(
        "<config>\n<tag_cfg size=\"big\" history=\"-1\"/>\n<tag ID=\"xyz\"/>\n<tag ID=\"2\"/></config>");
    EXPECT_DOUBLE_EQ(config.drawnSize_m, 0.15);
    EXPECT_EQ(config.history, 20);
    EXPECT_EQ(config.tags, (std::vector<TrekTag>{{2, "Tag 2"}}));
    ASSERT_EQ(config.problems.count(), 2U);
    EXPECT_EQ(config.problems.kept()[1].line, 3);
}

TEST(TrekTagConfig, isTheSameAfterWriting)
{
    TrekTagConfig config{0.2, 15, {{0, "T0"}, {255, "last"}}, {}};
    const TrekTagConfig again = tagsOf(writeTrekTagConfig(config));
    EXPECT_EQ(again.tags, config.tags);
    EXPECT_DOUBLE_EQ(again.drawnSize_m, 0.2);
    EXPECT_EQ(again.history, 15);
}
