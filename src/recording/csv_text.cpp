// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/csv_text.h"

namespace agv::recording {

std::string csvField(std::string_view text)
{
    constexpr std::string_view formulaStart = "=+-@\t\r";
    std::string field;
    if (!text.empty() && formulaStart.find(text.front()) != std::string_view::npos)
        field += '\'';
    field += text;
    if (field.find_first_of(",;\"\r\n\t") == std::string::npos)
        return field;
    std::string escaped = "\"";
    for (const char c : field) {
        escaped += c;
        if (c == '"')
            escaped += c;
    }
    return escaped + '"';
}

std::string csvLine(std::span<const std::string> fields)
{
    std::string line;
    for (const std::string& field : fields) {
        if (&field != fields.data())
            line += ',';
        line += field;
    }
    return line + "\r\n";
}

} // namespace agv::recording
