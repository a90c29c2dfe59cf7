// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"

#include <deque>
#include <map>
#include <optional>

namespace agv::gui {

struct TrailPoint {
    Time time;
    Point2 place;
    bool startsAnew = false; ///< the pose was found anew here: it did not drive from the point before
};

/// How much of a trail is kept; a limit that is empty does not count.
struct TrailLimit {
    std::optional<double> seconds;
    std::optional<double> metres;
    friend bool operator==(const TrailLimit&, const TrailLimit&) = default;
};

/// Where AGVs and UWB tags have been. Points closer than `spacing_m` to the one before are left out, so that
/// a vehicle that stands costs nothing.
class Trails {
public:
    static constexpr std::size_t mostPoints = 2000;
    static constexpr double spacing_m = 0.01;
    /// A longer step between two snapshots is no driving: a calibration found the pose anew.
    static constexpr double longestStep_m = 0.3;
    using Trail = std::deque<TrailPoint>;

    void setLimit(const TrailLimit& limit) { m_limit = limit; }
    const TrailLimit& limit() const { return m_limit; }

    /// What has no position now keeps its trail; what is no longer named loses it.
    void add(const PlantSnapshot& snapshot);
    /// Oldest first; empty for an unknown one.
    const Trail& ofTag(int tag) const;
    const Trail& ofAgv(int robot) const;
    void clear();

private:
    void addTo(Trail& trail, Time time, Point2 place) const;
    void prune(Trail& trail, Time now) const;

    TrailLimit m_limit{60.0, std::nullopt};
    std::map<int, Trail> m_tags;
    std::map<int, Trail> m_agvs;
};

} // namespace agv::gui
