// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace agv::gui {

/// What the map shows; each has its switch in the menu.
struct MapLayers {
    bool grid = true;
    bool floorTags = true;
    bool stations = true;
    bool anchors = true;
    bool uwbTags = true;
    bool trails = true;
    bool uncertainty = true;
    bool ranges = false;   ///< of the UWB tag that was clicked, or of the chosen AGV
    bool accuracy = false; ///< how well the anchors can tell a place
    bool minimap = true;   ///< while only a part of the plant is shown
    friend bool operator==(const MapLayers&, const MapLayers&) = default;
};

} // namespace agv::gui
