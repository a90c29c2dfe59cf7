// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text_file.h"
#include "core/units.h"
#include "protocol/reader_line.h"
#include "recording/turn_file.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <stdexcept>

namespace agv::recording::test {

inline std::optional<ReaderLineRead> decodeLine(std::string_view line)
{
    const auto report = protocol::decodeReaderLine(line);
    const auto* read = report ? std::get_if<protocol::CompleteRead>(&*report) : nullptr;
    return read ? std::optional(ReaderLineRead{read->uid, read->rssi}) : std::nullopt;
}

/// 11 x 11 tags, number n has UID E004000000000000 + n.
inline TurnFileOptions largeField()
{
    TurnFileOptions options;
    options.tags = tagGrid(11, 11, 0.1, {0.0, 0.0}, TagUid{0xE004000000000001});
    options.nominalStep = radFromDeg(45.0);
    options.turnTime_s = 1.125;
    options.decodeReaderLine = decodeLine;
    return options;
}

/// 3 x 3 tags with the UIDs of the seed's test field.
inline TurnFileOptions smallField()
{
    TurnFileOptions options = largeField();
    options.tags = tagGrid(3, 3, 0.1, {0.0, 0.0}, TagUid{1});
    const char* const shortUids[] = {"AE4", "586", "BF4", "689", "785", "691", "47A", "ADC", "78D"};
    for (std::size_t k = 0; k < 9; ++k)
        options.tags[k].uid = *parseTagUid(std::string("E00401503A5BD") + shortUids[k]);
    return options;
}

/// Tag numbers and RSSI of a stop, in order.
using NumbersAndRssi = std::vector<std::pair<int, int>>;
inline NumbersAndRssi readsOf(const TurnStop& stop, const TurnFileOptions& options)
{
    NumbersAndRssi reads;
    for (const TagRead& read : stop.reads) {
        int number = -1;
        for (const FloorTag& tag : options.tags) {
            if (tag.uid == read.uid)
                number = tag.number;
        }
        reads.emplace_back(number, read.rssi);
    }
    return reads;
}

inline TurnFile parsed(std::string_view text, const TurnFileOptions& options)
{
    auto file = parseTurns(text, options);
    if (!file)
        throw std::runtime_error(file.error().detail);
    return *file;
}

inline TurnFile dataFile(const std::string& name, const TurnFileOptions& options)
{
    auto file = readTurnFile(std::string(AGV_TEST_DATA) + "/turns/" + name, options);
    if (!file)
        throw std::runtime_error(file.error().detail);
    return *file;
}

} // namespace agv::recording::test
