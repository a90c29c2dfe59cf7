// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/alarm_log.h"

#include "model/alarm_words.h"

#include <algorithm>

namespace agv::gui {

using model::AlarmWords;

namespace {

EventLevel levelOf(AlarmPriority priority)
{
    return priority == AlarmPriority::High     ? EventLevel::Error
           : priority == AlarmPriority::Medium ? EventLevel::Warning
                                               : EventLevel::Info;
}

/// As the session names its sources, so that the log translates them alike.
std::string logSource(const AlarmKey& key)
{
    switch (key.kind) {
    case AlarmKind::NotListening:
    case AlarmKind::Stranger:
        return "Console";
    case AlarmKind::UwbLink:
    case AlarmKind::AnchorMoved:
        return "UWB";
    default:
        return "AGV " + std::to_string(key.subject);
    }
}

} // namespace

QString AlarmLog::change(const AlarmSnapshot* before, const AlarmSnapshot& now)
{
    const bool isNews = !before || before->raised_utc_ms != now.raised_utc_ms;
    if (now.state == AlarmState::Unacknowledged && isNews)
        return tr("Alarm: %1. %2").arg(AlarmWords::what(now), AlarmWords::remedy(now.key.kind));
    if (!before || before->state == now.state)
        return {};
    switch (now.state) {
    case AlarmState::Acknowledged:
        return tr("Alarm acknowledged: %1").arg(AlarmWords::what(now));
    case AlarmState::Returned:
        return tr("Alarm over, not acknowledged: %1").arg(AlarmWords::what(now));
    case AlarmState::Shelved:
        return tr("Alarm shelved: %1").arg(AlarmWords::what(now));
    case AlarmState::Unacknowledged:
        break;
    }
    return {};
}

std::vector<EventEntry> AlarmLog::linesFor(const std::vector<AlarmSnapshot>& alarms, std::int64_t utc_ms)
{
    std::vector<EventEntry> lines;
    const auto add = [&](const AlarmSnapshot& alarm, EventLevel level, const QString& text) {
        lines.push_back({utc_ms, level, logSource(alarm.key), text.toStdString()});
    };
    std::map<AlarmKey, AlarmSnapshot> known;
    for (const AlarmSnapshot& alarm : alarms) {
        const auto before = m_known.find(alarm.key);
        const QString text = change(before == m_known.end() ? nullptr : &before->second, alarm);
        if (!text.isEmpty())
            add(alarm, alarm.state == AlarmState::Unacknowledged ? levelOf(alarm.priority) : EventLevel::Info,
                text);
        known.emplace(alarm.key, alarm);
    }
    for (const auto& [key, alarm] : m_known) {
        if (!known.contains(key))
            add(alarm, EventLevel::Info, tr("Alarm over: %1").arg(AlarmWords::what(alarm)));
    }
    m_known = std::move(known);
    return lines;
}

} // namespace agv::gui
