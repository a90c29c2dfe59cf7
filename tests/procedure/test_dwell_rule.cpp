// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/dwell_rule.h"

#include <gtest/gtest.h>

namespace agv::procedure {
namespace {

using namespace std::chrono_literals;

constexpr Time dwellBegin{100s};

DwellRule ruleAt(const TurnParameters& parameters = {})
{
    DwellRule rule(parameters);
    rule.begin(dwellBegin);
    return rule;
}

TagRead readAt(Duration after, std::uint64_t uid) { return {dwellBegin + after, TagUid{uid}, 3}; }

TEST(DwellRule, WaitsTheLongestDwellWhenNothingIsRead) { EXPECT_EQ(ruleAt().leaveAt(), dwellBegin + 2s); }

TEST(DwellRule, LeavesAQuietTimeAfterTheLastNewTagWhenEveryTagCameTwice)
{
    DwellRule rule = ruleAt();
    rule.add(readAt(30ms, 1));
    rule.add(readAt(200ms, 2));
    rule.add(readAt(230ms, 1));
    rule.add(readAt(260ms, 2));
    rule.add(readAt(400ms, 2));
    EXPECT_EQ(rule.leaveAt(), dwellBegin + 200ms + DwellRule::quietTime);
}

TEST(DwellRule, WaitsLongerForATagThatShowedOnce)
{
    DwellRule rule = ruleAt();
    rule.add(readAt(30ms, 1));
    rule.add(readAt(60ms, 1));
    rule.add(readAt(90ms, 2));
    EXPECT_EQ(rule.leaveAt(), dwellBegin + 90ms + DwellRule::loneTagTime);
    rule.add(readAt(120ms, 2));
    EXPECT_EQ(rule.leaveAt(), dwellBegin + 90ms + DwellRule::quietTime);
}

TEST(DwellRule, NeverLeavesBeforeTheShortestDwell)
{
    DwellRule rule = ruleAt();
    rule.add(readAt(1ms, 1));
    rule.add(readAt(2ms, 1));
    EXPECT_EQ(rule.leaveAt(), dwellBegin + 300ms);
}

TEST(DwellRule, NeverStaysBeyondTheLongestDwell)
{
    DwellRule rule = ruleAt();
    for (int tag = 0; tag < 60; ++tag)
        rule.add(readAt(tag * 32ms, 1000 + static_cast<unsigned>(tag)));
    EXPECT_EQ(rule.leaveAt(), dwellBegin + 2s);
}

TEST(DwellRule, StaysTheLongestDwellWhenItIsNotAdaptive)
{
    TurnParameters parameters;
    parameters.adaptiveDwell = false;
    DwellRule rule = ruleAt(parameters);
    rule.add(readAt(30ms, 1));
    rule.add(readAt(60ms, 1));
    EXPECT_EQ(rule.leaveAt(), dwellBegin + 2s);
}

TEST(DwellRule, ForgetsTheTagsOfTheStopBefore)
{
    DwellRule rule = ruleAt();
    rule.add(readAt(30ms, 1));
    rule.begin(dwellBegin + 3s);
    EXPECT_EQ(rule.leaveAt(), dwellBegin + 5s);
}

} // namespace
} // namespace agv::procedure
