// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "core/uwb_snapshot.h"
#include "estimation/recent_values.h"
#include "protocol/trek_ranges.h"

#include <map>
#include <utility>
#include <vector>

namespace agv::session {

/// The last ranges between the anchors, by pair. Takes memory for the first range of a pair only. Times are
/// those of the steady clock, s.
class AnchorPairs {
public:
    /// Of each pair; a unit reports 3.6 to 10 of them a second.
    static constexpr std::size_t rangesKept = 100;
    /// After such a silence of a pair an anchor may have been moved.
    static constexpr double forgottenAfter_s = 60.0;

    /// Ranges between tags and anchors are left out.
    void add(const protocol::RangeSet& ranges);
    void clear() { m_pairs.clear(); }

    /// All pairs that are not forgotten at `now_s`.
    std::vector<AnchorPairSnapshot> snapshot(double now_s) const;

private:
    struct Pair {
        estimation::RecentValues<double, rangesKept> ranges_m;
        double heard_s = 0.0;
    };
    static bool isForgotten(const Pair& pair, double now_s)
    {
        return pair.heard_s + forgottenAfter_s < now_s;
    }

    std::map<std::pair<int, int>, Pair> m_pairs; ///< by rising ids
};

} // namespace agv::session
