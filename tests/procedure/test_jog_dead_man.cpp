// SPDX-License-Identifier: GPL-3.0-or-later
// The dead-man in virtual time, between the cells of its table (test_jog_table.cpp).
#include "core/random.h"
#include "procedure/jog_words.h"
#include "procedure/zero_burst.h"

#include <algorithm>
#include <utility>
#include <vector>

using namespace agv;
using namespace agv::procedure;
using namespace agv::procedure::jog_test;

namespace {

/// What goes over the wire, as the session sends it: drive commands, and a burst of zeros for each Stop.
struct Wire {
    JogDeadMan machine;
    ZeroBurst burst;
    std::vector<std::pair<Time, WheelSpeeds>> sent;

    void perform(JogAction action, Time now)
    {
        if (action == drive) {
            burst.cancel();
            sent.emplace_back(now, machine.speeds());
        } else if (action == stop) {
            sent.emplace_back(now, WheelSpeeds{});
            burst.begin(now);
        }
    }
    /// Every millisecond until `end`.
    void run(Time from, Time end)
    {
        for (Time now = from; now <= end; now += 1ms) {
            perform(machine.onTimer(now), now);
            if (burst.onTimer(now))
                sent.emplace_back(now, WheelSpeeds{});
        }
    }
};

} // namespace

TEST(JogDeadMan, sendsACommandEvery50MsWhileTheHandHolds)
{
    Wire wire;
    wire.perform(wire.machine.press(command(1, start), JogReason::None, start), start);
    for (Time now = start; now < start + 1s; now += 50ms) {
        wire.machine.hold(command(1, now), now);
        wire.run(now + 1ms, now + 50ms);
    }
    ASSERT_EQ(wire.sent.size(), 21u);
    for (std::size_t i = 0; i < wire.sent.size(); ++i) {
        EXPECT_EQ(wire.sent[i].first, start + i * 50ms);
        EXPECT_EQ(wire.sent[i].second, ahead);
    }
}

TEST(JogDeadMan, afterAReleaseZeroIsSaidAtOnceFiveTimesAndThenNothing)
{
    Wire wire;
    wire.perform(wire.machine.press(command(1, start), JogReason::None, start), start);
    wire.run(start, start + 70ms);
    const std::size_t driven = wire.sent.size();
    const Time letGo = start + 71ms;
    wire.perform(wire.machine.release(command(1, letGo), JogReason::Released), letGo);
    wire.run(letGo, letGo + 10min);
    ASSERT_EQ(wire.sent.size(), driven + 5);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(wire.sent[driven + i].first, letGo + i * 50ms);
        EXPECT_EQ(wire.sent[driven + i].second, WheelSpeeds{});
    }
}

TEST(JogDeadMan, aWindowThatIsFrozenForTenSecondsStopsTheAgvAfter250Ms)
{
    Wire wire;
    wire.perform(wire.machine.press(command(1, start), JogReason::None, start), start);
    wire.machine.hold(command(1, start + 30ms), start + 30ms);
    wire.run(start + 31ms, start + 10s);
    std::size_t zeros = 0;
    for (const auto& [time, speeds] : wire.sent) {
        EXPECT_EQ(speeds == WheelSpeeds{}, time >= start + 280ms);
        zeros += speeds == WheelSpeeds{};
    }
    EXPECT_EQ(zeros, 5u);
    EXPECT_EQ(wire.machine.reason(), JogReason::InputOld);
    // It thaws: "still held" of the same press comes again, and drives nothing.
    const Time thaw = start + 10s + 1ms;
    EXPECT_EQ(wire.machine.hold(command(1, thaw), thaw), nothing);
    EXPECT_EQ(wire.machine.onTimer(thaw + 50ms), nothing);
    EXPECT_EQ(wire.machine.release(command(1, thaw), JogReason::Released), nothing);
    EXPECT_EQ(wire.machine.press(command(2, thaw), JogReason::None, thaw), drive);
}

TEST(JogDeadMan, aThreadThatStoodStillStopsTheAgvWhateverItHearsFirst)
{
    const Time late = start + 3s;
    JogDeadMan held = machineIn(driving);
    EXPECT_EQ(held.hold(command(1, late), late), stop);
    EXPECT_EQ(held.state(), spent);
    JogDeadMan timed = machineIn(driving);
    EXPECT_EQ(timed.onTimer(late), stop);
    JogDeadMan released = machineIn(driving);
    EXPECT_EQ(released.release(command(1, late), JogReason::Released), stop);
}

TEST(JogDeadMan, anotherSourceMayDriveOnceTheFirstHandIsSilentForTooLong)
{
    JogDeadMan machine = machineIn(driving);
    const Time late = start + 250ms;
    EXPECT_EQ(machine.press(command(7, late, curve, JogSource::Keys), JogReason::None, late), drive);
    EXPECT_EQ(machine.source(), JogSource::Keys);
    EXPECT_EQ(machine.hold(command(1, late), late), nothing);
    EXPECT_EQ(machine.release(command(1, late), JogReason::Released), nothing);
    EXPECT_EQ(machine.state(), driving);
}

TEST(JogDeadMan, aSecondSourceIsRefusedWithoutDisturbingTheFirst)
{
    JogDeadMan machine = machineIn(driving);
    EXPECT_EQ(machine.press(command(1, soon, curve, JogSource::Keys), JogReason::None, soon), nothing);
    EXPECT_EQ(machine.reason(), JogReason::OtherSource);
    EXPECT_EQ(machine.speeds(), ahead);
    EXPECT_EQ(machine.onTimer(start + 50ms), drive);
    EXPECT_EQ(machine.release(command(1, soon, curve, JogSource::Keys), JogReason::Released), nothing);
    EXPECT_EQ(machine.state(), driving);
}

TEST(JogDeadMan, anObstacleDuringAPressIsToldAndTheHandMustLetGo)
{
    for (const JogReason why : {JogReason::LinkOld, JogReason::LinkLost, JogReason::TurnRuns,
                                JogReason::RobotError, JogReason::StoppedHere}) {
        JogDeadMan machine = machineIn(driving);
        EXPECT_EQ(machine.obstruct(why), stop);
        EXPECT_EQ(machine.reason(), why);
        EXPECT_EQ(machine.hold(command(1, soon), soon), nothing);
        EXPECT_EQ(machine.onTimer(start + 1s), nothing);
        EXPECT_EQ(machine.release(command(1, soon), JogReason::Released), nothing);
        EXPECT_EQ(machine.reason(), why); // it stays to be read
        EXPECT_EQ(machine.press(command(2, soon), JogReason::None, soon), drive);
        EXPECT_EQ(machine.reason(), JogReason::None);
    }
}

TEST(JogDeadMan, whatTookTheHandAwayIsKept)
{
    for (const JogReason why : {JogReason::FocusLost, JogReason::WindowHidden, JogReason::DialogOpened,
                                JogReason::ScreenLocked, JogReason::Suspended, JogReason::Released}) {
        JogDeadMan machine = machineIn(driving);
        EXPECT_EQ(machine.release(command(1, soon), why), stop);
        EXPECT_EQ(machine.reason(), why);
        EXPECT_EQ(machine.hold(command(1, soon), soon), nothing);
        EXPECT_EQ(machine.state(), ready);
    }
}

TEST(JogDeadMan, stopAllIsHeldUntilItIsReleasedAndTheHandHasLetGo)
{
    JogDeadMan machine = machineIn(driving);
    machine.stopAll();
    EXPECT_EQ(machine.hold(command(1, soon), soon), nothing);
    EXPECT_EQ(machine.press(command(2, soon), JogReason::None, soon), nothing);
    EXPECT_EQ(machine.reason(), JogReason::StopAll);
    machine.releaseLatch(); // the hand of press 2 is still on it
    EXPECT_EQ(machine.state(), spent);
    EXPECT_EQ(machine.hold(command(2, soon), soon), nothing);
    EXPECT_EQ(machine.release(command(2, soon), JogReason::Released), nothing);
    EXPECT_EQ(machine.state(), ready);
    EXPECT_EQ(machine.press(command(3, soon), JogReason::None, soon), drive);
}

TEST(JogDeadMan, newSpeedsGoOutWithTheNextCommand)
{
    JogDeadMan machine = machineIn(driving);
    machine.hold(command(1, soon, curve), soon);
    EXPECT_EQ(machine.onTimer(start + 49ms), nothing);
    EXPECT_EQ(machine.onTimer(start + 50ms), drive);
    EXPECT_EQ(machine.speeds(), curve);
}

TEST(JogDeadMan, aLateTimerDoesNotMakeTheCommandsCatchUp)
{
    JogDeadMan machine = machineIn(driving);
    EXPECT_EQ(machine.onTimer(start + 180ms), drive);
    EXPECT_EQ(machine.onTimer(start + 181ms), nothing);
    EXPECT_EQ(machine.deadline(), start + 230ms);
    EXPECT_EQ(machine.onTimer(start + 230ms), drive);
    EXPECT_EQ(machine.deadline(), start + 250ms); // the hand's, now before the next command's
}

TEST(JogDeadMan, anOlderWordDoesNotTakeANewerOneBack)
{
    JogDeadMan machine = machineIn(driving);
    machine.hold(command(1, start + 100ms), start + 100ms);
    machine.hold(command(1, start + 40ms), start + 101ms);
    EXPECT_EQ(machine.onTimer(start + 349ms), drive);
    EXPECT_EQ(machine.onTimer(start + 350ms), stop);
}

TEST(JogDeadMan, whateverHappensInWhateverOrderNoCommandIsOlderThan250MsAndFiveZerosEndThemAll)
{
    SplitMix64 random(20260317);
    int drives = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Wire wire;
        Time now = start;
        Time lastHand = start;
        for (int step = 0; step < 60; ++step) {
            const Time before = now;
            now += std::chrono::milliseconds(1 + random.next() % 120);
            wire.run(before + 1ms, now - 1ms);
            const JogSource source = random.uniform() < 0.3 ? JogSource::Keys : JogSource::Pad;
            const JogCommand said =
                command(1 + std::uint32_t(random.next() % 3),
                        now - std::chrono::milliseconds(random.next() % 300), ahead, source);
            switch (random.next() % 6) {
            case 0:
                wire.perform(wire.machine.press(said, JogReason::None, now), now);
                break;
            case 1:
                wire.perform(wire.machine.release(said, JogReason::Released), now);
                break;
            case 2:
                wire.perform(wire.machine.obstruct(JogReason::TurnRuns), now);
                break;
            default:
                wire.perform(wire.machine.hold(said, now), now);
            }
            lastHand = std::max(lastHand, said.input);
            EXPECT_TRUE(wire.machine.state() != driving || wire.sent.back().first - lastHand < 250ms);
        }
        wire.run(now + 1ms, now + 2s);
        const auto isDrive = [](const auto& sent) { return sent.second != WheelSpeeds{}; };
        const auto last = std::find_if(wire.sent.rbegin(), wire.sent.rend(), isDrive);
        if (last == wire.sent.rend())
            continue;
        ++drives;
        ASSERT_EQ(last - wire.sent.rbegin(), 5);
        EXPECT_LE((last - 1)->first - last->first, 250ms);
    }
    EXPECT_GT(drives, 290);
}
