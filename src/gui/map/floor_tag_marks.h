// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

#include <optional>
#include <unordered_set>
#include <vector>

class QPainter;

namespace agv::gui {

/// What the readers have said of the floor tags in this session: which were seen, which should have been seen
/// by the turns whose results still stand on the map and were not, and what was read that no list names.
class FloorTagMarks {
public:
    enum class State { NotSeen, SeenBefore, Missing };
    struct Unknown {
        TagUid uid;
        Point2 antenna; ///< of the stop that read it, m
    };

    void add(const PlantSnapshot& snapshot);
    void clear();

    State stateOf(TagUid uid) const;
    const std::vector<Unknown>& unknown() const { return m_unknown; }

    /// Dots for seen tags, crossed squares for missing ones, triangles with a question mark for unknown ones.
    void paint(QPainter& painter, const Viewport& viewport, const std::vector<FloorTag>& tags,
               double tagRadius_m, const Theme& theme) const;

private:
    std::unordered_set<TagUid> m_seen;
    std::unordered_set<TagUid> m_missing;
    std::vector<Unknown> m_unknown;
};

} // namespace agv::gui
