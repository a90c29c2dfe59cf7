// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace agv {

/// A place in a text: both from 1; columns count characters, not bytes.
struct TextPlace {
    std::size_t line = 1;
    std::size_t column = 1;
    friend auto operator<=>(const TextPlace&, const TextPlace&) = default;
};

/// Line and column of the byte at `offset` of a UTF-8 text; the end of the text when it is beyond.
TextPlace placeAt(std::string_view text, std::size_t offset);

/// Byte where the value at a JSON pointer (RFC 6901) begins. The text must be well formed up to there.
/// `occurrence` 2 finds the second of two equal last keys, and so on. Nothing when there is no such value.
std::optional<std::size_t> locateValue(std::string_view json, std::string_view pointer, int occurrence = 1);

/// Byte where the key of a member begins, else as locateValue().
std::optional<std::size_t> locateKey(std::string_view json, std::string_view pointer, int occurrence = 1);

/// A key as it is written in a JSON pointer: '~' and '/' escaped.
std::string pointerToken(std::string_view key);

} // namespace agv
