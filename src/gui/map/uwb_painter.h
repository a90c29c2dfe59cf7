// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

#include <deque>
#include <map>

class QPainter;

namespace agv::gui {

/// Where each UWB tag was: the last points, none closer to the one before than a centimetre.
class UwbTrails {
public:
    static constexpr std::size_t mostPoints = 200;
    static constexpr double spacing_m = 0.01;

    /// A tag without a position keeps its trail; one that is no longer named loses it.
    void add(const PlantSnapshot& snapshot);
    /// Oldest first; empty for an unknown tag.
    const std::deque<Point2>& of(int tag) const;
    void clear() { m_trails.clear(); }

private:
    std::map<int, std::deque<Point2>> m_trails;
};

/// The anchors that the plant file wants shown: a triangle and the label.
void paintUwbAnchors(QPainter& painter, const Viewport& viewport, const PlantLayout& plant,
                     const Theme& theme);

/// Every UWB tag that has a position: trail, 95 % ellipse, a cross, and its label or number.
void paintUwbTags(QPainter& painter, const Viewport& viewport, const UwbSnapshot& uwb,
                  const UwbTrails& trails, const Theme& theme);

} // namespace agv::gui
