// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/anchor_geometry.h"

#include <cmath>

using namespace agv;

namespace {

std::vector<UwbAnchor> cornersOfASquare(double z = 0.0)
{
    return {{0, "A0", 0, 0, z, true},
            {1, "A1", 4, 0, z, true},
            {2, "A2", 4, 4, z, true},
            {3, "A3", 0, 4, z, true}};
}

} // namespace

TEST(AnchorGeometry, FourCornersGiveOneErrorOfARangeInTheMiddle)
{
    // Each axis sees two pairs at 45 degrees: J^T J = diag(2, 2), so sqrt(1/2 + 1/2).
    EXPECT_NEAR(horizontalDilution(cornersOfASquare(), {2, 2}, 0.0).value(), 1.0, 1e-12);
}

TEST(AnchorGeometry, AnchorsAboveTheTagSayLessAboutThePlan)
{
    const double low = horizontalDilution(cornersOfASquare(0.3), {2, 2}, 0.3).value();
    const double high = horizontalDilution(cornersOfASquare(2.3), {2, 2}, 0.3).value();
    EXPECT_NEAR(high / low, std::sqrt((8.0 + 4.0) / 8.0), 1e-12);
}

TEST(AnchorGeometry, NoPlaceWithFewerThanTwoAnchorsOrOnTheLineThroughThem)
{
    std::vector<UwbAnchor> two = cornersOfASquare();
    two.resize(2);
    EXPECT_EQ(horizontalDilution(two, {2, 0}, 0.0), std::nullopt);
    EXPECT_EQ(horizontalDilution(two, {2, 0.01}, 0.0), std::nullopt);
    EXPECT_TRUE(horizontalDilution(two, {2, 2}, 0.0).has_value());
    two.resize(1);
    EXPECT_EQ(horizontalDilution(two, {2, 2}, 0.0), std::nullopt);
    EXPECT_EQ(horizontalDilution({}, {2, 2}, 0.0), std::nullopt);
}

TEST(AnchorGeometry, ATagAtAnAnchorIsLocatedByTheOthers)
{
    const auto dilution = horizontalDilution(cornersOfASquare(), {0, 0}, 0.0);
    ASSERT_TRUE(dilution.has_value());
    EXPECT_TRUE(std::isfinite(*dilution));
}
