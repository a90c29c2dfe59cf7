// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/turn.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace agv::test {

inline nlohmann::json readVector(const std::string& name)
{
    std::ifstream file(std::string(AGV_TEST_DATA) + "/vectors/" + name);
    if (!file)
        throw std::runtime_error("tests/data/vectors/" + name + " is missing");
    return nlohmann::json::parse(file);
}

constexpr TagUid firstUid{0xE004015000000001};

/// "11x11" or "3x3" at 100 mm from the origin.
inline std::vector<FloorTag> fieldOf(const std::string& name)
{
    const int size = name == "3x3" ? 3 : 11;
    return tagGrid(size, size, 0.1, {0.0, 0.0}, firstUid);
}

/// Tag n of the field has UID firstUid + n - 1.
inline TagUid uidOf(int number) { return TagUid{firstUid.value + static_cast<std::uint64_t>(number - 1)}; }

inline TurnRecord turnOf(const nlohmann::json& rows)
{
    TurnRecord record;
    record.nominalStep = radFromDeg(45.0);
    for (const auto& row : rows) {
        TurnStop stop;
        for (const auto& read : row)
            stop.reads.push_back({Time{}, uidOf(read[0].get<int>()), read[1].get<int>()});
        record.stops.push_back(stop);
    }
    return record;
}

} // namespace agv::test
