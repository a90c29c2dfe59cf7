// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "procedure/alarm_list.h"

#include <memory>
#include <set>

namespace agv::procedure {

/// What of a snapshot an operator has to act on. Remembers what a single snapshot does not tell: which links
/// have been up, which battery is low until it is charged, which peer came last.
class AlarmConditions {
public:
    static constexpr double lowCharge = 0.20;        ///< share of the capacity
    static constexpr double recoveredCharge = 0.25;  ///< from here on it is low no more
    static constexpr std::size_t mostMissedTags = 2; ///< of one turn; more are an alarm
    static constexpr Duration strangerIsNews = std::chrono::seconds(60);

    /// In the order of AlarmKind, each key once.
    std::vector<AlarmCondition> of(const PlantSnapshot& snapshot);

private:
    void addAgv(const AgvSnapshot& agv, std::vector<AlarmCondition>& conditions);
    void addUwb(const UwbSnapshot& uwb, std::vector<AlarmCondition>& conditions);
    void addLink(AlarmKey key, const LinkSnapshot& link, std::vector<AlarmCondition>& conditions);
    bool isBatteryLow(const AgvSnapshot& agv);

    std::set<AlarmKey> m_hasBeenUp;
    std::set<int> m_lowBatteries;
    std::size_t m_strangers = 0;
    std::string m_lastStranger;
    Time m_strangerCame;
};

} // namespace agv::procedure
