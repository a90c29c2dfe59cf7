// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_writer.h"

#include "core/plant_file.h"
#include "recording/raw_block.h"
#include "recording/run_tables.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <sys/stat.h>

namespace agv::recording {
namespace {

/// Clocks that drift apart by less are not worth a row.
constexpr std::int64_t noticedClockStep_us = 1000;

enum OtherStatement : std::size_t { InsertClock, InsertLink, InsertRaw };

constexpr const char* setUp = "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;"
                              "PRAGMA application_id = 1095194188;"; // "AGVL"

std::uint64_t inodeOf(const std::filesystem::path& file)
{
    struct stat status{};
    return ::stat(file.c_str(), &status) == 0 ? status.st_ino : 0;
}

std::uint64_t sizeOf(const std::filesystem::path& file)
{
    struct stat status{};
    return ::stat(file.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

std::int64_t microseconds(Duration duration)
{
    return std::chrono::duration_cast<std::chrono::microseconds>(duration).count();
}

void bindCell(SqliteStatement& statement, int parameter, const RunCell& cell)
{
    if (const auto* number = std::get_if<std::int64_t>(&cell))
        statement.bind(parameter, *number);
    else if (const auto* text = std::get_if<std::string_view>(&cell))
        statement.bindText(parameter, *text);
    else
        statement.bindNull(parameter);
}

} // namespace

RunWriter::RunWriter(std::filesystem::path folder, RunInfo info, const ClockPair& start, RunLock lock,
                     SqliteDatabase database)
    : m_folder(std::move(folder)),
      m_info(std::move(info)),
      m_start(start),
      m_lock(std::move(lock)),
      m_database(std::move(database)),
      m_fileId(inodeOf(m_database.path()))
{}

Result<RunWriter> RunWriter::create(const std::filesystem::path& runs, const RunInfo& info,
                                    const PlantLayout& plant, const ClockPair& start, const std::string& name)
{
    RunInfo described = info;
    described.started_utc_ms = start.utc_us / 1000;
    const Result<std::filesystem::path> folder =
        makeRunFolder(runs, name.empty() ? runName(described.started_utc_ms) : name);
    if (!folder)
        return std::unexpected(folder.error());
    Result<RunLock> lock = RunLock::take(*folder);
    if (!lock)
        return std::unexpected(lock.error());
    Result<void> written = writePlantFile(*folder / runPlantFile, plant);
    if (written)
        written = writeRunInfo(*folder, described);
    if (!written)
        return std::unexpected(written.error());
    Result<SqliteDatabase> database =
        SqliteDatabase::open(*folder / runDatabaseFile, SqliteDatabase::Access::Create);
    if (!database)
        return std::unexpected(database.error());
    RunWriter writer(*folder, std::move(described), start, std::move(*lock), std::move(*database));
    if (const Result<void> prepared = writer.prepare(); !prepared)
        return std::unexpected(prepared.error());
    return writer;
}

Result<void> RunWriter::prepare()
{
    const std::string version = "PRAGMA user_version = " + std::to_string(runFormat) + ";";
    if (Result<void> made = m_database.execute(setUp + version + "BEGIN;" + runSchema() + "COMMIT;"); !made)
        return made;
    const auto add = [this](std::vector<SqliteStatement>& list, const std::string& sql) -> Result<void> {
        Result<SqliteStatement> statement = m_database.prepare(sql);
        if (!statement)
            return std::unexpected(statement.error());
        list.push_back(std::move(*statement));
        return {};
    };
    for (const RunTable& table : runTables()) {
        if (Result<void> added = add(m_insert, insertStatement(table)); !added)
            return added;
    }
    for (const char* sql : {"INSERT INTO clocks VALUES (?, ?)", "INSERT INTO links VALUES (?, ?)",
                            "INSERT INTO raw VALUES (?, ?, ?, ?)"}) {
        if (Result<void> added = add(m_others, sql); !added)
            return added;
    }
    return insertClocks(m_start);
}

Result<void> RunWriter::append(const RunBatch& batch)
{
    Result<void> result = checkStillThere();
    if (result)
        result = m_database.execute("BEGIN");
    if (!result)
        return result;
    result = insertAll(batch);
    if (result)
        result = m_database.execute("COMMIT");
    // What the failure was is said by then; there may be nothing left to roll back.
    if (!result) [[maybe_unused]]
        const Result<void> undone = m_database.execute("ROLLBACK");
    return result;
}

/// SQLite goes on writing into a file that was removed, and everything would be lost at the end.
Result<void> RunWriter::checkStillThere() const
{
    const std::uint64_t now = inodeOf(m_database.path());
    if (now != 0 && now == m_fileId)
        return {};
    return failure(ErrorCode::NotFound,
                   m_folder.string() + ": the folder of the run was removed or renamed: record again");
}

Result<void> RunWriter::insertAll(const RunBatch& batch)
{
    Result<void> result = insertClocks(batch.clocks);
    if (result)
        result = insertChunks(batch);
    for (std::size_t i = 0; result && i < batch.rows.size(); ++i)
        result = insertRow(batch.rows[i]);
    return result;
}

Result<void> RunWriter::insertClocks(const ClockPair& clocks)
{
    const std::int64_t offset_us = clocks.utc_us - microseconds(clocks.time.time_since_epoch());
    if (m_hasClock && std::abs(offset_us - m_clockOffset_us) < noticedClockStep_us)
        return {};
    m_hasClock = true;
    m_clockOffset_us = offset_us;
    m_others[InsertClock].bind(0, sinceStart_ns(clocks.time));
    m_others[InsertClock].bind(1, clocks.utc_us);
    return m_others[InsertClock].run(m_database);
}

Result<void> RunWriter::insertChunks(const RunBatch& batch)
{
    std::map<std::string_view, std::vector<const RunChunk*>> byLink;
    for (const RunChunk& chunk : batch.chunks)
        byLink[chunk.link].push_back(&chunk);
    for (const auto& [link, chunks] : byLink) {
        std::vector<const RunChunk*> block;
        std::size_t bytes = 0;
        for (const RunChunk* chunk : chunks) {
            // Clocks of threads and devices aside: a time that falls begins a block of its own.
            const bool falls = !block.empty() && chunk->time < block.back()->time;
            if (falls || (!block.empty() && bytes + chunk->bytes.size() > largestRawBlock)) {
                if (Result<void> inserted = insertBlock(std::string(link), block, batch.clocks); !inserted)
                    return inserted;
                block.clear();
                bytes = 0;
            }
            block.push_back(chunk);
            bytes += chunk->bytes.size();
        }
        if (Result<void> inserted = insertBlock(std::string(link), block, batch.clocks); !inserted)
            return inserted;
    }
    return {};
}

Result<void> RunWriter::insertBlock(const std::string& link, const std::vector<const RunChunk*>& chunks,
                                    const ClockPair& clocks)
{
    const Result<std::int64_t> number = linkNumber(link);
    if (!number)
        return std::unexpected(number.error());
    const Time first = chunks.front()->time;
    const std::string packed = packChunks(chunks);
    SqliteStatement& insert = m_others[InsertRaw];
    insert.bind(0, sinceStart_ns(first));
    insert.bind(1, clocks.utc_us - microseconds(clocks.time - first));
    insert.bind(2, *number);
    insert.bindBytes(3, packed);
    return insert.run(m_database);
}

Result<void> RunWriter::insertRow(const RunRow& row)
{
    const RunCells cells = cellsOf(row);
    SqliteStatement& insert = m_insert[cells.table];
    insert.bind(0, sinceStart_ns(cells.time));
    for (std::size_t i = 0; i < cells.count; ++i)
        bindCell(insert, static_cast<int>(i) + 1, cells.cells[i]);
    return insert.run(m_database);
}

Result<std::int64_t> RunWriter::linkNumber(const std::string& name)
{
    if (const auto known = m_links.find(name); known != m_links.end())
        return known->second;
    const auto number = static_cast<std::int64_t>(m_links.size()) + 1;
    m_others[InsertLink].bind(0, number);
    m_others[InsertLink].bindText(1, name);
    if (const Result<void> inserted = m_others[InsertLink].run(m_database); !inserted)
        return std::unexpected(inserted.error());
    m_links.emplace(name, number);
    return number;
}

Result<void> RunWriter::forget(Time before)
{
    const std::string time = std::to_string(sinceStart_ns(before));
    std::string sql = "BEGIN;";
    const auto forgetIn = [&](const std::string& table) {
        sql += "DELETE FROM " + table + " WHERE rowid < ifnull((SELECT rowid FROM " + table +
               " WHERE t_ns >= " + time + " ORDER BY rowid LIMIT 1), 9223372036854775807);";
    };
    forgetIn("raw");
    for (const RunTable& table : runTables())
        forgetIn(table.name);
    Result<void> result = checkStillThere();
    if (result)
        result = m_database.execute(sql + "COMMIT");
    if (!result) [[maybe_unused]]
        const Result<void> undone = m_database.execute("ROLLBACK");
    return result;
}

Result<std::filesystem::path> RunWriter::keep(const std::filesystem::path& runs, const RunInfo& info,
                                              const PlantLayout& plant, Time since) const
{
    const Time first = std::max(since, m_start.time);
    const Duration later = first - m_start.time;
    const ClockPair start{first, m_start.utc_us + microseconds(later)};
    Result<RunWriter> copy = create(runs, info, plant, start);
    if (!copy)
        return std::unexpected(copy.error());
    if (const Result<void> copied = copy->copyFrom(*this); !copied)
        return std::unexpected(copied.error());
    const std::int64_t ended_us =
        m_clockOffset_us + microseconds(std::chrono::steady_clock::now().time_since_epoch());
    if (const Result<void> finished = copy->finish(ended_us / 1000); !finished)
        return std::unexpected(finished.error());
    return copy->folder();
}

Result<void> RunWriter::copyFrom(const RunWriter& source)
{
    Result<SqliteStatement> attach = m_database.prepare("ATTACH ? AS source");
    if (!attach)
        return std::unexpected(attach.error());
    const std::string file = source.m_database.path().string();
    attach->bindText(0, file);
    if (Result<void> attached = attach->run(m_database); !attached)
        return attached;
    const std::string shift = std::to_string(Duration(m_start.time - source.m_start.time).count());
    std::string sql = "BEGIN; DELETE FROM clocks; INSERT INTO links SELECT * FROM source.links;"
                      "INSERT INTO clocks SELECT t_ns - " +
                      shift +
                      ", utc_us FROM source.clocks ORDER BY rowid;"
                      "INSERT INTO raw SELECT t_ns - " +
                      shift + ", utc_us, link, packed FROM source.raw WHERE t_ns >= " + shift +
                      " ORDER BY rowid;";
    for (const RunTable& table : runTables()) {
        std::string columns = "t_ns - " + shift;
        for (const RunColumn& column : table.columns)
            columns += std::string(", ") + column.name;
        sql.append("INSERT INTO ").append(table.name).append(" SELECT ").append(columns);
        sql.append(" FROM source.")
            .append(table.name)
            .append(" WHERE t_ns >= ")
            .append(shift)
            .append(" ORDER BY rowid;");
    }
    return m_database.execute(sql + "COMMIT; DETACH source;");
}

Result<void> RunWriter::finish(std::int64_t ended_utc_ms)
{
    m_info.ended_utc_ms = ended_utc_ms;
    Result<void> result = checkStillThere();
    if (result)
        result = m_database.execute("PRAGMA wal_checkpoint(TRUNCATE)");
    if (result)
        result = writeRunInfo(m_folder, m_info);
    return result;
}

std::uint64_t RunWriter::bytesOnDisk() const
{
    const std::string database = m_database.path().string();
    return sizeOf(database) + sizeOf(database + "-wal");
}

Result<void> RunWriter::limitPages(int pages)
{
    return m_database.execute("PRAGMA max_page_count = " + std::to_string(pages));
}

} // namespace agv::recording
