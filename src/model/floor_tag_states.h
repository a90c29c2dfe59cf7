// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace agv::model {

/// What the last turn of an AGV found, while the AGV still stands there or turns; else null.
const TurnEstimate* shownEstimate(const AgvSnapshot& agv);

enum class FloorTagState {
    NotSeen,
    SeenNow,    ///< within the last second
    SeenBefore, ///< in this session
    Missing,    ///< a turn whose result still stands should have read it and did not
    Unknown,    ///< read, but no list names it
};

/// What the readers have said of the floor tags in this session.
class FloorTagStates {
public:
    static constexpr Duration now = std::chrono::seconds(1);

    struct LastRead {
        Time time;
        int robot = 0;
        int rssi = 0;
    };
    struct Unknown {
        TagUid uid;
        Point2 antenna; ///< of the stop that read it, m
    };

    void add(const PlantSnapshot& snapshot);
    void clear();

    /// Of a tag of the list; never Unknown.
    FloorTagState stateOf(TagUid uid) const;
    std::optional<LastRead> lastRead(TagUid uid) const;
    const std::vector<Unknown>& unknown() const { return m_unknown; }
    Time time() const { return m_time; } ///< of the last snapshot

private:
    std::unordered_map<TagUid, LastRead> m_reads;
    std::unordered_set<TagUid> m_seen; ///< by a turn, or read
    std::unordered_set<TagUid> m_missing;
    std::vector<Unknown> m_unknown;
    Time m_time;
};

} // namespace agv::model
