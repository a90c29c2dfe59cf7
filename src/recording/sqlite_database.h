// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

struct sqlite3;
struct sqlite3_stmt;

namespace agv::recording {

class SqliteStatement;

/// One open SQLite database. Owned and used by one thread at a time; closes itself. Every failure is an
/// Error that names the file, what SQLite says of it, and what to do.
class SqliteDatabase {
public:
    enum class Access {
        Create,      ///< read and write; made when missing
        ReadRecover, ///< read; what a killed writer left in its log is taken in, which needs a writable
                     ///< folder
        ReadOnly     ///< read; the file and its folder are not touched
    };
    /// NotFound, Permission, or as errorFor().
    static Result<SqliteDatabase> open(const std::filesystem::path& path, Access access);

    /// Statements without results or parameters, parted by semicolons.
    Result<void> execute(const std::string& sql);
    Result<SqliteStatement> prepare(std::string_view sql);
    const std::filesystem::path& path() const { return m_path; }

    /// What the last call of SQLite that failed means to the operator: Io for a full disk or one that fails,
    /// Permission for a disk that became read-only, InUse for a file somebody else writes, BadInput for one
    /// that is damaged.
    std::unexpected<Error> lastError() const;

private:
    struct Close {
        void operator()(sqlite3* handle) const;
    };
    using Handle = std::unique_ptr<sqlite3, Close>;
    SqliteDatabase(Handle handle, std::filesystem::path path)
        : m_handle(std::move(handle)),
          m_path(std::move(path))
    {}

    Handle m_handle;
    std::filesystem::path m_path;
};

/// A prepared statement; must not outlive its database. Parameters and columns count from 0.
class SqliteStatement {
public:
    void bind(int parameter, std::int64_t value);
    void bindNull(int parameter);
    /// The text must live until the next step(). Bytes are written as they are.
    void bindText(int parameter, std::string_view text);
    void bindBytes(int parameter, std::string_view bytes);

    /// True: there is a row. False: done, and the statement is ready for new parameters.
    Result<bool> step(const SqliteDatabase& database);
    /// For statements without rows.
    Result<void> run(const SqliteDatabase& database);
    void reset();

    enum class Type { Null, Integer, Float, Bytes };
    Type type(int column) const;
    std::int64_t integer(int column) const;
    /// Of a text or a blob; valid until the next step().
    std::string_view bytes(int column) const;

private:
    friend class SqliteDatabase;
    struct Finalize {
        void operator()(sqlite3_stmt* handle) const;
    };
    explicit SqliteStatement(sqlite3_stmt* handle) : m_handle(handle) {}

    std::unique_ptr<sqlite3_stmt, Finalize> m_handle;
};

} // namespace agv::recording
