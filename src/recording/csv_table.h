// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/text_lines.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// Cuts a table with a header into rows. Fields are separated by commas or, where the header is, by
/// semicolons or tabs; then numbers may have a decimal comma. A field may be in quotes, with "" for a quote
/// in it; it ends in its line. Empty lines and lines beginning with # are passed over.
class CsvTable {
public:
    /// BadInput when there is no header.
    static Result<CsvTable> open(std::string_view text);

    const std::vector<std::string>& header() const { return m_header; }
    int headerLine() const { return m_headerLine; }
    /// Place of a column, whatever the case of its name.
    std::optional<std::size_t> column(std::string_view name) const;

    /// The next row; false at the end. Its fields are valid until the next call.
    bool next();
    int line() const { return m_line; }
    std::size_t fieldCount() const { return m_fields.size(); }
    /// @pre column < header().size(); empty where the row is too short
    std::string_view field(std::size_t column) const;
    /// A field as a number.
    std::optional<double> number(std::size_t column) const;
    std::optional<int> integer(std::size_t column) const;
    /// "NAME: must be a number (is "FIELD")"
    std::string wrongNumber(std::size_t column) const;

private:
    void split(std::string_view line);

    std::vector<TextLine> m_lines;
    std::size_t m_next = 0;
    int m_headerLine = 0;
    int m_line = 0;
    char m_separator = ',';
    std::vector<std::string> m_header;
    std::vector<std::string> m_fields;
};

} // namespace agv::recording
