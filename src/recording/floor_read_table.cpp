// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/floor_read_table.h"

#include "recording/csv_table.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace agv::recording {

namespace {

struct FloorReadLayout {
    std::size_t time = 0;
    std::optional<std::size_t> x;
    std::optional<std::size_t> y;
    std::vector<std::size_t> uids;
};

Result<FloorReadLayout> floorReadLayoutOf(const CsvTable& table)
{
    FloorReadLayout layout;
    const auto time = table.column("t_s");
    if (const auto one = table.column("uid"))
        layout.uids.push_back(*one);
    for (int k = 1; const auto column = table.column("uid" + std::to_string(k)); ++k)
        layout.uids.push_back(*column);
    layout.x = table.column("x_m");
    layout.y = table.column("y_m");
    if (!time || (layout.uids.empty() && !(layout.x && layout.y)))
        return failure(ErrorCode::BadInput,
                       std::to_string(table.headerLine()) +
                           ": the header is not one of floor tags read; expected t_s and x_m,y_m or uid or "
                           "uid1,uid2,...");
    layout.time = *time;
    return layout;
}

std::string capitals(std::string_view text)
{
    std::string result(trimmed(text));
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
}

bool isHexadecimal(std::string_view text)
{
    return !text.empty() && text.size() <= 16 &&
           std::ranges::all_of(text, [](unsigned char c) { return std::isxdigit(c) != 0; });
}

/// Adds to the row of the same time, or begins one.
std::string takeRow(const CsvTable& table, const FloorReadLayout& layout, std::vector<FloorReadRow>& rows)
{
    const auto time_s = table.number(layout.time);
    if (!time_s)
        return table.wrongNumber(layout.time);
    if (!rows.empty() && *time_s < rows.back().time_s)
        return "t_s: steps back; reads must be in the order of time";
    FloorReadRow row{.line = table.line(), .time_s = *time_s, .uids = {}, .x_m = {}, .y_m = {}};
    for (const std::size_t column : layout.uids) {
        const std::string uid = capitals(table.field(column));
        if (uid.empty())
            continue;
        if (!isHexadecimal(uid))
            return table.header()[column] + ": must be a tag in hexadecimal (is " +
                   inQuotes(table.field(column)) + ")";
        row.uids.push_back(uid);
    }
    if (layout.uids.empty() && !(table.field(*layout.x).empty() && table.field(*layout.y).empty())) {
        row.x_m = table.number(*layout.x);
        row.y_m = table.number(*layout.y);
        if (!row.x_m || !row.y_m)
            return table.wrongNumber(row.x_m ? *layout.y : *layout.x);
    }
    if (row.uids.empty() && !row.x_m)
        return {};
    if (!row.x_m && !rows.empty() && rows.back().time_s == row.time_s)
        std::ranges::move(row.uids, std::back_inserter(rows.back().uids));
    else
        rows.push_back(std::move(row));
    return {};
}

Error nothingRead(const FileProblems& problems, const char* what)
{
    const auto& kept = problems.kept();
    return {ErrorCode::BadInput,
            kept.empty() ? what : std::to_string(kept.front().line) + ": " + kept.front().reason};
}

} // namespace

Result<FloorReadTable> readFloorReadCsv(std::string_view text)
{
    auto table = CsvTable::open(text);
    if (!table)
        return std::unexpected(table.error());
    const auto layout = floorReadLayoutOf(*table);
    if (!layout)
        return std::unexpected(layout.error());
    FloorReadTable reads;
    while (table->next()) {
        std::string reason = takeRow(*table, *layout, reads.rows);
        if (!reason.empty())
            reads.problems.add(table->line(), std::move(reason));
    }
    if (reads.rows.empty())
        return std::unexpected(nothingRead(reads.problems, "holds no read of a floor tag"));
    return reads;
}

Result<TagPlaceTable> readTagPlaceCsv(std::string_view text)
{
    auto table = CsvTable::open(text);
    if (!table)
        return std::unexpected(table.error());
    const auto uid = table->column("uid") ? table->column("uid") : table->column("uid_tail");
    const bool inMm = table->column("x_mm") && table->column("y_mm");
    const auto x = table->column(inMm ? "x_mm" : "x_m");
    const auto y = table->column(inMm ? "y_mm" : "y_m");
    if (!uid || !x || !y)
        return failure(ErrorCode::BadInput,
                       std::to_string(table->headerLine()) +
                           ": the header is not one of floor tags; expected uid,x_mm,y_mm");
    TagPlaceTable places;
    const double unit = inMm ? 1e-3 : 1.0;
    while (table->next()) {
        const std::string name = capitals(table->field(*uid));
        const auto east = table->number(*x);
        const auto north = table->number(*y);
        if (!isHexadecimal(name))
            places.problems.add(table->line(), "uid: must be hexadecimal (is " + inQuotes(name) + ")");
        else if (!east || !north)
            places.problems.add(table->line(), table->wrongNumber(east ? *y : *x));
        else
            places.tags.push_back({name, *east * unit, *north * unit});
    }
    if (places.tags.empty())
        return std::unexpected(nothingRead(places.problems, "holds no floor tag"));
    return places;
}

} // namespace agv::recording
