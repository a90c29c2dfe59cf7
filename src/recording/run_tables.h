// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/run_rows.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace agv::recording {

/// How a column is stored and how a table for people shows it. Numbers are whole: micrometres,
/// microdegrees, millionths. That is a thousandth of what the devices resolve, takes a third of the room of
/// floating point, and its decimal text is exact.
enum class ColumnKind : std::uint8_t {
    Whole,     ///< an integer
    Decimal,   ///< an integer; the table shows it with RunColumn::decimals digits behind the point
    Word,      ///< an index into RunColumn::words
    TagNumber, ///< the 64 bits of a floor tag's UID; 16 hexadecimal digits
    Text
};

struct RunColumn {
    const char* name;  ///< in the database, with the unit it is stored in: "x_um"
    const char* title; ///< in the CSV file, with the unit it is shown in: "x_mm"
    ColumnKind kind = ColumnKind::Whole;
    int decimals = 0;
    std::span<const char* const> words = {};
};

/// One kind of row. Every table begins with the column t_ns, nanoseconds of the monotonic clock since the run
/// began; it is not among `columns`. Rows stand in the order in which they happened.
struct RunTable {
    const char* name; ///< of the table and of the CSV file
    std::span<const RunColumn> columns;
};

inline constexpr std::size_t runTableCount = std::variant_size_v<RunRow>;
inline constexpr std::size_t mostRunColumns = 11;

/// In the order of RunRow.
std::span<const RunTable, runTableCount> runTables();

/// A value as it is stored; text points into the row it was made of.
using RunCell = std::variant<std::monostate, std::int64_t, std::string_view>;

struct RunCells {
    std::size_t table = 0; ///< index into runTables()
    Time time;
    std::size_t count = 0;
    std::array<RunCell, mostRunColumns> cells;
};

/// The cells of a row, in the order of its table's columns.
RunCells cellsOf(const RunRow& row);

/// SQL that makes the tables of an empty run.
std::string runSchema();
/// "INSERT INTO ranges VALUES (?, ...)", t_ns first.
std::string insertStatement(const RunTable& table);

} // namespace agv::recording
