// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_file_parts.h"
#include "core/plant_layout.h"

#include <optional>
#include <unordered_map>

namespace agv {

/// "floor_tags": {"grid": ...} of a plant file; m.
struct TagGridSpec {
    int columns = 0;
    int rows = 0;
    double pitch_m = 0.0;
    Point2 origin;
    TagUid firstUid;
};

inline std::vector<FloorTag> expand(const TagGridSpec& grid)
{
    return tagGrid(grid.columns, grid.rows, grid.pitch_m, grid.origin, grid.firstUid);
}

/// The grid of a tree that readPlant() accepted, if it has one.
std::optional<TagGridSpec> gridOf(const Json& root);

/// Reads the section "floor_tags": first the grid, then the list. Use once.
class FloorTagReader {
public:
    FloorTagReader(const PlantArea& area, JsonFindings& findings) : m_area(area), m_findings(findings) {}

    void read(JsonFields& root, PlantLayout& plant);

private:
    void readGrid(const Json& json, const std::string& pointer);
    void addGrid(const TagGridSpec& grid, const std::string& pointer);
    void readTag(JsonFields& fields);
    std::string whereUsed(std::size_t index) const;

    const PlantArea& m_area;
    JsonFindings& m_findings;
    std::vector<FloorTag> m_tags;
    std::unordered_map<TagUid, std::size_t> m_used; ///< index into m_tags
    std::size_t m_gridTags = 0;
};

} // namespace agv
