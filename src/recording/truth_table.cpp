// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/truth_table.h"

#include "recording/csv_table.h"

#include <algorithm>
#include <iterator>

namespace agv::recording {

namespace {

/// Columns of the place of one tag.
struct PlaceColumns {
    std::optional<int> tag; ///< of a wide table
    std::size_t x = 0;
    std::size_t y = 0;
    std::optional<std::size_t> z;
};

struct TruthLayout {
    std::optional<std::size_t> time;
    std::optional<std::size_t> tag;
    std::vector<PlaceColumns> places;
    std::vector<std::size_t> others;
};

/// N of "tagN_x".
std::optional<int> tagOf(std::string_view column)
{
    if (!column.starts_with("tag") || !column.ends_with("_x"))
        return std::nullopt;
    const auto number = parseInteger(column.substr(3, column.size() - 5));
    return number && *number >= 0 ? number : std::nullopt;
}

void findPlaces(const CsvTable& table, TruthLayout& layout)
{
    const auto x = table.column("x_m");
    const auto y = table.column("y_m");
    if (x && y) {
        layout.places.push_back({{}, *x, *y, table.column("z_m")});
        return;
    }
    for (std::size_t place = 0; place < table.header().size(); ++place) {
        const auto tag = tagOf(table.header()[place]);
        const std::string name = tag ? "tag" + std::to_string(*tag) : std::string();
        const auto tagY = table.column(name + "_y");
        const auto tagZ = table.column(name + "_z");
        if (tag && tagY)
            layout.places.push_back({tag, place, *tagY, tagZ ? tagZ : table.column("body_z_m")});
    }
}

Result<TruthLayout> truthLayoutOf(const CsvTable& table)
{
    TruthLayout layout{.time = table.column("t_s"), .tag = table.column("tag"), .places = {}, .others = {}};
    findPlaces(table, layout);
    if (layout.places.empty())
        return failure(ErrorCode::BadInput,
                       std::to_string(table.headerLine()) +
                           ": the header names no place; expected x_m,y_m or tag0_x,tag0_y,...");
    std::vector<std::size_t> known;
    for (const auto& column : {layout.time, layout.tag})
        if (column)
            known.push_back(*column);
    for (const PlaceColumns& place : layout.places) {
        known.insert(known.end(), {place.x, place.y});
        if (place.z)
            known.push_back(*place.z);
    }
    for (std::size_t place = 0; place < table.header().size(); ++place)
        if (std::ranges::find(known, place) == known.end())
            layout.others.push_back(place);
    return layout;
}

std::string notANumber(const CsvTable& table, std::size_t column)
{
    return table.header()[column] + ": must be a number (is " + inQuotes(table.field(column)) + ")";
}

/// The first reason why the row cannot be used; empty when it can.
std::string takeRow(const CsvTable& table, const TruthLayout& layout, std::vector<TruePlace>& places)
{
    if (table.fieldCount() != table.header().size())
        return "has " + std::to_string(table.fieldCount()) + " fields, the header has " +
               std::to_string(table.header().size());
    TruePlace row;
    row.line = table.line();
    if (layout.time)
        row.time_s = table.number(*layout.time);
    if (layout.tag)
        row.tag = table.integer(*layout.tag);
    if (layout.time && !row.time_s)
        return notANumber(table, *layout.time);
    if (layout.tag && !row.tag)
        return notANumber(table, *layout.tag);
    for (const std::size_t column : layout.others)
        row.columns.emplace_back(table.field(column));
    for (const PlaceColumns& columns : layout.places) {
        if (table.field(columns.x).empty() && table.field(columns.y).empty())
            continue;
        const auto x = table.number(columns.x);
        const auto y = table.number(columns.y);
        if (!x || !y)
            return notANumber(table, x ? columns.y : columns.x);
        TruePlace place = row;
        place.x_m = *x;
        place.y_m = *y;
        if (columns.z) {
            place.z_m = table.number(*columns.z);
            if (!place.z_m && !table.field(*columns.z).empty())
                return notANumber(table, *columns.z);
        }
        if (columns.tag)
            place.tag = columns.tag;
        places.push_back(std::move(place));
    }
    return {};
}

} // namespace

std::optional<std::size_t> TruthTable::otherColumn(std::string_view name) const
{
    const auto found = std::ranges::find(otherColumns, name);
    if (found == otherColumns.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - otherColumns.begin());
}

Result<TruthTable> readTruthCsv(std::string_view text)
{
    auto table = CsvTable::open(text);
    if (!table)
        return std::unexpected(table.error());
    const auto layout = truthLayoutOf(*table);
    if (!layout)
        return std::unexpected(layout.error());
    TruthTable truth;
    for (const std::size_t column : layout->others)
        truth.otherColumns.push_back(table->header()[column]);
    while (table->next()) {
        std::vector<TruePlace> places;
        std::string reason = takeRow(*table, *layout, places);
        if (!reason.empty())
            truth.problems.add(table->line(), std::move(reason));
        else
            std::ranges::move(places, std::back_inserter(truth.places));
    }
    if (truth.places.empty()) {
        const auto& kept = truth.problems.kept();
        return failure(ErrorCode::BadInput,
                       kept.empty() ? "holds no place"
                                    : std::to_string(kept.front().line) + ": " + kept.front().reason);
    }
    return truth;
}

} // namespace agv::recording
