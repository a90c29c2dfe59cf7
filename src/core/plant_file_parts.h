// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/json_fields.h"

#include <optional>
#include <string>
#include <string_view>

namespace agv {

/// Of every coordinate in a plant file, mm.
inline constexpr int highestAgv = 999;
inline constexpr NumberRange coordinateRange{-1e6, 1e6};

/// [x, y] in mm; (0, 0) with an error when it is something else.
Point2 readPoint(const Json& json, const std::string& pointer, JsonFindings& findings);

/// An optional member [x, y]; (0, 0) without it.
Point2 readPoint(JsonFields& fields, std::string_view key);

/// The members x_mm and y_mm.
Point2 readPosition(JsonFields& fields);

/// The rectangle of the plant, m; unknown while its size could not be read.
class PlantArea {
public:
    PlantArea() = default;
    PlantArea(Point2 origin, double width, double height)
        : m_origin(origin),
          m_size{width, height},
          m_known(true)
    {}

    /// Adds an error at `pointer` when `p` is outside; `what` names the thing. An unknown area holds
    /// anything.
    void requireInside(Point2 p, const std::string& pointer, const std::string& what,
                       JsonFindings& findings) const;

    bool isEastOf(Point2 p) const { return p.x > m_origin.x + m_size.x; }

private:
    Point2 m_origin;
    Point2 m_size;
    bool m_known = false;
};

/// Calls readItem(JsonFields&) for one object of an array after the other; stops after the first wrong one.
template<typename ReadItem>
void readEach(JsonFields& parent, std::string_view key, JsonFindings& findings, ReadItem readItem)
{
    const Json* const items = parent.array(key);
    if (items == nullptr)
        return;
    const std::size_t before = findings.errors.size();
    for (std::size_t i = 0; i < items->size() && findings.errors.size() == before; ++i) {
        JsonFields item((*items)[i], parent.pointerTo(key) + "/" + std::to_string(i), findings);
        readItem(item);
        item.finish();
    }
}

} // namespace agv
