// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tag_csv.h"

#include "core/file_units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <unordered_map>

namespace agv {
namespace {

constexpr long double mostMm = 1e6L; // as in a plant file
constexpr int mostNumber = 1'000'000'000;

enum Column : std::size_t { Uid, X, Y, Number, ColumnCount };
constexpr std::array<std::string_view, ColumnCount> columnNames{"uid", "x_mm", "y_mm", "number"};

std::string_view trimmed(std::string_view field)
{
    constexpr std::string_view blanks = " \t\r";
    const auto begin = field.find_first_not_of(blanks);
    if (begin == std::string_view::npos)
        return {};
    field = field.substr(begin, field.find_last_not_of(blanks) - begin + 1);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
        field = field.substr(1, field.size() - 2);
    return field;
}

constexpr auto absent = static_cast<std::size_t>(-1);

/// Fields of a line; a separator between quotation marks does not separate.
std::vector<std::string_view> split(std::string_view line, char separator)
{
    std::vector<std::string_view> fields;
    std::size_t begin = 0;
    bool isQuoted = false;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i == line.size() || (line[i] == separator && !isQuoted)) {
            fields.push_back(trimmed(line.substr(begin, i - begin)));
            begin = i + 1;
        } else if (line[i] == '"') {
            isQuoted = !isQuoted;
        }
    }
    return fields;
}

std::string lowered(std::string_view text)
{
    std::string out(text);
    for (char& c : out)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return out;
}

/// A field for a message: short, and without bytes that would garble a terminal.
std::string shown(std::string_view field)
{
    std::string text = "'" + std::string(field.substr(0, 40)) + (field.size() > 40 ? "...'" : "'");
    for (char& c : text)
        c = c < ' ' || c == '\x7F' ? '?' : c;
    return text;
}

class TagTable {
public:
    explicit TagTable(std::string_view name) : m_name(name) {}

    Result<std::vector<FloorTag>> read(std::string_view text)
    {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
        if (text.starts_with(byteOrderMark))
            text.remove_prefix(byteOrderMark.size());
        while (!text.empty() && !m_error) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            ++m_line;
            readLine(text.substr(0, end));
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        if (!m_error && !m_hasHeader) {
            m_line = std::max(m_line, 1);
            fail("is empty; expected a header such as uid,x_mm,y_mm,number");
        }
        if (m_error)
            return std::unexpected(*m_error);
        return std::move(m_tags);
    }

private:
    void fail(const std::string& reason)
    {
        if (!m_error)
            m_error = Error{ErrorCode::BadInput,
                            std::string(m_name) + ":" + std::to_string(m_line) + ": " + reason};
    }

    void readLine(std::string_view line)
    {
        if (trimmed(line).empty())
            return;
        if (m_hasHeader)
            readTag(split(line, m_separator));
        else
            readHeader(line);
    }

    void readHeader(std::string_view line)
    {
        m_hasHeader = true;
        m_separator = line.contains(';') ? ';' : ',';
        const auto fields = split(line, m_separator);
        m_fieldCount = fields.size();
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const auto column = std::find(columnNames.begin(), columnNames.end(), lowered(fields[i]));
            if (column == columnNames.end())
                continue;
            auto& place = m_places[static_cast<std::size_t>(column - columnNames.begin())];
            if (place != absent)
                return fail("the header has the column " + std::string(*column) + " twice; remove one");
            place = i;
        }
        for (const Column required : {Uid, X, Y}) {
            if (m_places[required] == absent)
                return fail("the header has no column " + std::string(columnNames[required]) +
                            "; expected uid,x_mm,y_mm,number (is " + shown(trimmed(line)) + ")");
        }
    }

    void readTag(const std::vector<std::string_view>& fields)
    {
        if (fields.size() != m_fieldCount) {
            const char* const help =
                m_separator == ',' ? "; numbers with a decimal comma need semicolons between the fields" : "";
            return fail("has " + std::to_string(fields.size()) + " fields, the header has " +
                        std::to_string(m_fieldCount) + help);
        }
        const auto uid = parseTagUid(fields[m_places[Uid]]);
        if (!uid)
            return fail("uid: must be 1 to 16 hexadecimal digits (is " + shown(fields[m_places[Uid]]) + ")");
        const FloorTag tag{*uid, {readMm(X, fields), readMm(Y, fields)}, readNumber(fields)};
        const auto [first, isNew] = m_lineOf.emplace(tag.uid, m_line);
        if (!isNew)
            fail("uid: tag " + fullText(tag.uid) + " is already in line " + std::to_string(first->second) +
                 "; every tag has its own UID");
        m_tags.push_back(tag);
    }

    double readMm(Column column, const std::vector<std::string_view>& fields)
    {
        std::string text(fields[m_places[column]]);
        if (m_separator == ';')
            std::replace(text.begin(), text.end(), ',', '.');
        long double value = 0.0L;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool isNumber = error == std::errc{} && stop == end;
        if (!isNumber || !(value >= -mostMm && value <= mostMm))
            fail(std::string(columnNames[column]) + ": must be a number between -1000000 and 1000000 (is " +
                 shown(fields[m_places[column]]) + ")");
        return fromThousandths(value);
    }

    int readNumber(const std::vector<std::string_view>& fields)
    {
        const int placeInTable = static_cast<int>(m_tags.size()) + 1;
        const std::string_view text =
            m_places[Number] != absent ? fields[m_places[Number]] : std::string_view();
        if (text.empty())
            return placeInTable;
        int number = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool isNumber = error == std::errc{} && stop == text.data() + text.size();
        if (!isNumber || number < 0 || number > mostNumber)
            fail("number: must be a whole number from 0 to 1000000000 (is " + shown(text) + ")");
        return number;
    }

    std::string_view m_name;
    int m_line = 0;
    bool m_hasHeader = false;
    char m_separator = ',';
    std::size_t m_fieldCount = 0;
    std::array<std::size_t, ColumnCount> m_places{absent, absent, absent, absent}; ///< field of each column
    std::vector<FloorTag> m_tags;
    std::unordered_map<TagUid, int> m_lineOf;
    std::optional<Error> m_error;
};

} // namespace

Result<std::vector<FloorTag>> readTagCsv(std::string_view text, std::string_view name)
{
    return TagTable(name).read(text);
}

std::string writeTagCsv(const std::vector<FloorTag>& tags)
{
    std::string text = "uid,x_mm,y_mm,number\n";
    for (const FloorTag& tag : tags)
        text += fullText(tag.uid) + "," + decimalText(toThousandths(tag.position.x)) + "," +
                decimalText(toThousandths(tag.position.y)) + "," + std::to_string(tag.number) + "\n";
    return text;
}

} // namespace agv
