// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/sqlite_database.h"

#include <sqlite3.h>

#include <system_error>

namespace agv::recording {
namespace {

/// Another program that looks into a run holds it for moments only.
constexpr int patienceWithReaders_ms = 2000;

int flagsFor(SqliteDatabase::Access access)
{
    switch (access) {
    case SqliteDatabase::Access::Create:
        return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
    case SqliteDatabase::Access::ReadRecover:
        return SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX;
    case SqliteDatabase::Access::ReadOnly:
        break;
    }
    return SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX;
}

std::unexpected<Error> errorFor(const std::filesystem::path& path, sqlite3* handle)
{
    const int code = handle ? sqlite3_errcode(handle) & 0xff : SQLITE_NOMEM;
    const int number = handle ? sqlite3_system_errno(handle) : 0;
    const std::string where = path.string() + ": ";
    const std::string says = handle ? sqlite3_errmsg(handle) : "out of memory";
    switch (code) {
    case SQLITE_FULL:
        return failure(ErrorCode::Io, where + "the disk is full: free some space, then record again");
    case SQLITE_READONLY:
    case SQLITE_PERM:
        return failure(ErrorCode::Permission,
                       where + "must not be written here: choose a folder that you may write into");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return failure(ErrorCode::InUse, where + "is used by another program: close that one");
    case SQLITE_ERROR: // a table or a column is not there
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
        return failure(ErrorCode::BadInput,
                       where + "is damaged or no run (" + says + "): use a copy of it, if there is one");
    case SQLITE_CANTOPEN:
        return failure(std::filesystem::exists(path.parent_path()) ? ErrorCode::Permission
                                                                   : ErrorCode::NotFound,
                       where + "cannot be opened: look whether it is there and may be read and written");
    default:
        break;
    }
    const std::string reason = number != 0 ? std::generic_category().message(number) : says;
    return failure(ErrorCode::Io, where + "reading or writing failed (" + reason +
                                      "): look after the disk and the space on it");
}

} // namespace

void SqliteDatabase::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

void SqliteStatement::Finalize::operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }

Result<SqliteDatabase> SqliteDatabase::open(const std::filesystem::path& path, Access access)
{
    sqlite3* raw = nullptr;
    const int status = sqlite3_open_v2(path.c_str(), &raw, flagsFor(access), nullptr);
    SqliteDatabase database(Handle(raw), path);
    if (status != SQLITE_OK)
        return errorFor(path, raw);
    sqlite3_busy_timeout(raw, patienceWithReaders_ms);
    sqlite3_extended_result_codes(raw, 0);
    return database;
}

Result<void> SqliteDatabase::execute(const std::string& sql)
{
    if (sqlite3_exec(m_handle.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
        return lastError();
    return {};
}

Result<SqliteStatement> SqliteDatabase::prepare(std::string_view sql)
{
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v3(m_handle.get(), sql.data(), static_cast<int>(sql.size()),
                           SQLITE_PREPARE_PERSISTENT, &statement, nullptr) != SQLITE_OK)
        return lastError();
    return SqliteStatement(statement);
}

std::unexpected<Error> SqliteDatabase::lastError() const { return errorFor(m_path, m_handle.get()); }

void SqliteStatement::bind(int parameter, std::int64_t value)
{
    sqlite3_bind_int64(m_handle.get(), parameter + 1, value);
}

void SqliteStatement::bindNull(int parameter) { sqlite3_bind_null(m_handle.get(), parameter + 1); }

void SqliteStatement::bindText(int parameter, std::string_view text)
{
    sqlite3_bind_text(m_handle.get(), parameter + 1, text.data(), static_cast<int>(text.size()),
                      SQLITE_STATIC);
}

void SqliteStatement::bindBytes(int parameter, std::string_view bytes)
{
    // A null pointer would become NULL; no bytes are an empty blob.
    sqlite3_bind_blob(m_handle.get(), parameter + 1, bytes.empty() ? "" : bytes.data(),
                      static_cast<int>(bytes.size()), SQLITE_STATIC);
}

Result<bool> SqliteStatement::step(const SqliteDatabase& database)
{
    const int status = sqlite3_step(m_handle.get());
    if (status == SQLITE_ROW)
        return true;
    if (status != SQLITE_DONE) {
        const std::unexpected<Error> error = database.lastError(); // reset() would forget it
        reset();
        return error;
    }
    reset();
    return false;
}

Result<void> SqliteStatement::run(const SqliteDatabase& database)
{
    const Result<bool> row = step(database);
    if (!row)
        return std::unexpected(row.error());
    if (*row)
        reset();
    return {};
}

void SqliteStatement::reset() { sqlite3_reset(m_handle.get()); }

SqliteStatement::Type SqliteStatement::type(int column) const
{
    switch (sqlite3_column_type(m_handle.get(), column)) {
    case SQLITE_NULL:
        return Type::Null;
    case SQLITE_INTEGER:
        return Type::Integer;
    case SQLITE_FLOAT:
        return Type::Float;
    default:
        return Type::Bytes;
    }
}

std::int64_t SqliteStatement::integer(int column) const
{
    return sqlite3_column_int64(m_handle.get(), column);
}

std::string_view SqliteStatement::bytes(int column) const
{
    const void* data = sqlite3_column_blob(m_handle.get(), column);
    const int size = sqlite3_column_bytes(m_handle.get(), column);
    return data ? std::string_view(static_cast<const char*>(data), static_cast<std::size_t>(size))
                : std::string_view();
}

} // namespace agv::recording
