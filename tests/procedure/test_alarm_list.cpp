// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "procedure/alarm_list.h"

using namespace agv;
using namespace agv::procedure;
using std::chrono::minutes;
using std::chrono::seconds;

namespace {

constexpr AlarmKey link1{AlarmKind::ReaderLink, 1};
constexpr AlarmKey moving{AlarmKind::MayBeMoving, 2};

/// A list in virtual time: `conditions` hold until they are changed.
class Desk {
public:
    AlarmList list;
    std::vector<AlarmCondition> conditions;

    /// Lets time pass in steps of a snapshot.
    void pass(Duration time)
    {
        for (const Time end = m_now + time; m_now < end;) {
            m_now += std::chrono::milliseconds(200);
            list.update(conditions, m_now, utc());
        }
    }
    void begin(const AlarmKey& key) { conditions.push_back({key, "because"}); }
    void end(const AlarmKey& key)
    {
        std::erase_if(conditions, [&](const AlarmCondition& c) { return c.key == key; });
    }
    Time now() const { return m_now; }
    std::int64_t utc() const
    {
        return std::chrono::duration_cast<std::chrono::milliseconds>(m_now.time_since_epoch()).count();
    }
    std::optional<AlarmSnapshot> find(const AlarmKey& key) const
    {
        for (const AlarmSnapshot& alarm : list.snapshot(m_now)) {
            if (alarm.key == key)
                return alarm;
        }
        return {};
    }
    std::optional<AlarmState> stateOf(const AlarmKey& key) const
    {
        const auto alarm = find(key);
        return alarm ? std::optional(alarm->state) : std::nullopt;
    }
    /// An alarm in each state of the table; nullopt: only just begun.
    static Desk in(std::optional<AlarmState> state)
    {
        Desk desk;
        desk.begin(link1);
        desk.pass(state ? seconds(10) : seconds(1));
        if (state == AlarmState::Acknowledged)
            desk.list.acknowledge(link1);
        if (state == AlarmState::Shelved)
            desk.list.shelve(link1, minutes(10), desk.now());
        if (state == AlarmState::Returned) {
            desk.end(link1);
            desk.pass(seconds(10));
        }
        return desk;
    }

private:
    Time m_now{seconds(1000)};
};

constexpr std::optional<AlarmState> none;

} // namespace

TEST(AlarmList, RaisesAConditionThatHasHeldForItsDelay)
{
    Desk desk;
    desk.begin(link1);
    desk.pass(seconds(2));
    EXPECT_EQ(desk.stateOf(link1), none);
    desk.pass(seconds(2));
    ASSERT_EQ(desk.stateOf(link1), AlarmState::Unacknowledged);
    EXPECT_EQ(desk.find(link1)->detail, "because");
    EXPECT_TRUE(desk.find(link1)->holds);
}

TEST(AlarmList, IgnoresAConditionThatIsGoneBeforeItsDelay)
{
    Desk desk = Desk::in(none);
    desk.end(link1);
    desk.pass(minutes(1));
    EXPECT_EQ(desk.stateOf(link1), none);
    desk.begin(link1); // its time begins anew
    desk.pass(seconds(2));
    EXPECT_EQ(desk.stateOf(link1), none);
}

TEST(AlarmList, RaisesARobotThatMayBeMovingAtOnce)
{
    Desk desk;
    desk.begin(moving);
    desk.pass(std::chrono::milliseconds(200));
    EXPECT_EQ(desk.stateOf(moving), AlarmState::Unacknowledged);
    EXPECT_EQ(desk.find(moving)->priority, AlarmPriority::High);
}

TEST(AlarmList, AnAcknowledgedAlarmLeavesWhenItsConditionHasGone)
{
    Desk desk = Desk::in(AlarmState::Acknowledged);
    desk.pass(minutes(30));
    EXPECT_EQ(desk.stateOf(link1), AlarmState::Acknowledged);
    desk.end(link1);
    desk.pass(seconds(2));
    EXPECT_EQ(desk.stateOf(link1), AlarmState::Acknowledged) << "not before its return delay";
    desk.pass(seconds(2));
    EXPECT_EQ(desk.stateOf(link1), none);
}

TEST(AlarmList, AnAlarmThatNobodySawStaysAfterItsConditionHasGone)
{
    Desk desk = Desk::in(AlarmState::Unacknowledged);
    desk.end(link1);
    desk.pass(minutes(30));
    ASSERT_EQ(desk.stateOf(link1), AlarmState::Returned);
    EXPECT_FALSE(desk.find(link1)->holds);
    EXPECT_TRUE(desk.list.acknowledge(link1));
    EXPECT_EQ(desk.stateOf(link1), none);
}

TEST(AlarmList, AnAlarmThatComesAgainIsNewAgainAndCounted)
{
    Desk desk = Desk::in(AlarmState::Returned);
    const std::int64_t first = desk.find(link1)->raised_utc_ms;
    desk.begin(link1);
    desk.pass(seconds(4));
    ASSERT_EQ(desk.stateOf(link1), AlarmState::Unacknowledged);
    EXPECT_EQ(desk.find(link1)->occurrences, 2);
    EXPECT_GT(desk.find(link1)->raised_utc_ms, first);
}

TEST(AlarmList, AConditionThatFlickersWithinItsReturnDelayIsOneAlarm)
{
    Desk desk = Desk::in(AlarmState::Acknowledged);
    for (int i = 0; i < 20; ++i) {
        desk.end(link1);
        desk.pass(seconds(2));
        desk.begin(link1);
        desk.pass(seconds(1));
    }
    EXPECT_EQ(desk.stateOf(link1), AlarmState::Acknowledged);
    EXPECT_EQ(desk.find(link1)->occurrences, 1);
}

TEST(AlarmList, AShelvedAlarmComesBackWhenItsTimeIsOverAndItStillHolds)
{
    Desk desk = Desk::in(AlarmState::Shelved);
    desk.pass(minutes(4));
    ASSERT_EQ(desk.stateOf(link1), AlarmState::Shelved);
    EXPECT_NEAR(desk.find(link1)->shelvedFor_s.value(), 360.0, 1.0);
    desk.pass(minutes(7));
    EXPECT_EQ(desk.stateOf(link1), AlarmState::Unacknowledged);
    EXPECT_EQ(desk.find(link1)->shelvedFor_s, std::nullopt);
}

TEST(AlarmList, AShelvedAlarmWhoseConditionHasGoneLeavesWhenItsTimeIsOver)
{
    Desk desk = Desk::in(AlarmState::Shelved);
    desk.end(link1);
    desk.pass(minutes(4));
    EXPECT_EQ(desk.stateOf(link1), AlarmState::Shelved);
    desk.pass(minutes(7));
    EXPECT_EQ(desk.stateOf(link1), none);
}

TEST(AlarmList, AShelvedAlarmCanBeBroughtBack)
{
    Desk desk = Desk::in(AlarmState::Shelved);
    EXPECT_TRUE(desk.list.unshelve(link1, desk.utc()));
    EXPECT_EQ(desk.stateOf(link1), AlarmState::Unacknowledged);
    desk = Desk::in(AlarmState::Shelved);
    desk.end(link1);
    desk.pass(seconds(10));
    EXPECT_TRUE(desk.list.unshelve(link1, desk.utc()));
    EXPECT_EQ(desk.stateOf(link1), none);
}

TEST(AlarmList, NoHighAlarmAndNoTimeWithoutAnEndIsShelved)
{
    Desk desk = Desk::in(AlarmState::Unacknowledged);
    desk.begin(moving);
    desk.pass(seconds(1));
    EXPECT_FALSE(desk.list.shelve(moving, minutes(10), desk.now()));
    EXPECT_FALSE(desk.list.shelve(link1, Duration{}, desk.now()));
    EXPECT_FALSE(desk.list.shelve(link1, AlarmList::longestShelf + seconds(1), desk.now()));
    EXPECT_EQ(desk.stateOf(link1), AlarmState::Unacknowledged);
    EXPECT_EQ(desk.stateOf(moving), AlarmState::Unacknowledged);
}

TEST(AlarmList, WhatIsSaidInTheWrongStateChangesNothing)
{
    const std::optional<AlarmState> states[] = {none, AlarmState::Unacknowledged, AlarmState::Acknowledged,
                                                AlarmState::Returned, AlarmState::Shelved};
    for (const auto& state : states) {
        Desk desk = Desk::in(state);
        const bool mayAcknowledge = state == AlarmState::Unacknowledged || state == AlarmState::Returned;
        EXPECT_EQ(desk.list.acknowledge(link1), mayAcknowledge);
        EXPECT_EQ(Desk::in(state).list.shelve(link1, minutes(1), desk.now()), state.has_value());
        EXPECT_EQ(Desk::in(state).list.unshelve(link1, 0), state == AlarmState::Shelved);
        EXPECT_FALSE(desk.list.acknowledge({AlarmKind::ReaderLink, 9}));
    }
}

TEST(AlarmList, ShowsTheWeightiestFirstThenTheNewestAndTheShelvedLast)
{
    Desk desk;
    const AlarmKey low{AlarmKind::Stranger, 0};
    const AlarmKey link2{AlarmKind::ReaderLink, 2};
    desk.begin(low);
    desk.begin(link1);
    desk.pass(seconds(10));
    desk.begin(link2);
    desk.pass(seconds(10));
    desk.begin(moving);
    desk.pass(seconds(10));
    const auto keys = [&] {
        std::vector<AlarmKey> order;
        for (const AlarmSnapshot& alarm : desk.list.snapshot(desk.now()))
            order.push_back(alarm.key);
        return order;
    };
    EXPECT_EQ(keys(), (std::vector<AlarmKey>{moving, link2, link1, low}));
    desk.list.shelve(link2, minutes(10), desk.now());
    EXPECT_EQ(keys(), (std::vector<AlarmKey>{moving, link1, low, link2}));
}

TEST(AlarmList, AFloodHoldsNewAlarmsOfLowPriorityBackUntilItIsOver)
{
    Desk desk;
    for (int robot = 1; robot <= 11; ++robot)
        desk.begin({AlarmKind::ReaderLink, robot});
    desk.pass(seconds(5));
    EXPECT_TRUE(desk.list.isFlooded());
    const AlarmKey low{AlarmKind::TagsMissing, 1};
    desk.begin(low);
    desk.begin(moving);
    desk.pass(seconds(5));
    EXPECT_TRUE(desk.find(low)->heldBack);
    EXPECT_FALSE(desk.find(moving)->heldBack);
    desk.pass(minutes(11));
    EXPECT_FALSE(desk.list.isFlooded());
    EXPECT_FALSE(desk.find(low)->heldBack);
    EXPECT_EQ(desk.stateOf(low), AlarmState::Unacknowledged);
}

TEST(AlarmList, EveryKindHasARuleThatLetsItReturn)
{
    for (int kind = 0; kind <= static_cast<int>(AlarmKind::Stranger); ++kind) {
        const AlarmRule rule = ruleOf(static_cast<AlarmKind>(kind));
        EXPECT_GE(rule.returnAfter, seconds(2)) << kind;
        EXPECT_LE(rule.raiseAfter, seconds(5)) << kind;
    }
}
