// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/link_life.h"

#include <gtest/gtest.h>

namespace agv::procedure {
namespace {

using namespace std::chrono_literals;

constexpr Time t0{500s};

LinkLife connectedLife()
{
    LinkLife life;
    EXPECT_EQ(life.open(t0), LinkAction::Open);
    EXPECT_EQ(life.connected(t0), LinkAction::None);
    EXPECT_EQ(life.state(), LinkState::Up);
    return life;
}

/// Serves the next deadline and returns its time.
Time serve(LinkLife& life, LinkAction expected)
{
    const Time at = life.deadline().value();
    EXPECT_EQ(life.onTimer(at), expected);
    return at;
}

TEST(LinkLife, IsDownUntilItIsOpened)
{
    LinkLife life;
    EXPECT_EQ(life.state(), LinkState::Down);
    EXPECT_FALSE(life.deadline().has_value());
    EXPECT_EQ(life.connected(t0), LinkAction::None);
    EXPECT_EQ(life.data(t0), LinkAction::None);
    EXPECT_EQ(life.failed(true, "x", t0), LinkAction::None);
    EXPECT_EQ(life.onTimer(t0), LinkAction::None);
    EXPECT_EQ(life.close(), LinkAction::None);
    EXPECT_EQ(life.state(), LinkState::Down);
}

TEST(LinkLife, GivesUpAConnectionThatIsNotMadeWithinThreeSeconds)
{
    LinkLife life;
    life.open(t0);
    EXPECT_EQ(serve(life, LinkAction::Close), t0 + 3s);
    EXPECT_EQ(life.state(), LinkState::Waiting);
    EXPECT_EQ(life.retryAt(), t0 + 3500ms);
    EXPECT_NE(life.reason(), "");
}

TEST(LinkLife, BacksOffHalfASecondThenOneTwoFive)
{
    LinkLife life;
    life.open(t0);
    Time now = t0;
    for (const Duration pause : {Duration(500ms), Duration(1s), Duration(2s), Duration(5s), Duration(5s)}) {
        EXPECT_EQ(life.failed(true, "refused", now), LinkAction::Close);
        EXPECT_EQ(life.reason(), "refused");
        EXPECT_EQ(life.retryAt(), now + pause);
        EXPECT_EQ(life.onTimer(now + pause - 1ms), LinkAction::None);
        now = serve(life, LinkAction::Open);
        EXPECT_EQ(life.state(), LinkState::Opening);
        EXPECT_FALSE(life.retryAt().has_value());
    }
}

TEST(LinkLife, DataResetsTheBackOffButAConnectionAloneDoesNot)
{
    LinkLife life;
    life.open(t0);
    life.failed(true, "refused", t0);
    Time now = serve(life, LinkAction::Open);
    life.connected(now);
    life.failed(true, "closed", now);
    EXPECT_EQ(life.retryAt(), now + 1s);
    now = serve(life, LinkAction::Open);
    life.connected(now);
    life.data(now);
    life.failed(true, "closed", now);
    EXPECT_EQ(life.retryAt(), now + 500ms);
}

TEST(LinkLife, FallsSilentAfterTwoSecondsAndIsRemadeWithinFive)
{
    LinkLife life = connectedLife();
    life.data(t0 + 1s);
    EXPECT_EQ(serve(life, LinkAction::None), t0 + 3s);
    EXPECT_EQ(life.state(), LinkState::Silent);
    EXPECT_TRUE(life.isConnected());
    EXPECT_EQ(serve(life, LinkAction::Close), t0 + 5500ms);
    EXPECT_EQ(life.state(), LinkState::Waiting);
    EXPECT_TRUE(life.isMute());
    EXPECT_EQ(life.lastData(), t0 + 1s);
}

TEST(LinkLife, DataEndsTheSilence)
{
    LinkLife life = connectedLife();
    serve(life, LinkAction::None);
    EXPECT_EQ(life.state(), LinkState::Silent);
    life.data(t0 + 3s);
    EXPECT_EQ(life.state(), LinkState::Up);
    EXPECT_EQ(life.reason(), "");
    EXPECT_EQ(life.deadline(), t0 + 5s);
}

TEST(LinkLife, AConnectionRemadeForItsSilenceStaysSilentUntilDataComes)
{
    LinkLife life = connectedLife();
    for (int round = 0; round < 3; ++round) {
        while (life.state() != LinkState::Opening)
            life.onTimer(life.deadline().value());
        const Time now = life.deadline().value() - 3s;
        life.connected(now);
        EXPECT_EQ(life.state(), LinkState::Silent);
        EXPECT_NE(life.reason().find("still nothing"), std::string::npos);
        EXPECT_EQ(life.deadline(), now + 20s);
    }
    life.data(life.deadline().value() - 1s);
    EXPECT_EQ(life.state(), LinkState::Up);
    EXPECT_FALSE(life.isMute());
}

TEST(LinkLife, AnIdleReaderIsAwayForNoMoreThanHalfASecondInTwenty)
{
    LinkLife life = connectedLife();
    Time connectedAt = t0;
    for (const Duration patience : {Duration(4500ms), Duration(20s), Duration(20s)}) {
        while (life.state() != LinkState::Waiting)
            life.onTimer(life.deadline().value());
        EXPECT_EQ(life.retryAt(), connectedAt + patience + 500ms);
        connectedAt = serve(life, LinkAction::Open);
        life.connected(connectedAt);
    }
}

TEST(LinkLife, ARealFailureEndsTheMuteState)
{
    LinkLife life = connectedLife();
    while (life.state() != LinkState::Opening)
        life.onTimer(life.deadline().value());
    life.failed(true, "refused", t0 + 6s);
    EXPECT_FALSE(life.isMute());
}

TEST(LinkLife, APersistentFailureWaitsForTheOperator)
{
    for (const bool wasConnected : {false, true}) {
        LinkLife life;
        life.open(t0);
        if (wasConnected)
            life.connected(t0);
        EXPECT_EQ(life.failed(false, "unknown host", t0), LinkAction::Close);
        EXPECT_EQ(life.state(), LinkState::Failed);
        EXPECT_FALSE(life.deadline().has_value());
        EXPECT_EQ(life.reason(), "unknown host");
        EXPECT_EQ(life.open(t0), LinkAction::Open);
        EXPECT_EQ(life.reason(), "");
    }
}

TEST(LinkLife, CloseEndsEveryState)
{
    LinkLife opening;
    opening.open(t0);
    LinkLife up = connectedLife();
    LinkLife silent = connectedLife();
    serve(silent, LinkAction::None);
    LinkLife waiting = connectedLife();
    waiting.failed(true, "cut", t0);
    LinkLife failedLife = connectedLife();
    failedLife.failed(false, "bad", t0);
    for (LinkLife* life : {&opening, &up, &silent, &waiting, &failedLife}) {
        EXPECT_EQ(life->close(), LinkAction::Close);
        EXPECT_EQ(life->state(), LinkState::Down);
        EXPECT_FALSE(life->deadline().has_value());
        EXPECT_EQ(life->reason(), "");
    }
}

TEST(LinkLife, TheOperatorNeedNotWaitForTheBackOff)
{
    LinkLife life = connectedLife();
    life.failed(true, "cut", t0);
    EXPECT_EQ(life.open(t0 + 1ms), LinkAction::Open);
    EXPECT_EQ(life.open(t0 + 2ms), LinkAction::None);
}

} // namespace
} // namespace agv::procedure
