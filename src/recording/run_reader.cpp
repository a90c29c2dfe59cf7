// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_reader.h"

#include "core/plant_file.h"
#include "recording/raw_block.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace agv::recording {
namespace {

/// Times of a run lie within a century of its beginning; others are damage, and would overflow sums.
constexpr std::int64_t farthest_ns = std::int64_t{3'000'000'000} * 1'000'000'000;

bool isTime(const SqliteStatement& statement, int column)
{
    const std::int64_t value = statement.integer(column);
    return statement.type(column) == SqliteStatement::Type::Integer && value > -farthest_ns &&
           value < farthest_ns;
}

std::string selectStatement(const RunTable& table)
{
    std::string sql = "SELECT t_ns";
    for (const RunColumn& column : table.columns)
        sql += std::string(", ") + column.name;
    return sql + " FROM " + table.name + " ORDER BY rowid";
}

/// Chunks of several blocks, the earliest first; of equal times the one of the earlier block.
struct PendingChunk {
    RunChunk chunk;
    std::size_t order = 0;
    bool operator<(const PendingChunk& other) const // the queue gives the greatest first
    {
        return std::tie(other.chunk.time, other.order) < std::tie(chunk.time, order);
    }
};

} // namespace

RunReader::RunReader(std::filesystem::path run, RunInfo info, SqliteDatabase database)
    : m_folder(std::move(run)),
      m_info(std::move(info)),
      m_database(std::move(database))
{}

Result<RunReader> RunReader::open(const std::filesystem::path& run)
{
    Result<RunInfo> info = readRunInfo(run);
    if (!info)
        return std::unexpected(info.error());
    const std::filesystem::path file = run / runDatabaseFile;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
        return failure(ErrorCode::NotFound, file.string() + ": is not there: this folder is no whole run");
    using Access = SqliteDatabase::Access;
    // A run on a disk that cannot be written is read as it is; one that needs repair there says so.
    for (const Access access : {Access::ReadRecover, Access::ReadOnly}) {
        Result<SqliteDatabase> database = SqliteDatabase::open(file, access);
        if (!database && access == Access::ReadRecover)
            continue;
        if (!database)
            return std::unexpected(database.error());
        RunReader reader(run, *info, std::move(*database));
        const Result<void> checked = reader.check();
        if (checked)
            return reader;
        if (access == Access::ReadOnly || checked.error().code != ErrorCode::Permission)
            return std::unexpected(checked.error());
    }
    std::unreachable();
}

std::unexpected<Error> RunReader::damaged(const std::string& what) const
{
    return failure(ErrorCode::BadInput, m_database.path().string() + ": is damaged (" + what +
                                            "): use a copy of it, if there is one");
}

Result<void> RunReader::check()
{
    // The file may be anybody's: nothing in it is computed, only read.
    Result<void> set = m_database.execute(
        "PRAGMA query_only = ON; PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON;");
    if (!set)
        return set;
    Result<SqliteStatement> others =
        m_database.prepare("SELECT count(*) FROM sqlite_schema WHERE type <> 'table'");
    if (!others)
        return std::unexpected(others.error());
    const Result<bool> row = others->step(m_database);
    if (!row)
        return std::unexpected(row.error());
    if (!*row || others->integer(0) != 0)
        return damaged("it holds more than tables");
    return readClocks();
}

Result<void> RunReader::readClocks()
{
    Result<SqliteStatement> select = m_database.prepare("SELECT t_ns, utc_us FROM clocks ORDER BY rowid");
    if (!select)
        return std::unexpected(select.error());
    while (true) {
        const Result<bool> row = select->step(m_database);
        if (!row)
            return std::unexpected(row.error());
        if (!*row)
            break;
        constexpr std::int64_t latest_us = farthest_ns / 1000;
        const std::int64_t utc_us = select->integer(1);
        if (!isTime(*select, 0) || utc_us < 0 || utc_us > 10 * latest_us)
            return damaged("its clock");
        m_clocks.push_back({select->integer(0), utc_us});
    }
    if (m_clocks.empty())
        return damaged("it has no clock");
    std::ranges::stable_sort(m_clocks, {}, &Clock::t_ns);
    return {};
}

Result<PlantLayout> RunReader::plant() const { return readPlantFile(m_folder / runPlantFile); }

Result<void> RunReader::rows(std::size_t table, const RowSink& sink)
{
    const RunTable& described = runTables()[table];
    Result<SqliteStatement> select = m_database.prepare(selectStatement(described));
    if (!select)
        return std::unexpected(select.error());
    std::array<RunCell, mostRunColumns> cells;
    const std::span<RunCell> used(cells.data(), described.columns.size());
    while (true) {
        const Result<bool> row = select->step(m_database);
        if (!row)
            return std::unexpected(row.error());
        if (!*row)
            return {};
        if (!isTime(*select, 0))
            return damaged(std::string("a time in the table ") + described.name);
        for (std::size_t i = 0; i < used.size(); ++i) {
            const int column = static_cast<int>(i) + 1;
            const SqliteStatement::Type type = select->type(column);
            const bool isText = described.columns[i].kind == ColumnKind::Text;
            if (type == SqliteStatement::Type::Null)
                used[i] = std::monostate();
            else if (type == SqliteStatement::Type::Integer && !isText)
                used[i] = select->integer(column);
            else if (type == SqliteStatement::Type::Bytes && isText)
                used[i] = select->bytes(column);
            else
                return damaged(std::string("a value in the table ") + described.name);
        }
        if (!sink({select->integer(0), used}))
            return {};
    }
}

Result<std::uint64_t> RunReader::count(const std::string& table)
{
    Result<SqliteStatement> select = m_database.prepare("SELECT count(*) FROM " + table);
    if (!select)
        return std::unexpected(select.error());
    const Result<bool> row = select->step(m_database);
    if (!row)
        return std::unexpected(row.error());
    return *row ? static_cast<std::uint64_t>(select->integer(0)) : 0;
}

Result<std::uint64_t> RunReader::countRows(std::size_t table) { return count(runTables()[table].name); }

Result<std::uint64_t> RunReader::countBlocks() { return count("raw"); }

Result<std::vector<std::string>> RunReader::linkNames()
{
    Result<SqliteStatement> select = m_database.prepare("SELECT name FROM links ORDER BY id");
    if (!select)
        return std::unexpected(select.error());
    std::vector<std::string> names;
    while (true) {
        const Result<bool> row = select->step(m_database);
        if (!row)
            return std::unexpected(row.error());
        if (!*row)
            return names;
        names.emplace_back(select->bytes(0));
    }
}

Result<std::vector<RunReader::BlockPlace>> RunReader::blockPlaces()
{
    Result<SqliteStatement> select = m_database.prepare("SELECT t_ns, rowid FROM raw ORDER BY rowid");
    if (!select)
        return std::unexpected(select.error());
    std::vector<BlockPlace> places;
    while (true) {
        const Result<bool> row = select->step(m_database);
        if (!row)
            return std::unexpected(row.error());
        if (!*row)
            break;
        if (!isTime(*select, 0))
            return damaged("a time in the table raw");
        places.push_back({select->integer(0), select->integer(1)});
    }
    std::ranges::stable_sort(places, {}, &BlockPlace::t_ns);
    return places;
}

Result<void> RunReader::chunks(const ChunkSink& sink)
{
    const Result<std::vector<std::string>> links = linkNames();
    if (!links)
        return std::unexpected(links.error());
    const Result<std::vector<BlockPlace>> places = blockPlaces();
    if (!places)
        return std::unexpected(places.error());
    Result<SqliteStatement> select = m_database.prepare("SELECT link, packed FROM raw WHERE rowid = ?");
    if (!select)
        return std::unexpected(select.error());

    std::priority_queue<PendingChunk> pending; // of blocks that overlap in time
    std::size_t order = 0;
    const auto giveUntil = [&](Time limit) {
        for (; !pending.empty() && pending.top().chunk.time < limit; pending.pop()) {
            if (!sink(pending.top().chunk))
                return false;
        }
        return true;
    };
    for (const BlockPlace& place : *places) {
        const Time first = Time{} + Duration(place.t_ns);
        if (!giveUntil(first))
            return {};
        select->reset();
        select->bind(0, place.row);
        const Result<bool> row = select->step(m_database);
        if (!row)
            return std::unexpected(row.error());
        const auto link = *row ? static_cast<std::uint64_t>(select->integer(0)) : 0;
        if (link == 0 || link > links->size())
            return damaged("a link in the table raw");
        Result<std::vector<RunChunk>> block =
            unpackChunks(select->bytes(1), first, (*links)[static_cast<std::size_t>(link) - 1]);
        if (!block)
            return damaged(block.error().detail);
        for (RunChunk& chunk : *block)
            pending.push({std::move(chunk), order++});
    }
    giveUntil(Time::max());
    return {};
}

std::int64_t RunReader::utcAt_us(std::int64_t t_ns) const
{
    const auto after = std::ranges::upper_bound(m_clocks, t_ns, {}, &Clock::t_ns);
    const Clock& clock = after == m_clocks.begin() ? *after : *(after - 1);
    const std::int64_t since_ns = t_ns - clock.t_ns;
    return clock.utc_us + (since_ns >= 0 ? since_ns / 1000 : (since_ns - 999) / 1000);
}

} // namespace agv::recording
