// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/csv_table.h"

#include <algorithm>

namespace agv::recording {

namespace {

char lowered(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool isSameName(std::string_view a, std::string_view b)
{
    return std::ranges::equal(a, b, [](char x, char y) { return lowered(x) == lowered(y); });
}

bool isPassedOver(std::string_view line)
{
    const std::string_view text = trimmed(line);
    return text.empty() || text.starts_with('#');
}

/// The separator that the header has, commas first.
char separatorOf(std::string_view header)
{
    for (const char separator : {',', ';', '\t'})
        if (header.find(separator) != std::string_view::npos)
            return separator;
    return ',';
}

} // namespace

Result<CsvTable> CsvTable::open(std::string_view text)
{
    CsvTable table;
    table.m_lines = linesOf(text);
    while (table.m_next < table.m_lines.size() && isPassedOver(table.m_lines[table.m_next].text))
        ++table.m_next;
    if (table.m_next == table.m_lines.size())
        return failure(ErrorCode::BadInput, "is empty; expected a header and rows");
    const TextLine header = table.m_lines[table.m_next++];
    table.m_headerLine = table.m_line = header.number;
    table.m_separator = separatorOf(header.text);
    table.split(header.text);
    table.m_header = table.m_fields;
    return table;
}

std::optional<std::size_t> CsvTable::column(std::string_view name) const
{
    const auto found = std::ranges::find_if(
        m_header, [name](const std::string& column) { return isSameName(column, name); });
    if (found == m_header.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - m_header.begin());
}

bool CsvTable::next()
{
    while (m_next < m_lines.size()) {
        const TextLine& line = m_lines[m_next++];
        if (isPassedOver(line.text))
            continue;
        m_line = line.number;
        split(line.text);
        return true;
    }
    return false;
}

std::string_view CsvTable::field(std::size_t column) const
{
    return column < m_fields.size() ? std::string_view(m_fields[column]) : std::string_view();
}

std::optional<double> CsvTable::number(std::size_t column) const
{
    const std::string_view text = field(column);
    if (m_separator == ',' || text.find(',') == std::string_view::npos)
        return parseNumber(text);
    std::string point(text);
    std::ranges::replace(point, ',', '.');
    return parseNumber(point);
}

std::optional<int> CsvTable::integer(std::size_t column) const { return parseInteger(field(column)); }

std::string CsvTable::wrongNumber(std::size_t column) const
{
    return header()[column] + ": must be a number (is " + inQuotes(field(column)) + ")";
}

void CsvTable::split(std::string_view line)
{
    m_fields.clear();
    std::string field;
    bool isQuoted = false;
    bool wasQuoted = false;
    const auto endField = [&] {
        m_fields.emplace_back(wasQuoted ? std::string_view(field) : trimmed(field));
        field.clear();
        wasQuoted = false;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (isQuoted && c == '"' && line.substr(i + 1).starts_with('"')) {
            field += c;
            ++i;
        } else if (isQuoted && c == '"') {
            isQuoted = false;
        } else if (!isQuoted && c == '"' && trimmed(field).empty()) {
            isQuoted = wasQuoted = true;
            field.clear();
        } else if (!isQuoted && c == m_separator) {
            endField();
        } else {
            field += c;
        }
    }
    endField();
}

} // namespace agv::recording
