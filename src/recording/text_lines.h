// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

struct TextLine {
    int number = 0;        ///< 1-based
    std::string_view text; ///< without its end
};

/// Cuts a text at CR, LF or CR LF; a UTF-8 byte order mark is left out. The lines point into `text`.
std::vector<TextLine> linesOf(std::string_view text);

/// Without blanks, tabs and CR at both ends.
std::string_view trimmed(std::string_view text);

/// Tokens between blanks or tabs.
std::vector<std::string_view> tokensOf(std::string_view text);

/// The whole of `text` as a decimal integer.
std::optional<int> parseInteger(std::string_view text);

/// The whole of `text` as a finite number, "45", "2.25e+01".
std::optional<double> parseNumber(std::string_view text);

/// At most 40 characters of `text` in quotes, control characters and bytes above 126 as '?': for messages.
std::string inQuotes(std::string_view text);

} // namespace agv::recording
