// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/table_turns.h"

#include "recording/csv_text.h"
#include "recording/tag_numbers.h"
#include "recording/turn_limits.h"

#include <algorithm>
#include <array>
#include <ranges>
#include <span>

namespace agv::recording {

namespace {

constexpr std::size_t seedTagColumns = 7;

/// The separator that the line has; a semicolon or tab is never part of a number, so they come first.
std::optional<char> separatorIn(std::string_view line)
{
    for (const char separator : {';', '\t', ','}) {
        if (line.find(separator) != std::string_view::npos)
            return separator;
    }
    return std::nullopt;
}

/// Cells without blanks and quotes around them.
std::vector<std::string_view> cellsOf(std::string_view line)
{
    const auto separator = separatorIn(line);
    std::vector<std::string_view> cells;
    while (separator) {
        const std::size_t end = line.find(*separator);
        std::string_view cell = trimmed(line.substr(0, end));
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
            cell = trimmed(cell.substr(1, cell.size() - 2));
        cells.push_back(cell);
        if (end == std::string_view::npos)
            break;
        line.remove_prefix(end + 1);
    }
    return cells;
}

bool isUid(std::string_view cell) { return cell.size() == 16 && parseTagUid(cell).has_value(); }

bool isNumberOrUid(std::string_view cell) { return parseInteger(cell) || isUid(cell); }

/// A row of empty cells is a stop without reads; only a line without separators parts two tables.
bool endsTable(std::string_view line) { return trimmed(line).empty() && !separatorIn(line); }

bool isTitleRow(const std::vector<std::string_view>& cells)
{
    return std::ranges::any_of(cells, [](std::string_view cell) { return !cell.empty(); }) &&
           std::ranges::none_of(cells, isNumberOrUid);
}

std::expected<TurnStop, std::string> stopOf(const std::vector<std::string_view>& cells, std::size_t firstTag,
                                            const TagNumbers& numbers)
{
    if (cells.size() < firstTag + 2 || cells.size() % 2 != 0)
        return std::unexpected("a row must have as many columns of tags as of RSSI, not " +
                               std::to_string(cells.size()) + " in all");
    const std::size_t tagColumns = (cells.size() - firstTag) / 2;
    TurnStop stop;
    for (std::size_t column = firstTag; column < firstTag + tagColumns; ++column) {
        const std::string_view tagCell = cells[column];
        const std::string_view rssiCell = cells[column + tagColumns];
        if (tagCell.empty() && rssiCell.empty())
            continue;
        const auto tag = numbers.parse(tagCell);
        if (!tag)
            return std::unexpected("column " + std::to_string(column + 1) + ": " + inQuotes(tagCell) +
                                   " is not a tag; expected a number from 1 or the 16 digits of a UID");
        const auto rssi = parseInteger(rssiCell);
        if (!rssi || *rssi < leastRssi || *rssi > mostRssi)
            return std::unexpected("column " + std::to_string(column + tagColumns + 1) + ": RSSI " +
                                   inQuotes(rssiCell) + " is not a whole number from 0 to 7");
        stop.reads.push_back({Time{}, *tag, *rssi});
    }
    return stop;
}

/// Stop, reads, tags, RSSI: the window's table of stops as it is copied. There the last column of tags, the
/// first of RSSI in any other table, holds a whole UID in the fullest row; or no row has a tag, and then all
/// that is filled are the numbers of the stops and no reads.
bool isCopiedRow(const std::vector<std::string_view>& cells)
{
    if (cells.size() < 4 || cells.size() % 2 != 0 || !parseInteger(cells[0]) || !parseInteger(cells[1]))
        return false;
    const bool isEmpty =
        std::ranges::all_of(cells | std::views::drop(2), [](std::string_view cell) { return cell.empty(); });
    return isEmpty ? cells[1] == "0" : isUid(cells[cells.size() / 2]);
}

/// The rows from the first of a table on: is it a copied one?
bool isCopiedTable(std::span<const TextLine> lines)
{
    const auto end = std::ranges::find_if(lines, [](const TextLine& line) { return endsTable(line.text); });
    return std::any_of(lines.begin(), end,
                       [](const TextLine& line) { return isCopiedRow(cellsOf(line.text)); });
}

/// Appendix E: the tag whose number is the row's first RSSI.
void addTagLostByTheOldProgram(TurnStop& stop, const TagNumbers& numbers)
{
    if (stop.reads.empty() || stop.reads.front().rssi < 1)
        return;
    const TagUid lost = numbers.uidOf(stop.reads.front().rssi);
    if (numbers.knows(lost) && std::ranges::find(stop.reads, lost, &TagRead::uid) == stop.reads.end())
        stop.unknownIfUnseen.push_back(lost);
}

/// The turn that rows are being added to.
struct Table {
    int line = 0;
    TurnRecord record;
    bool isCopied = false;                  ///< the stop's number and its reads stand before the tags
    std::optional<TurnFileProblem> problem; ///< the first
    std::size_t columns = 0;
};

void addRow(Table& table, const TextLine& line, const TagNumbers& numbers)
{
    if (table.problem)
        return;
    const std::vector<std::string_view> cells = cellsOf(line.text);
    const auto refuse = [&](std::string reason) {
        table.problem = TurnFileProblem{line.number, std::move(reason)};
    };
    const std::size_t firstTag = table.isCopied ? std::min<std::size_t>(2, cells.size()) : 0;
    auto stop = stopOf(cells, firstTag, numbers);
    if (!stop)
        return refuse(stop.error());
    if (table.columns != 0 && table.columns != cells.size())
        return refuse("the row has " + std::to_string(cells.size()) + " columns, the one before it " +
                      std::to_string(table.columns));
    if (table.record.stops.size() == mostStops)
        return refuse("more than " + std::to_string(mostStops) + " stops");
    table.columns = cells.size();
    if (!table.isCopied && cells.size() == 2 * seedTagColumns && std::ranges::none_of(cells, isUid))
        addTagLostByTheOldProgram(*stop, numbers);
    table.record.stops.push_back(std::move(*stop));
}

} // namespace

std::string tableText(std::span<const StopRow> rows)
{
    std::size_t tagColumns = seedTagColumns;
    for (const StopRow& row : rows)
        tagColumns = std::max(tagColumns, row.tags.size());
    std::string text;
    for (const StopRow& row : rows) {
        std::vector<std::string> cells(2 * tagColumns);
        for (std::size_t tag = 0; tag < row.tags.size(); ++tag) {
            cells[tag] = fullText(row.tags[tag].first);
            cells[tag + tagColumns] = std::to_string(row.tags[tag].second);
        }
        text += csvLine(cells);
    }
    return text;
}

bool looksLikeTableRow(std::string_view line)
{
    const std::vector<std::string_view> cells = cellsOf(line);
    return cells.size() >= 2 && std::ranges::all_of(cells, [](std::string_view cell) {
               return cell.empty() || isNumberOrUid(cell);
           });
}

std::vector<RecordedTurn> readTableTurns(const std::vector<TextLine>& lines, const TurnFileOptions& options)
{
    const TagNumbers numbers(options.tags);
    std::vector<RecordedTurn> turns;
    std::optional<Table> table;
    const auto finish = [&] {
        if (table && table->problem)
            turns.push_back({table->line, std::unexpected(*table->problem)});
        else if (table)
            turns.push_back({table->line, std::move(table->record)});
        table.reset();
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const TextLine& line = lines[i];
        if (trimmed(line.text).starts_with('#'))
            continue;
        if (endsTable(line.text)) {
            finish();
            continue;
        }
        if (!table) {
            if (isTitleRow(cellsOf(line.text)))
                continue;
            table = Table{line.number, {}, isCopiedTable(std::span(lines).subspan(i)), {}, 0};
            table->record.nominalStep = options.nominalStep;
            table->record.turnTime_s = options.turnTime_s;
        }
        addRow(*table, line, numbers);
    }
    finish();
    return turns;
}

} // namespace agv::recording
