// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/range_table.h"

#include "recording/csv_table.h"
#include "recording/csv_text.h"
#include "recording/number_text.h"

#include <algorithm>
#include <array>

namespace agv::recording {

namespace {

constexpr std::string_view tagAnchor = "tag-anchor";
constexpr std::string_view anchorAnchor = "anchor-anchor";
enum Column : std::size_t { Instant, Tag, Anchor, Range, Sequence, Kind, Period, ColumnCount };
constexpr std::array<std::string_view, ColumnCount> columnNames{"t_s", "tag",  "anchor",  "range_m",
                                                                "seq", "kind", "period_s"};
constexpr std::size_t requiredColumns = 4;

/// Where a table has which column.
struct RangeLayout {
    std::array<std::optional<std::size_t>, ColumnCount> places;
    std::vector<std::size_t> extras;
};

Result<RangeLayout> rangeLayoutOf(const CsvTable& table)
{
    RangeLayout layout;
    for (std::size_t column = 0; column < ColumnCount; ++column)
        layout.places[column] = table.column(columnNames[column]);
    for (std::size_t column = 0; column < requiredColumns; ++column)
        if (!layout.places[column])
            return failure(ErrorCode::BadInput,
                           std::to_string(table.headerLine()) + ": the header has no column " +
                               std::string(columnNames[column]) + "; expected t_s,tag,anchor,range_m");
    for (std::size_t place = 0; place < table.header().size(); ++place)
        if (std::ranges::find(layout.places, std::optional(place)) == layout.places.end())
            layout.extras.push_back(place);
    return layout;
}

/// Reads one row after the other; a reason says what is wrong with one.
class RowReader {
public:
    RowReader(const CsvTable& table, const RangeLayout& layout) : m_table(table), m_layout(layout) {}

    /// Empty reason: the row is good. `range_m` is 0 where nothing was measured.
    std::string read(RangeMeasurement& range)
    {
        if (m_table.fieldCount() != m_table.header().size())
            return "has " + std::to_string(m_table.fieldCount()) + " fields, the header has " +
                   std::to_string(m_table.header().size());
        const auto time_s = m_table.number(*m_layout.places[Instant]);
        if (!time_s)
            return wrong(Instant, "a number");
        const auto tag = id(Tag);
        if (!tag)
            return wrong(Tag, "a whole number from 0");
        const auto anchor = id(Anchor);
        if (!anchor)
            return wrong(Anchor, "a whole number from 0");
        range = {.time_s = *time_s, .tag = *tag, .anchor = *anchor};
        if (!takeRange(range))
            return wrong(Range, "a number");
        return readOptional(range);
    }

private:
    std::string wrong(Column column, std::string_view expected) const
    {
        return std::string(columnNames[column]) + ": must be " + std::string(expected) + " (is " +
               inQuotes(m_table.field(*m_layout.places[column])) + ")";
    }
    std::string_view field(Column column) const { return m_table.field(*m_layout.places[column]); }
    bool has(Column column) const { return m_layout.places[column] && !field(column).empty(); }

    std::optional<int> id(Column column) const
    {
        const auto value = m_table.integer(*m_layout.places[column]);
        return value && *value >= 0 ? value : std::nullopt;
    }

    bool takeRange(RangeMeasurement& range) const
    {
        const std::string_view text = field(Range);
        if (text.empty() || text == "nan" || text == "NaN" || text == "NAN" || text == "null")
            return true;
        const auto value = m_table.number(*m_layout.places[Range]);
        if (value)
            range.range_m = std::max(*value, 0.0);
        return value.has_value();
    }

    std::string readOptional(RangeMeasurement& range) const
    {
        if (has(Sequence)) {
            const auto sequence = id(Sequence);
            if (!sequence)
                return wrong(Sequence, "a whole number from 0");
            range.sequence = *sequence;
        }
        if (has(Kind)) {
            if (field(Kind) != tagAnchor && field(Kind) != anchorAnchor)
                return wrong(Kind, "tag-anchor or anchor-anchor");
            range.kind = field(Kind) == tagAnchor ? RangeKind::TagAnchor : RangeKind::AnchorAnchor;
        }
        if (has(Period)) {
            const auto period_s = m_table.number(*m_layout.places[Period]);
            if (!period_s || *period_s < 0.0)
                return wrong(Period, "a number from 0");
            range.reportPeriod_s = *period_s;
        }
        return {};
    }

    const CsvTable& m_table;
    const RangeLayout& m_layout;
};

bool isNumber(std::string_view text) { return parseNumber(text).has_value(); }

} // namespace

std::optional<std::size_t> RangeTable::extraColumn(std::string_view name) const
{
    const auto found = std::ranges::find(extraColumns, name);
    if (found == extraColumns.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - extraColumns.begin());
}

bool looksLikeRangeCsv(std::string_view text)
{
    const auto table = CsvTable::open(text);
    return table && table->column("t_s") && table->column("range_m");
}

Result<RangeTable> readRangeCsv(std::string_view text)
{
    auto csv = CsvTable::open(text);
    if (!csv)
        return std::unexpected(csv.error());
    const auto layout = rangeLayoutOf(*csv);
    if (!layout)
        return std::unexpected(layout.error());
    RangeTable table;
    for (const std::size_t place : layout->extras)
        table.extraColumns.push_back(csv->header()[place]);
    RowReader reader(*csv, *layout);
    while (csv->next()) {
        RangeMeasurement range;
        std::string reason = reader.read(range);
        if (!reason.empty()) {
            table.problems.add(csv->line(), std::move(reason));
            continue;
        }
        if (range.range_m <= 0.0) {
            ++table.notMeasured;
            continue;
        }
        table.ranges.push_back(range);
        for (const std::size_t place : layout->extras)
            table.extras.emplace_back(csv->field(place));
    }
    if (table.ranges.empty() && !table.problems.empty())
        return failure(ErrorCode::BadInput, std::to_string(table.problems.kept().front().line) + ": " +
                                                table.problems.kept().front().reason);
    return table;
}

std::string writeRangeCsv(const RangeTable& table)
{
    const auto any = [&table](auto has) { return std::ranges::any_of(table.ranges, has); };
    const bool hasSequence = any([](const RangeMeasurement& r) { return r.sequence >= 0; });
    const bool hasKind = any([](const RangeMeasurement& r) { return r.kind != RangeKind::TagAnchor; });
    const bool hasPeriod = any([](const RangeMeasurement& r) { return r.reportPeriod_s > 0.0; });

    std::string text = "t_s,tag,anchor,range_m";
    for (const auto& [has, column] : {std::pair(hasSequence, Sequence), {hasKind, Kind}, {hasPeriod, Period}})
        text += has ? "," + std::string(columnNames[column]) : std::string();
    for (const std::string& column : table.extraColumns)
        text += "," + csvField(column);
    text += '\n';
    for (std::size_t i = 0; i < table.ranges.size(); ++i) {
        const RangeMeasurement& range = table.ranges[i];
        text += exactNumberText(range.time_s) + "," + std::to_string(range.tag) + "," +
                std::to_string(range.anchor) + "," + exactNumberText(range.range_m);
        if (hasSequence)
            text += "," + (range.sequence >= 0 ? std::to_string(range.sequence) : std::string());
        if (hasKind)
            text += "," + std::string(range.kind == RangeKind::TagAnchor ? tagAnchor : anchorAnchor);
        if (hasPeriod)
            text += "," + exactNumberText(range.reportPeriod_s);
        for (std::size_t column = 0; column < table.extraColumns.size(); ++column) {
            const std::string_view extra = table.extra(i, column);
            text += ",";
            text += isNumber(extra) ? std::string(extra) : csvField(extra);
        }
        text += '\n';
    }
    return text;
}

} // namespace agv::recording
