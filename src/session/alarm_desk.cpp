// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/alarm_desk.h"

#include "session/wall_clock.h"

namespace agv::session {

void AlarmDesk::addTo(PlantSnapshot& snapshot)
{
    m_alarms.update(m_conditions.of(snapshot), snapshot.time, utcNow_ms());
    snapshot.alarms = m_alarms.snapshot(snapshot.time);
    snapshot.alarmFlood = m_alarms.isFlooded();
}

void AlarmDesk::acknowledge(const std::vector<AlarmKey>& keys)
{
    for (const AlarmKey& key : keys)
        m_alarms.acknowledge(key);
    emit changed();
}

void AlarmDesk::shelve(const std::vector<AlarmKey>& keys, double seconds)
{
    for (const AlarmKey& key : keys)
        m_alarms.shelve(key, durationFromSeconds(seconds), monotonicNow());
    emit changed();
}

void AlarmDesk::unshelve(const std::vector<AlarmKey>& keys)
{
    for (const AlarmKey& key : keys)
        m_alarms.unshelve(key, utcNow_ms());
    emit changed();
}

} // namespace agv::session
