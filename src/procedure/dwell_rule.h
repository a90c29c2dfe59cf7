// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tag_read.h"
#include "core/turn.h"

#include <unordered_map>

namespace agv::procedure {

/// When has a stop been read long enough? As soon as the set of tags is stable: no new tag for quietTime and
/// every tag read at least twice. A tag that shows only once (a stale read, or one at the edge of the range)
/// holds the stop no longer than loneTagTime. Always within the shortest and longest dwell of the parameters;
/// a stop without any read lasts the longest dwell.
class DwellRule {
public:
    /// One round of the reader over the seven tags that fit below the antenna, at 30 to 35 ms a read
    /// (seed, 7.2 and eq. 14).
    static constexpr Duration quietTime = std::chrono::milliseconds(250);
    /// Two rounds: at 20 % misses a tag in range stays unread through both once in 25 times.
    static constexpr Duration loneTagTime = 2 * quietTime;

    explicit DwellRule(const TurnParameters& parameters);

    void begin(Time now);
    void add(const TagRead& read);
    /// When the stop may be left, if nothing more is read; moves with every read.
    Time leaveAt() const;

private:
    Duration m_shortest;
    Duration m_longest;
    bool m_adaptive;
    Time m_begin;
    Time m_lastNewTag;
    std::unordered_map<TagUid, int> m_reads;
    int m_loneTags = 0;
};

} // namespace agv::procedure
