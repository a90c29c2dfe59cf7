// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_csv_rows.h"

#include "core/ids.h"
#include "recording/csv_text.h"

#include <array>
#include <charconv>

namespace agv::recording {
namespace {

constexpr const char* timeTitles = "t_utc,t_s";
constexpr const char* lineEnd = "\r\n";

void appendWhole(std::string& text, std::uint64_t value)
{
    std::array<char, 24> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
}

void appendNumberCell(std::string& text, const RunColumn& column, std::int64_t value)
{
    switch (column.kind) {
    case ColumnKind::Word:
        // A word of a later version stays a number.
        if (value >= 0 && static_cast<std::uint64_t>(value) < column.words.size()) {
            text += column.words[static_cast<std::size_t>(value)];
            return;
        }
        break;
    case ColumnKind::TagNumber:
        text += fullText(TagUid{static_cast<std::uint64_t>(value)});
        return;
    case ColumnKind::Whole:
    case ColumnKind::Decimal:
    case ColumnKind::Text:
        break;
    }
    appendDecimal(text, value, column.decimals);
}

} // namespace

void appendDecimal(std::string& text, std::int64_t value, int decimals)
{
    if (value < 0)
        text += '-';
    const std::uint64_t magnitude =
        value < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    const std::size_t start = text.size();
    appendWhole(text, magnitude);
    if (decimals == 0)
        return;
    const auto behindPoint = static_cast<std::size_t>(decimals);
    if (const std::size_t digits = text.size() - start; digits <= behindPoint)
        text.insert(start, behindPoint + 1 - digits, '0');
    text.insert(text.size() - behindPoint, 1, '.');
}

void appendEscapedBytes(std::string& text, std::string_view bytes)
{
    constexpr std::string_view hex = "0123456789ABCDEF";
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\\')
            text += "\\\\";
        else if (c == '\r')
            text += "\\r";
        else if (c == '\n')
            text += "\\n";
        else if (c == '\t')
            text += "\\t";
        else if (byte >= 0x20 && byte < 0x7f)
            text += c;
        else
            (text += "\\x").append({hex[byte >> 4], hex[byte & 0xf]});
    }
}

std::string CsvRowWriter::header(const RunTable& table)
{
    std::string line = timeTitles;
    for (const RunColumn& column : table.columns)
        line += std::string(",") + column.title;
    return line + lineEnd;
}

std::string CsvRowWriter::rawHeader() { return std::string(timeTitles) + ",link,bytes" + lineEnd; }

void CsvRowWriter::appendTimes(std::string& text, std::int64_t t_ns)
{
    const std::int64_t utc_us = m_run.utcAt_us(t_ns);
    const std::int64_t second = utc_us / 1'000'000;
    if (second != m_second || m_secondText.empty()) {
        m_second = second;
        m_secondText = utcText(second * 1000);
        m_secondText.resize(m_secondText.size() - std::string_view("000Z").size());
    }
    text += m_secondText;
    const std::int64_t milliseconds = utc_us / 1000 % 1000;
    for (const std::int64_t place : {100, 10, 1})
        text += static_cast<char>('0' + milliseconds / place % 10);
    text += "Z,";
    appendDecimal(text, t_ns, 9);
}

void CsvRowWriter::append(std::string& text, const RunTable& table, const RunReader::Row& row)
{
    appendTimes(text, row.t_ns);
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        text += ',';
        if (const auto* number = std::get_if<std::int64_t>(&row.cells[i]))
            appendNumberCell(text, table.columns[i], *number);
        else if (const auto* words = std::get_if<std::string_view>(&row.cells[i]))
            text += csvField(*words);
    }
    text += lineEnd;
}

void CsvRowWriter::appendRaw(std::string& text, const RunChunk& chunk)
{
    appendTimes(text, Duration(chunk.time.time_since_epoch()).count());
    text += ',';
    text += csvField(chunk.link);
    text += ',';
    m_scratch.clear();
    appendEscapedBytes(m_scratch, chunk.bytes);
    text += csvField(m_scratch);
    text += lineEnd;
}

} // namespace agv::recording
