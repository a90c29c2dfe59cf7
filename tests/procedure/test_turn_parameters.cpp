// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/turn_parameters.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace agv::procedure {
namespace {

TEST(TurnParameters, TheDefaultsAreValid) { EXPECT_TRUE(validate({}).has_value()); }

TEST(TurnParameters, EachBadValueIsNamedWithItsValueAndRange)
{
    struct Case {
        std::function<void(TurnParameters&)> spoil;
        const char* expected;
    };
    const Case cases[] = {
        {[](TurnParameters& p) { p.stopsPerTurn = 9; }, "Number of stops is 9: it must be 8, 12 or 16"},
        {[](TurnParameters& p) { p.turnTime_s = 0.05; },
         "Sleeptime is 50 ms: it must lie between 100 and 10000 ms"},
        {[](TurnParameters& p) { p.turnTime_s = 11.0; },
         "Sleeptime is 11000 ms: it must lie between 100 and 10000 ms"},
        {[](TurnParameters& p) { p.wheelSpeed_m_s = 0.3; },
         "Wheel speed is 300 mm/s: it must lie between 10 and 250 mm/s"},
        {[](TurnParameters& p) { p.wheelSpeed_m_s = -0.1; },
         "Wheel speed is -100 mm/s: it must lie between 10 and 250 mm/s"},
        {[](TurnParameters& p) { p.settle_s = -0.1; },
         "Settling time is -0.1 s: it must lie between 0 and 5 s"},
        {[](TurnParameters& p) { p.minDwell_s = 0.0; },
         "Shortest dwell is 0 s: it must lie between 0.05 and 10 s"},
        {[](TurnParameters& p) { p.maxDwell_s = 0.2; },
         "Longest dwell is 0.2 s: it must lie between 0.3 and 10 s"},
    };
    for (const Case& testCase : cases) {
        TurnParameters parameters;
        testCase.spoil(parameters);
        const Result<void> result = validate(parameters);
        ASSERT_FALSE(result.has_value()) << testCase.expected;
        EXPECT_EQ(result.error().code, ErrorCode::BadInput);
        EXPECT_EQ(result.error().detail, testCase.expected);
    }
}

TEST(TurnParameters, NotANumberIsRefused)
{
    TurnParameters parameters;
    parameters.turnTime_s = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(validate(parameters).has_value());
}

} // namespace
} // namespace agv::procedure
