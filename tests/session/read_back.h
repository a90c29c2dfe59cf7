// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/run_reader.h"

#include <string>
#include <string_view>
#include <vector>

namespace agv::session {

/// All bytes of one link of a run, one after the other; what is wrong with the run, if anything is.
inline std::string recordedBytes(recording::RunReader& run, std::string_view link)
{
    std::string bytes;
    const Result<void> read = run.chunks([&](const recording::RunChunk& chunk) {
        if (chunk.link == link)
            bytes += chunk.bytes;
        return true;
    });
    return read ? bytes : read.error().detail;
}

inline std::size_t tableOf(std::string_view name)
{
    std::size_t table = 0;
    while (recording::runTables()[table].name != name)
        ++table;
    return table;
}

inline std::uint64_t recordedRows(recording::RunReader& run, std::string_view table)
{
    return run.countRows(tableOf(table)).value_or(0);
}

/// The texts of a column of a table.
inline std::vector<std::string> recordedTexts(recording::RunReader& run, std::string_view table,
                                              std::size_t column)
{
    std::vector<std::string> texts;
    static_cast<void>(run.rows(tableOf(table), [&](const recording::RunReader::Row& row) {
        if (const auto* text = std::get_if<std::string_view>(&row.cells[column]))
            texts.emplace_back(*text);
        return true;
    }));
    return texts;
}

} // namespace agv::session
