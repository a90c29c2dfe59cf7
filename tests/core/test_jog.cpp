// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/jog.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace agv;

TEST(JogSpeeds, arrowsDriveTheWheelsTheyPointTo)
{
    EXPECT_EQ(jogSpeeds({1, 0}, 0.1), (WheelSpeeds{0.1, 0.1}));
    EXPECT_EQ(jogSpeeds({-1, 0}, 0.1), (WheelSpeeds{-0.1, -0.1}));
    EXPECT_EQ(jogSpeeds({0, 1}, 0.1), (WheelSpeeds{-0.1, 0.1})); // counter-clockwise
    EXPECT_EQ(jogSpeeds({0, -1}, 0.1), (WheelSpeeds{0.1, -0.1}));
    EXPECT_EQ(jogSpeeds({0, 0}, 0.1), WheelSpeeds{});
}

TEST(JogSpeeds, inACurveTheWheelOnTheSideOfTheArrowIsTheSlowOneAheadAndBack)
{
    for (const int forward : {1, -1}) {
        const WheelSpeeds left = jogSpeeds({forward, 1}, 0.1);
        EXPECT_NEAR(left.left, forward * 0.04, 1e-12);
        EXPECT_EQ(left.right, forward * 0.1);
        const WheelSpeeds right = jogSpeeds({forward, -1}, 0.1);
        EXPECT_EQ(right.left, forward * 0.1);
        EXPECT_NEAR(right.right, forward * 0.04, 1e-12);
    }
    // The centre's circle: half the track times sum over difference.
    const WheelSpeeds curve = jogSpeeds({1, 1}, 0.1);
    EXPECT_NEAR(0.2865 / 2 * (curve.right + curve.left) / (curve.right - curve.left), 0.334, 0.001);
}

TEST(JogSpeeds, aLimitSlowsBothWheelsAndKeepsTheCurve)
{
    const WheelSpeeds slow = slowedTo({0.4, -0.2}, 0.1);
    EXPECT_NEAR(slow.left, 0.1, 1e-12);
    EXPECT_NEAR(slow.right, -0.05, 1e-12);
    EXPECT_EQ(slowedTo({0.1, 0.04}, 0.1), (WheelSpeeds{0.1, 0.04}));
    EXPECT_EQ(slowedTo({0.1, 0.1}, 0.0), WheelSpeeds{});
}

TEST(JogSpeeds, speedsThatAreNoNumbersDriveNothing)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(slowedTo({nan, 0.1}, 0.25), WheelSpeeds{});
    EXPECT_EQ(slowedTo({0.1, -infinite}, 0.25), WheelSpeeds{});
}
