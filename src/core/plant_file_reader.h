// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json_fields.h"
#include "core/plant_layout.h"

#include <array>
#include <utility>

namespace agv {

inline constexpr const char* plantFormat = "agv-plant";
inline constexpr int plantVersion = 1;

/// Words of the file for the kinds of station.
inline constexpr std::array<std::pair<StationKind, const char*>, 5> stationKinds{{
    {StationKind::Colour, "colour"},
    {StationKind::Mixing, "mixing"},
    {StationKind::Storage, "storage"},
    {StationKind::Charging, "charging"},
    {StationKind::Other, "other"},
}};

/// The layout a tree describes. What is wrong goes to the findings; with errors the layout is not to be used.
PlantLayout readPlant(const Json& root, JsonFindings& findings);

} // namespace agv
