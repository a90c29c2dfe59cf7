// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ip_address.h"

#include <gtest/gtest.h>

using namespace agv;

TEST(IpAddress, isFourNumbersOrTheFormOfIpv6)
{
    for (const char* const good :
         {"127.0.0.1", "192.168.1.200", "0.0.0.0", "255.255.255.255", "::1", "fe80::1"})
        EXPECT_TRUE(isIpAddress(good)) << good;
    for (const char* const bad : {"", " 127.0.0.1", "127.0.0.1 ", "127.0.0", "127.0.0.256", "127.0.0.1:80",
                                  "localhost", "[::1]", "192.168.1.x", "1"})
        EXPECT_FALSE(isIpAddress(bad)) << bad;
    EXPECT_FALSE(isIpAddress(std::string("127.0.0.1\0x", 11)));
}

TEST(IpAddress, ofARobotFollowsTheRuleOfTheOldProgram)
{
    EXPECT_EQ(usualRobotHost("192.168.1.200", 1), "192.168.1.2");
    EXPECT_EQ(usualRobotHost("127.0.0.1", 8), "127.0.0.9");
    EXPECT_EQ(usualRobotHost("127.0.0.1", 9), std::nullopt);
    EXPECT_EQ(usualRobotHost("127.0.0.1", 0), std::nullopt);
    EXPECT_EQ(usualRobotHost("0.0.0.0", 1), std::nullopt);
    EXPECT_EQ(usualRobotHost("::1", 1), std::nullopt);
    EXPECT_EQ(usualRobotHost("plant-pc", 1), std::nullopt);
}
