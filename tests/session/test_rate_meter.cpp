// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/rate_meter.h"

#include <gtest/gtest.h>

namespace agv::session {
namespace {

using namespace std::chrono_literals;

TEST(RateMeter, AveragesOverTwoSecondsAndForgetsWhatIsOlder)
{
    RateMeter rate;
    const Time start{100s};
    for (int i = 0; i < 100; ++i)
        rate.add(start + i * 50ms);
    EXPECT_NEAR(rate.perSecond(start + 5s), 20.0, 1.0);
    EXPECT_EQ(rate.perSecond(start + 10s), 0.0);
}

} // namespace
} // namespace agv::session
