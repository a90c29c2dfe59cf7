// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"
#include "recording/run_folder.h"
#include "recording/run_rows.h"
#include "recording/sqlite_database.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace agv::recording {

/// Writes one run while it happens. Blocks while the disk does, so it belongs to a thread that nothing waits
/// for; used by one thread at a time. Every batch is one transaction that is on the disk when append()
/// returns: a process that is killed, or a computer that loses its power, costs the batches after the last.
/// After an error the run is as the last good batch left it; the writer is of no use any more.
class RunWriter {
public:
    /// Makes the folder runs/<time> (or runs/`name`) with run.json, plant.json and an empty database.
    /// `start`: time zero of the run, and the wall clock of its name.
    static Result<RunWriter> create(const std::filesystem::path& runs, const RunInfo& info,
                                    const PlantLayout& plant, const ClockPair& start,
                                    const std::string& name = {});

    /// Io (disk full, failing, folder removed), Permission.
    Result<void> append(const RunBatch& batch);
    /// Forgets what happened before `time`; the file does not grow while as much is forgotten as is added.
    Result<void> forget(Time before);
    /// Copies what happened since `since` into a new run beside it.
    Result<std::filesystem::path> keep(const std::filesystem::path& runs, const RunInfo& info,
                                       const PlantLayout& plant, Time since) const;
    /// The end goes into run.json, and everything into one file. What was recorded stays when this fails.
    Result<void> finish(std::int64_t ended_utc_ms);

    const std::filesystem::path& folder() const { return m_folder; }
    std::uint64_t bytesOnDisk() const;
    /// For tests: the size at which the disk is full, in pages of 4096 bytes.
    Result<void> limitPages(int pages);

private:
    RunWriter(std::filesystem::path folder, RunInfo info, const ClockPair& start, RunLock lock,
              SqliteDatabase database);
    Result<void> prepare();
    Result<void> checkStillThere() const;
    Result<void> insertAll(const RunBatch& batch);
    Result<void> insertClocks(const ClockPair& clocks);
    Result<void> insertChunks(const RunBatch& batch);
    Result<void> insertBlock(const std::string& link, const std::vector<const RunChunk*>& chunks,
                             const ClockPair& clocks);
    Result<void> insertRow(const RunRow& row);
    Result<std::int64_t> linkNumber(const std::string& name);
    Result<void> copyFrom(const RunWriter& source);
    std::int64_t sinceStart_ns(Time time) const { return Duration(time - m_start.time).count(); }

    std::filesystem::path m_folder;
    RunInfo m_info;
    ClockPair m_start;
    RunLock m_lock;
    SqliteDatabase m_database;
    std::vector<SqliteStatement> m_insert; ///< by table
    std::vector<SqliteStatement> m_others; ///< clocks, links, raw
    std::map<std::string, std::int64_t> m_links;
    std::int64_t m_clockOffset_us = 0; ///< wall clock less monotonic clock, as written last
    bool m_hasClock = false;
    std::uint64_t m_fileId = 0; ///< inode of the database
};

} // namespace agv::recording
