// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/alarm_conditions.h"

#include <algorithm>

namespace agv::procedure {
namespace {

std::size_t countOfTags(const TurnEstimate& estimate, std::vector<TagUid> StopReport::* tags)
{
    std::set<TagUid> found;
    for (const StopReport& stop : estimate.stops)
        found.insert((stop.*tags).begin(), (stop.*tags).end());
    return found.size();
}

/// Missed at one stop and read at another one: the tag is there.
std::size_t countOfMissingTags(const TurnEstimate& estimate)
{
    std::set<TagUid> missing;
    for (const StopReport& stop : estimate.stops)
        missing.insert(stop.missed.begin(), stop.missed.end());
    for (const StopReport& stop : estimate.stops) {
        for (const TagUid uid : stop.seen)
            missing.erase(uid);
    }
    return missing.size();
}

} // namespace

std::vector<AlarmCondition> AlarmConditions::of(const PlantSnapshot& snapshot)
{
    std::vector<AlarmCondition> conditions;
    if (snapshot.listening.starts_with("Not listening:"))
        conditions.push_back({{AlarmKind::NotListening, 0}, snapshot.listening});
    for (const AgvSnapshot& agv : snapshot.agvs)
        addAgv(agv, conditions);
    if (snapshot.uwb)
        addUwb(*snapshot.uwb, conditions);
    const std::string stranger = snapshot.refusedPeers.empty() ? std::string() : snapshot.refusedPeers.back();
    if (stranger != m_lastStranger || snapshot.refusedPeers.size() > m_strangers)
        m_strangerCame = snapshot.time;
    m_lastStranger = stranger;
    m_strangers = snapshot.refusedPeers.size();
    if (!stranger.empty() && snapshot.time - m_strangerCame < strangerIsNews)
        conditions.push_back({{AlarmKind::Stranger, 0}, stranger});
    std::ranges::stable_sort(conditions, {},
                             [](const AlarmCondition& condition) { return condition.key.kind; });
    return conditions;
}

void AlarmConditions::addAgv(const AgvSnapshot& agv, std::vector<AlarmCondition>& conditions)
{
    const int robot = agv.id.number;
    const auto add = [&](AlarmKind kind, const std::string& detail) {
        conditions.push_back({{kind, robot}, detail});
    };
    if (agv.mayBeMoving)
        add(AlarmKind::MayBeMoving, agv.robotLink.reason);
    if (agv.robotState == RobotState::Error && isConnected(agv.robotLink))
        add(AlarmKind::RobotError, {});
    addLink({AlarmKind::RobotLink, robot}, agv.robotLink, conditions);
    addLink({AlarmKind::ReaderLink, robot}, agv.readerLink, conditions);
    if (agv.poseHealth == PoseHealth::Doubted)
        add(AlarmKind::PoseDoubted, agv.poseNote);
    if (agv.poseHealth == PoseHealth::Predicted)
        add(AlarmKind::PosePredicted, agv.poseNote);
    if (isBatteryLow(agv))
        add(AlarmKind::BatteryLow, {});
    if (!agv.turn.result || !agv.turn.result->valid)
        return;
    if (const std::size_t missing = countOfMissingTags(*agv.turn.result); missing > mostMissedTags)
        add(AlarmKind::TagsMissing, std::to_string(missing));
    if (const std::size_t unknown = countOfTags(*agv.turn.result, &StopReport::unknown); unknown > 0)
        add(AlarmKind::TagsUnknown, std::to_string(unknown));
}

void AlarmConditions::addUwb(const UwbSnapshot& uwb, std::vector<AlarmCondition>& conditions)
{
    addLink({AlarmKind::UwbLink, 0}, uwb.link, conditions);
    for (const UwbAnchorSnapshot& anchor : uwb.anchors) {
        if (!anchor.warning.empty())
            conditions.push_back({{AlarmKind::AnchorMoved, anchor.id}, anchor.warning});
    }
}

void AlarmConditions::addLink(AlarmKey key, const LinkSnapshot& link, std::vector<AlarmCondition>& conditions)
{
    switch (link.state) {
    case LinkState::Up:
        m_hasBeenUp.insert(key);
        return;
    case LinkState::Down: // closed by the operator
        m_hasBeenUp.erase(key);
        return;
    case LinkState::Silent: // a reader over a floor without tags is silent, too
        if (key.kind == AlarmKind::ReaderLink)
            return;
        break;
    case LinkState::Opening:
    case LinkState::Waiting:
    case LinkState::Failed:
        break;
    }
    if (m_hasBeenUp.contains(key))
        conditions.push_back({key, link.reason});
}

bool AlarmConditions::isBatteryLow(const AgvSnapshot& agv)
{
    const int robot = agv.id.number;
    const bool wasLow = m_lowBatteries.contains(robot);
    if (!agv.battery || agv.battery->capacity_Ah <= 0.0)
        return wasLow;
    const double charge = agv.battery->charge_Ah / agv.battery->capacity_Ah;
    const bool isLow = charge <= (wasLow ? recoveredCharge : lowCharge);
    isLow ? void(m_lowBatteries.insert(robot)) : void(m_lowBatteries.erase(robot));
    return isLow;
}

} // namespace agv::procedure
