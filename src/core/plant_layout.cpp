// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_layout.h"

#include <algorithm>
#include <charconv>

namespace agv {

RssiTable seedRssiTable()
{
    return {{0.1400, 0}, {0.0975, 1}, {0.0900, 2}, {0.0800, 3}, {0.0700, 4}, {0.0600, 5},
            {0.0580, 4}, {0.0550, 3}, {0.0530, 2}, {0.0510, 1}, {0.0500, 0}, {0.0470, 1},
            {0.0450, 2}, {0.0430, 3}, {0.0420, 4}, {0.0400, 5}, {0.0350, 6}, {0.0275, 7}};
}

std::optional<int> rssiAt(const RssiTable& table, double distance)
{
    const auto firstBelow = std::find_if(table.begin(), table.end(),
                                         [=](const RssiStep& step) { return step.upperEdge < distance; });
    if (firstBelow == table.begin())
        return std::nullopt;
    return std::prev(firstBelow)->rssi;
}

std::string toText(const Endpoint& endpoint) { return endpoint.host + ":" + std::to_string(endpoint.port); }

Result<Endpoint> parseEndpoint(std::string_view text)
{
    const auto colon = text.rfind(':');
    if (colon == std::string_view::npos || colon == 0)
        return failure(ErrorCode::BadInput,
                       "'" + std::string(text) +
                           "' is not an address; expected host:port, e.g. 192.168.1.200:2001");
    const std::string_view port = text.substr(colon + 1);
    Endpoint endpoint{std::string(text.substr(0, colon)), 0};
    const auto [stop, error] = std::from_chars(port.data(), port.data() + port.size(), endpoint.port);
    if (error != std::errc{} || stop != port.data() + port.size() || port.empty())
        return failure(ErrorCode::BadInput, "'" + std::string(port) + "' in '" + std::string(text) +
                                                "' is not a port; expected a number from 0 to 65535");
    return endpoint;
}

const AgvConfig* PlantLayout::findAgv(RobotId id) const
{
    const auto found =
        std::find_if(agvs.begin(), agvs.end(), [=](const AgvConfig& agv) { return agv.id == id; });
    return found == agvs.end() ? nullptr : &*found;
}

TagMap tagMapOf(const PlantLayout& plant)
{
    TagMap map;
    map.reserve(plant.floorTags.size());
    for (const FloorTag& tag : plant.floorTags)
        map.emplace(tag.uid, tag.position);
    return map;
}

std::vector<FloorTag> tagGrid(int columns, int rows, double pitch, Point2 origin, TagUid firstUid)
{
    std::vector<FloorTag> tags;
    tags.reserve(static_cast<std::size_t>(std::max(0, columns)) *
                 static_cast<std::size_t>(std::max(0, rows)));
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            const int index = column * rows + row;
            tags.push_back({TagUid{firstUid.value + static_cast<std::uint64_t>(index)},
                            {origin.x + column * pitch, origin.y + row * pitch},
                            index + 1});
        }
    }
    return tags;
}

} // namespace agv
