// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"
#include "recording/run_folder.h"
#include "recording/run_tables.h"
#include "recording/sqlite_database.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace agv::recording {

/// Reads a run, also one that is being written or whose console was killed. Whatever the files hold, the
/// answer is rows or an Error that says which file is wrong and what to do; never a crash, never a wait
/// without end.
class RunReader {
public:
    static Result<RunReader> open(const std::filesystem::path& run);

    const RunInfo& info() const { return m_info; }
    const std::filesystem::path& folder() const { return m_folder; }
    /// The plant as it was used.
    Result<PlantLayout> plant() const;

    struct Row {
        std::int64_t t_ns = 0;          ///< since the run began
        std::span<const RunCell> cells; ///< in the order of the table's columns
    };
    /// False ends the reading early.
    using RowSink = std::function<bool(const Row&)>;
    using ChunkSink = std::function<bool(const RunChunk&)>;

    /// The rows of runTables()[table], in the order in which they happened.
    Result<void> rows(std::size_t table, const RowSink& sink);
    Result<std::uint64_t> countRows(std::size_t table);
    /// The bytes of all links in the order of their arrival; RunChunk::time counts from Time{}.
    Result<void> chunks(const ChunkSink& sink);
    Result<std::uint64_t> countBlocks(); ///< of chunks, for showing progress

    /// Wall clock at a time of the run, microseconds since 1970; it jumps where the computer's clock did.
    std::int64_t utcAt_us(std::int64_t t_ns) const;

private:
    struct Clock {
        std::int64_t t_ns = 0;
        std::int64_t utc_us = 0;
    };
    struct BlockPlace {
        std::int64_t t_ns = 0;
        std::int64_t row = 0;
    };
    RunReader(std::filesystem::path run, RunInfo info, SqliteDatabase database);
    Result<void> check();
    Result<void> readClocks();
    Result<std::vector<std::string>> linkNames();
    Result<std::vector<BlockPlace>> blockPlaces();
    Result<std::uint64_t> count(const std::string& table);
    std::unexpected<Error> damaged(const std::string& what) const;

    std::filesystem::path m_folder;
    RunInfo m_info;
    SqliteDatabase m_database;
    std::vector<Clock> m_clocks; ///< by time
};

} // namespace agv::recording
