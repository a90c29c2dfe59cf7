// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/alarm_list.h"

#include <algorithm>
#include <iterator>

namespace agv::procedure {

using std::chrono::seconds;

AlarmRule ruleOf(AlarmKind kind)
{
    switch (kind) {
    case AlarmKind::MayBeMoving:
    case AlarmKind::RobotError:
        return {AlarmPriority::High, Duration{}, seconds(2)};
    case AlarmKind::NotListening:
        return {AlarmPriority::High, seconds(3), seconds(2)};
    case AlarmKind::RobotLink:
    case AlarmKind::ReaderLink:
    case AlarmKind::UwbLink:
        return {AlarmPriority::Medium, seconds(3), seconds(3)};
    case AlarmKind::PoseDoubted:
        return {AlarmPriority::Medium, seconds(1), seconds(2)};
    case AlarmKind::BatteryLow:
        return {AlarmPriority::Medium, seconds(5), seconds(5)};
    case AlarmKind::AnchorMoved:
        return {AlarmPriority::Medium, seconds(2), seconds(5)};
    case AlarmKind::PosePredicted:
        return {AlarmPriority::Low, seconds(5), seconds(2)};
    case AlarmKind::TagsMissing:
    case AlarmKind::TagsUnknown:
    case AlarmKind::Stranger:
        return {AlarmPriority::Low, Duration{}, seconds(2)};
    }
    return {};
}

void AlarmList::update(const std::vector<AlarmCondition>& conditions, Time now, std::int64_t utc_ms)
{
    while (!m_raised.empty() && now - m_raised.front() > floodWindow)
        m_raised.pop_front();
    const auto holdsNow = [&conditions](const AlarmKey& key) {
        return std::ranges::find(conditions, key, &AlarmCondition::key) != conditions.end();
    };
    for (auto& [key, alarm] : m_alarms) {
        if (alarm.holds && !holdsNow(key)) {
            alarm.holds = false;
            alarm.since = now;
        }
    }
    for (const AlarmCondition& condition : conditions) {
        Alarm& alarm = m_alarms[condition.key];
        alarm.shown.key = condition.key;
        alarm.shown.detail = condition.detail;
        if (!alarm.holds) {
            alarm.holds = true;
            alarm.since = now;
        }
    }
    for (auto entry = m_alarms.begin(); entry != m_alarms.end();)
        entry = advance(entry->second, now, utc_ms) ? m_alarms.erase(entry) : std::next(entry);
}

bool AlarmList::advance(Alarm& alarm, Time now, std::int64_t utc_ms)
{
    const AlarmRule rule = ruleOf(alarm.shown.key.kind);
    AlarmState& state = alarm.shown.state;
    if (alarm.isListed && state == AlarmState::Shelved)
        return now >= alarm.shelvedUntil && leaveShelf(alarm, utc_ms);
    if (!isFlooded())
        alarm.shown.heldBack = false;
    if (alarm.holds) {
        const bool isNew = !alarm.isListed || state == AlarmState::Returned;
        if (isNew && now - alarm.since >= rule.raiseAfter)
            raise(alarm, now, utc_ms);
        return false;
    }
    if (!alarm.isListed)
        return true; // too short to be raised
    if (now - alarm.since < rule.returnAfter)
        return false;
    if (state == AlarmState::Unacknowledged)
        state = AlarmState::Returned;
    return state == AlarmState::Acknowledged;
}

void AlarmList::raise(Alarm& alarm, Time now, std::int64_t utc_ms)
{
    m_raised.push_back(now);
    AlarmSnapshot& shown = alarm.shown;
    shown.occurrences = alarm.isListed ? shown.occurrences + 1 : 1;
    shown.priority = ruleOf(shown.key.kind).priority;
    shown.state = AlarmState::Unacknowledged;
    shown.raised_utc_ms = utc_ms;
    shown.heldBack = isFlooded() && shown.priority == AlarmPriority::Low;
    alarm.isListed = true;
}

bool AlarmList::leaveShelf(Alarm& alarm, std::int64_t utc_ms)
{
    if (!alarm.holds)
        return true;
    alarm.shown.state = AlarmState::Unacknowledged;
    alarm.shown.raised_utc_ms = utc_ms;
    return false;
}

bool AlarmList::acknowledge(const AlarmKey& key)
{
    const auto found = m_alarms.find(key);
    if (found == m_alarms.end() || !found->second.isListed)
        return false;
    AlarmState& state = found->second.shown.state;
    if (state == AlarmState::Returned) {
        m_alarms.erase(found);
        return true;
    }
    if (state != AlarmState::Unacknowledged)
        return false;
    state = AlarmState::Acknowledged;
    return true;
}

bool AlarmList::shelve(const AlarmKey& key, Duration time, Time now)
{
    const auto found = m_alarms.find(key);
    if (found == m_alarms.end() || !found->second.isListed ||
        found->second.shown.priority == AlarmPriority::High || !(time > Duration{}) || time > longestShelf)
        return false;
    found->second.shown.state = AlarmState::Shelved;
    found->second.shelvedUntil = now + time;
    return true;
}

bool AlarmList::unshelve(const AlarmKey& key, std::int64_t utc_ms)
{
    const auto found = m_alarms.find(key);
    if (found == m_alarms.end() || !found->second.isListed ||
        found->second.shown.state != AlarmState::Shelved)
        return false;
    if (leaveShelf(found->second, utc_ms))
        m_alarms.erase(found);
    return true;
}

std::vector<AlarmSnapshot> AlarmList::snapshot(Time now) const
{
    std::vector<AlarmSnapshot> alarms;
    for (const auto& [key, alarm] : m_alarms) {
        if (!alarm.isListed)
            continue;
        AlarmSnapshot& shown = alarms.emplace_back(alarm.shown);
        shown.holds = alarm.holds;
        if (shown.state == AlarmState::Shelved)
            shown.shelvedFor_s = std::max(0.0, secondsFrom(alarm.shelvedUntil - now));
    }
    std::ranges::stable_sort(alarms, [](const AlarmSnapshot& a, const AlarmSnapshot& b) {
        const bool aShelved = a.state == AlarmState::Shelved;
        const bool bShelved = b.state == AlarmState::Shelved;
        if (aShelved != bShelved)
            return bShelved;
        return a.priority != b.priority ? a.priority > b.priority : a.raised_utc_ms > b.raised_utc_ms;
    });
    return alarms;
}

} // namespace agv::procedure
