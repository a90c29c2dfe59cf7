// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/emulator_changes.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

namespace agv::recording {

namespace {

/// What a log of changes says of a tag: nothing (RSSI 0 or out of range), an RSSI, or that it is unclear.
struct TagState {
    std::optional<int> rssi;
    bool unclear = false;
};

/// Tags in the order of their numbers, as the emulator's loop goes; tags that the plant lacks stand by UID.
using TagOrder = std::pair<int, TagUid>;

class ChangeLog {
public:
    explicit ChangeLog(std::span<const FloorTag> plant) : m_plant(plant)
    {
        for (const FloorTag& tag : plant)
            m_numbers.emplace(tag.uid, tag.number);
    }

    TurnStop nextStop(const std::vector<std::pair<TagUid, int>>& lines)
    {
        std::map<TagOrder, int> changes;
        for (const auto& [uid, rssi] : lines) {
            changes.emplace(orderOf(uid), rssi);
            m_states.try_emplace(orderOf(uid));
        }
        TurnStop stop;
        std::set<TagUid> read;
        for (auto& [order, state] : m_states) {
            const auto change = changes.find(order);
            if (change != changes.end())
                apply(state, change->second);
            if (!state.rssi || state.unclear)
                continue;
            m_lastInRange = state.rssi;
            stop.reads.push_back({Time{}, order.second, *state.rssi});
            read.insert(order.second);
        }
        for (const FloorTag& tag : m_plant) {
            if (!read.contains(tag.uid))
                stop.unknownIfUnseen.push_back(tag.uid);
        }
        return stop;
    }

private:
    TagOrder orderOf(TagUid uid) const
    {
        const auto found = m_numbers.find(uid);
        return {found != m_numbers.end() ? found->second : 0, uid};
    }

    void apply(TagState& state, int rssi)
    {
        const bool isFirstLine = !state.rssi && !state.unclear;
        if (rssi == 0) {
            m_lastInRange = 0;
            state = {};
        } else if (!isFirstLine && !state.unclear && *state.rssi == rssi) {
            state = {}; // no change: the defect's value of a tag that has left
        } else if (!isFirstLine && m_lastInRange == rssi) {
            state = {std::nullopt, true};
        } else {
            state = {rssi, false};
        }
    }

    std::span<const FloorTag> m_plant;
    std::unordered_map<TagUid, int> m_numbers;
    std::map<TagOrder, TagState> m_states;
    std::optional<int> m_lastInRange; ///< RSSI of the last tag in range so far: the defect's value
};

} // namespace

bool canBeChangesOnly(const StopReadings& stops)
{
    std::set<TagUid> known;
    for (const auto& lines : stops) {
        std::set<TagUid> atStop;
        for (const auto& [uid, rssi] : lines) {
            if (!atStop.insert(uid).second || (known.insert(uid).second && rssi == 0))
                return false;
        }
    }
    return true;
}

std::vector<TurnStop> stopsFromChanges(const StopReadings& stops, std::span<const FloorTag> plant)
{
    ChangeLog log(plant);
    std::vector<TurnStop> result;
    result.reserve(stops.size());
    for (const auto& lines : stops)
        result.push_back(log.nextStop(lines));
    return result;
}

} // namespace agv::recording
