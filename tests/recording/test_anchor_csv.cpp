// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/anchor_csv.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::recording;

namespace {

std::string anchorCsvError(std::string_view text)
{
    const auto anchors = readAnchorCsv(text);
    EXPECT_FALSE(anchors.has_value());
    return anchors ? std::string() : anchors.error().detail;
}

} // namespace

TEST(AnchorCsv, readsPlacesAndIgnoresOtherColumns)
{
    const auto anchors =
        readAnchorCsv("session,anchor,x_m,y_m,z_m\n8_14,0,-3.4203,3.0053,1.0442\n8_14,105,0,1,2\n");
    ASSERT_TRUE(anchors.has_value());
    EXPECT_EQ((*anchors)[0], (UwbAnchor{0, "A0", -3.4203, 3.0053, 1.0442, true}));
    EXPECT_EQ((*anchors)[1], (UwbAnchor{105, "A105", 0.0, 1.0, 2.0, true}));
}

TEST(AnchorCsv, isTheSameAfterWriting)
{
    const std::vector<UwbAnchor> anchors{{0, "north, left", 0.1 + 0.2, -2.0, 1.3, true},
                                         {7, "A7", 1.0, 2.0, 3.0, false}};
    EXPECT_EQ(readAnchorCsv(writeAnchorCsv(anchors)), anchors);
}

TEST(AnchorCsv, saysWhatIsWrongInWhichLine)
{
    EXPECT_EQ(anchorCsvError("anchor,x_m,y_m\n0,1,2\n"),
              "1: the header has no column z_m; expected anchor,x_m,y_m,z_m");
    EXPECT_EQ(anchorCsvError("x_m,y_m,z_m\n"),
              "1: the header has no column anchor; expected anchor,x_m,y_m,z_m");
    EXPECT_EQ(anchorCsvError("anchor,x_m,y_m,z_m\n"), "1: has no anchor below the header");
    EXPECT_EQ(anchorCsvError("anchor,x_m,y_m,z_m\n0,1,2,3\n0,1,2,3\n"),
              "3: anchor: 0 is already in line 2; every anchor has its own id");
    EXPECT_EQ(anchorCsvError("anchor,x_m,y_m,z_m\n256,1,2,3\n"),
              "2: anchor: must be a whole number from 0 to 255 (is '256')");
    EXPECT_EQ(anchorCsvError("anchor,x_m,y_m,z_m\n1,1,,3\n"),
              "2: y_m: must be a number from -1000 to 1000 (is '')");
    EXPECT_EQ(anchorCsvError("anchor,x_m,y_m,z_m,shown\n1,1,2,3,yes\n"),
              "2: shown: must be 1 or 0 (is 'yes')");
}
