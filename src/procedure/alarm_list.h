// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarm.h"
#include "core/units.h"

#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <vector>

namespace agv::procedure {

struct AlarmCondition {
    AlarmKey key;
    std::string detail; ///< plain English
};

/// What is the same for all alarms of a kind.
struct AlarmRule {
    AlarmPriority priority = AlarmPriority::Low;
    Duration raiseAfter{}; ///< the condition has to hold that long
    Duration returnAfter{std::chrono::seconds(2)};
};
AlarmRule ruleOf(AlarmKind kind);

/// The alarms of a plant after ISA-18.2, a pure state machine:
/// | state          | event                                  | next           |
/// |----------------|----------------------------------------|----------------|
/// | -              | condition held for raiseAfter          | Unacknowledged |
/// | Unacknowledged | acknowledge                            | Acknowledged   |
/// | Unacknowledged | condition gone for returnAfter         | Returned       |
/// | Acknowledged   | condition gone for returnAfter         | -              |
/// | Returned       | acknowledge                            | -              |
/// | Returned       | condition held for raiseAfter          | Unacknowledged |
/// | all but Shelved| shelve(time)                           | Shelved        |
/// | Shelved        | time over or unshelve, condition holds | Unacknowledged |
/// | Shelved        | time over or unshelve, condition gone  | -              |
/// Everything else is ignored. High alarms cannot be shelved. A flood, more than mostInFlood alarms within
/// floodWindow, holds new ones of low priority back until it is over, so that the weighty ones are seen.
class AlarmList {
public:
    static constexpr std::size_t mostInFlood = 10;
    static constexpr Duration floodWindow = std::chrono::minutes(10);
    static constexpr Duration longestShelf = std::chrono::hours(12);

    /// The conditions of now, each key once. `utc_ms` is the wall clock put on alarms that are raised.
    void update(const std::vector<AlarmCondition>& conditions, Time now, std::int64_t utc_ms);

    /// False when there is no such alarm, or nothing to acknowledge.
    bool acknowledge(const AlarmKey& key);
    /// False when there is no such alarm, it is High, or `time` is not between zero and longestShelf.
    bool shelve(const AlarmKey& key, Duration time, Time now);
    bool unshelve(const AlarmKey& key, std::int64_t utc_ms);

    bool isFlooded() const { return m_raised.size() > mostInFlood; }
    /// By weight, then the newest first; the shelved ones last.
    std::vector<AlarmSnapshot> snapshot(Time now) const;

private:
    struct Alarm {
        AlarmSnapshot shown;
        bool isListed = false; ///< raised; else the condition has only begun
        bool holds = false;
        Time since; ///< the condition came or went then
        Time shelvedUntil;
    };
    void raise(Alarm& alarm, Time now, std::int64_t utc_ms);
    /// What time has done to it; true when it leaves the list.
    bool advance(Alarm& alarm, Time now, std::int64_t utc_ms);
    static bool leaveShelf(Alarm& alarm, std::int64_t utc_ms);

    std::map<AlarmKey, Alarm> m_alarms;
    std::deque<Time> m_raised; ///< within floodWindow
};

} // namespace agv::procedure
