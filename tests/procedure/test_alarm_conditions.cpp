// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "procedure/alarm_conditions.h"

using namespace agv;
using namespace agv::procedure;

namespace {

/// Two AGVs that have nothing to complain of, and a UWB unit.
PlantSnapshot quiet()
{
    PlantSnapshot snapshot;
    snapshot.time = Time{std::chrono::seconds(100)};
    snapshot.listening = "127.0.0.1:2001 (TCP), 2000 (UDP)";
    for (int robot : {1, 2}) {
        AgvSnapshot& agv = snapshot.agvs.emplace_back();
        agv.id = RobotId{robot};
        agv.readerLink.state = agv.robotLink.state = LinkState::Up;
        agv.robotState = RobotState::Idle;
        agv.battery = BatteryStatus{};
        agv.battery->capacity_Ah = 3.0;
        agv.battery->charge_Ah = 2.4;
        agv.poseHealth = PoseHealth::Tracked;
    }
    snapshot.uwb = UwbSnapshot{};
    snapshot.uwb->link.state = LinkState::Up;
    snapshot.uwb->anchors.emplace_back().id = 3;
    return snapshot;
}

std::vector<AlarmKey> keysOf(const std::vector<AlarmCondition>& conditions)
{
    std::vector<AlarmKey> keys;
    for (const AlarmCondition& condition : conditions)
        keys.push_back(condition.key);
    return keys;
}

using Keys = std::vector<AlarmKey>;

void showTurn(AgvSnapshot& agv, const std::vector<StopReport>& stops)
{
    auto result = std::make_shared<TurnEstimate>();
    result->valid = true;
    result->stops = stops;
    agv.turn.result = result;
}

} // namespace

TEST(AlarmConditions, AQuietPlantHasNone) { EXPECT_EQ(keysOf(AlarmConditions().of(quiet())), Keys{}); }

TEST(AlarmConditions, ALinkThatHasNotBeenUpYetIsNone)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    for (AgvSnapshot& agv : snapshot.agvs)
        agv.readerLink.state = agv.robotLink.state = LinkState::Waiting;
    snapshot.uwb->link.state = LinkState::Failed;
    EXPECT_EQ(keysOf(conditions.of(snapshot)), Keys{});
}

TEST(AlarmConditions, ALinkThatWasUpAndIsNotIsOneUntilTheOperatorClosesIt)
{
    for (const LinkState state : {LinkState::Waiting, LinkState::Opening, LinkState::Failed}) {
        AlarmConditions conditions;
        PlantSnapshot snapshot = quiet();
        conditions.of(snapshot);
        snapshot.agvs[0].readerLink = {};
        snapshot.agvs[0].readerLink.state = state;
        snapshot.agvs[0].readerLink.reason = "why";
        snapshot.agvs[1].robotLink.state = state;
        snapshot.uwb->link.state = state;
        const std::vector<AlarmCondition> found = conditions.of(snapshot);
        EXPECT_EQ(keysOf(found),
                  (Keys{{AlarmKind::RobotLink, 2}, {AlarmKind::ReaderLink, 1}, {AlarmKind::UwbLink, 0}}));
        EXPECT_EQ(found[1].detail, "why");
        for (AgvSnapshot& agv : snapshot.agvs)
            agv.readerLink.state = agv.robotLink.state = LinkState::Down;
        snapshot.uwb->link.state = LinkState::Down;
        EXPECT_EQ(keysOf(conditions.of(snapshot)), Keys{});
        snapshot.agvs[0].readerLink.state = LinkState::Opening; // opened again by hand
        EXPECT_EQ(keysOf(conditions.of(snapshot)), Keys{});
    }
}

TEST(AlarmConditions, ASilentReaderMayStandWhereNoTagIsButASilentRobotOrUnitMayNot)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    conditions.of(snapshot);
    snapshot.agvs[0].readerLink.state = snapshot.agvs[0].robotLink.state = LinkState::Silent;
    snapshot.uwb->link.state = LinkState::Silent;
    EXPECT_EQ(keysOf(conditions.of(snapshot)), (Keys{{AlarmKind::RobotLink, 1}, {AlarmKind::UwbLink, 0}}));
}

TEST(AlarmConditions, TheStateOfARobotCountsOnlyWhileItIsConnected)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    snapshot.agvs[1].robotState = RobotState::Error;
    EXPECT_EQ(keysOf(conditions.of(snapshot)), (Keys{{AlarmKind::RobotError, 2}}));
    snapshot.agvs[1].robotLink.state = LinkState::Down;
    EXPECT_EQ(keysOf(conditions.of(snapshot)), Keys{});
}

TEST(AlarmConditions, ARobotThatMayBeMovingIsToldFirst)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    conditions.of(snapshot);
    snapshot.agvs[1].mayBeMoving = true;
    snapshot.agvs[1].robotLink.state = LinkState::Waiting;
    EXPECT_EQ(keysOf(conditions.of(snapshot)),
              (Keys{{AlarmKind::MayBeMoving, 2}, {AlarmKind::RobotLink, 2}}));
}

TEST(AlarmConditions, ABatteryIsLowUntilItHasBeenChargedSomeWay)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    double& charge = snapshot.agvs[0].battery->charge_Ah;
    const auto isLowAt = [&](double share) {
        charge = 3.0 * share;
        return !conditions.of(snapshot).empty();
    };
    EXPECT_FALSE(isLowAt(0.21));
    EXPECT_TRUE(isLowAt(0.19));
    EXPECT_TRUE(isLowAt(0.24));
    EXPECT_FALSE(isLowAt(0.26));
    EXPECT_FALSE(isLowAt(0.24));
    EXPECT_TRUE(isLowAt(0.1));
    snapshot.agvs[0].battery.reset(); // nothing new is heard: as before
    EXPECT_EQ(keysOf(conditions.of(snapshot)), (Keys{{AlarmKind::BatteryLow, 1}}));
}

TEST(AlarmConditions, ThePoseIsOneWhenItIsDoubtedOrOnlyPredicted)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    snapshot.agvs[0].poseHealth = PoseHealth::Doubted;
    snapshot.agvs[0].poseNote = "pushed";
    snapshot.agvs[1].poseHealth = PoseHealth::Predicted;
    const std::vector<AlarmCondition> found = conditions.of(snapshot);
    EXPECT_EQ(keysOf(found), (Keys{{AlarmKind::PoseDoubted, 1}, {AlarmKind::PosePredicted, 2}}));
    EXPECT_EQ(found[0].detail, "pushed");
}

TEST(AlarmConditions, TagsOfTheLastTurnThatAreMissingOrUnknownAreCountedOnce)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    StopReport first, second;
    first.missed = {TagUid{1}, TagUid{2}, TagUid{3}, TagUid{4}};
    second.missed = {TagUid{1}, TagUid{2}};
    second.seen = {TagUid{4}}; // it is there
    first.unknown = second.unknown = {TagUid{99}};
    showTurn(snapshot.agvs[0], {first, second});
    const std::vector<AlarmCondition> found = conditions.of(snapshot);
    EXPECT_EQ(keysOf(found), (Keys{{AlarmKind::TagsMissing, 1}, {AlarmKind::TagsUnknown, 1}}));
    EXPECT_EQ(found[0].detail, "3");
    EXPECT_EQ(found[1].detail, "1");
    second.seen = {TagUid{4}, TagUid{3}};
    second.unknown = first.unknown = {};
    showTurn(snapshot.agvs[0], {first, second});
    EXPECT_EQ(keysOf(conditions.of(snapshot)), Keys{}) << "two missed tags are no news";
}

TEST(AlarmConditions, AnAnchorThatIsDoubtedIsOne)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    snapshot.uwb->anchors[0].warning = "300 mm off";
    EXPECT_EQ(keysOf(conditions.of(snapshot)), (Keys{{AlarmKind::AnchorMoved, 3}}));
}

TEST(AlarmConditions, AStrangerIsNewsForAMinute)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    conditions.of(snapshot);
    snapshot.refusedPeers = {"10.0.0.9"};
    EXPECT_EQ(keysOf(conditions.of(snapshot)), (Keys{{AlarmKind::Stranger, 0}}));
    snapshot.time += std::chrono::seconds(59);
    EXPECT_EQ(keysOf(conditions.of(snapshot)), (Keys{{AlarmKind::Stranger, 0}}));
    snapshot.time += std::chrono::seconds(2);
    EXPECT_EQ(keysOf(conditions.of(snapshot)), Keys{});
    snapshot.refusedPeers.push_back("10.0.0.10");
    EXPECT_EQ(conditions.of(snapshot).front().detail, "10.0.0.10");
}

TEST(AlarmConditions, APortThatCannotBeOpenedIsOneAndNotYetListeningIsNone)
{
    AlarmConditions conditions;
    PlantSnapshot snapshot = quiet();
    snapshot.listening = "Not listening yet";
    EXPECT_EQ(keysOf(conditions.of(snapshot)), Keys{});
    snapshot.listening = "Not listening: port 2001 is in use";
    EXPECT_EQ(keysOf(conditions.of(snapshot)), (Keys{{AlarmKind::NotListening, 0}}));
}
