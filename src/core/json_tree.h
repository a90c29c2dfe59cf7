// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace agv {

/// JSON that keeps the order of keys. Numbers are held wider than double, so that lengths given in mm can
/// carry every bit of a length in m. Only for the implementation files of core.
using Json = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;

/// Nesting deeper than this is refused; no file of ours comes near.
inline constexpr int maxJsonDepth = 64;

/// Parses strict JSON in UTF-8. BadInput names the place: syntax, a key used twice in an object, a number
/// too large, nesting too deep, a byte that is not UTF-8.
Result<Json> parseJson(std::string_view text, std::string_view name);

/// Indented by two blanks; an array or object stays on one line while it fits into 130 columns and holds no
/// other object or only numbers.
std::string printJson(const Json& value);

/// "name:line:column: " for a byte of the text.
std::string placeText(std::string_view name, std::string_view text, std::size_t offset);

} // namespace agv
