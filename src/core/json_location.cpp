// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json_location.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace agv {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

void appendUtf8(std::string& out, std::uint32_t c)
{
    const auto byte = [&](std::uint32_t value) { out += static_cast<char>(value); };
    if (c < 0x80) {
        byte(c);
    } else if (c < 0x800) {
        byte(0xC0 | (c >> 6));
        byte(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        byte(0xE0 | (c >> 12));
        byte(0x80 | ((c >> 6) & 0x3F));
        byte(0x80 | (c & 0x3F));
    } else {
        byte(0xF0 | (c >> 18));
        byte(0x80 | ((c >> 12) & 0x3F));
        byte(0x80 | ((c >> 6) & 0x3F));
        byte(0x80 | (c & 0x3F));
    }
}

/// Walks over well formed JSON without building anything.
class Scanner {
public:
    explicit Scanner(std::string_view text) : m_text(text) {}

    std::size_t offset() const { return m_at; }

    char peek()
    {
        while (m_at < m_text.size() && isBlank(m_text[m_at]))
            ++m_at;
        return m_at < m_text.size() ? m_text[m_at] : '\0';
    }

    bool take(char c)
    {
        if (peek() != c)
            return false;
        ++m_at;
        return true;
    }

    /// Past the string that starts here.
    void skipString()
    {
        ++m_at;
        while (m_at < m_text.size() && m_text[m_at] != '"')
            m_at += m_text[m_at] == '\\' ? 2 : 1;
        m_at = std::min(m_at + 1, m_text.size());
    }

    /// The string that starts here, escapes resolved.
    std::string readString()
    {
        const std::size_t begin = m_at + 1;
        skipString();
        const std::size_t end = std::max(begin, m_at - 1);
        return unescape(m_text.substr(begin, end - begin));
    }

    /// Past the value that starts here.
    void skipValue()
    {
        int depth = 0;
        do {
            const char c = peek();
            if (c == '\0')
                return;
            if (c == '"') {
                skipString();
            } else if (c == '{' || c == '[') {
                ++depth;
                ++m_at;
            } else if (c == '}' || c == ']') {
                --depth;
                ++m_at;
            } else if (c == ',' || c == ':') {
                ++m_at;
            } else {
                skipWord();
            }
        } while (depth > 0);
    }

private:
    void skipWord()
    {
        constexpr std::string_view ends = ",:]}[{\" \t\r\n";
        ++m_at;
        while (m_at < m_text.size() && !ends.contains(m_text[m_at]))
            ++m_at;
    }

    static std::uint32_t hex4(std::string_view digits)
    {
        std::uint32_t value = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
        return value;
    }

    static std::string unescape(std::string_view raw)
    {
        std::string out;
        for (std::size_t i = 0; i < raw.size(); ++i) {
            if (raw[i] != '\\' || i + 1 == raw.size()) {
                out += raw[i];
                continue;
            }
            constexpr std::string_view letters = "bfnrt";
            constexpr std::string_view meanings = "\b\f\n\r\t";
            const char escaped = raw[++i];
            if (const auto found = letters.find(escaped); found != std::string_view::npos) {
                out += meanings[found];
            } else if (escaped == 'u' && i + 4 < raw.size()) {
                std::uint32_t c = hex4(raw.substr(i + 1, 4));
                i += 4;
                const bool isHighSurrogate = c >= 0xD800 && c < 0xDC00;
                if (isHighSurrogate && i + 6 < raw.size()) {
                    c = 0x10000 + ((c - 0xD800) << 10) + (hex4(raw.substr(i + 3, 4)) - 0xDC00);
                    i += 6;
                }
                appendUtf8(out, c);
            } else {
                out += escaped;
            }
        }
        return out;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
};

struct Member {
    std::size_t key = 0; ///< offset of the key, or of the value for an element of an array
    std::size_t value = 0;
};

std::optional<Member> enterObject(Scanner& scan, std::string_view wanted, int occurrence)
{
    scan.take('{');
    while (scan.peek() == '"') {
        const std::size_t key = scan.offset();
        const bool hit = scan.readString() == wanted;
        scan.take(':');
        scan.peek();
        if (hit && --occurrence == 0)
            return Member{key, scan.offset()};
        scan.skipValue();
        if (!scan.take(','))
            break;
    }
    return std::nullopt;
}

std::optional<Member> enterArray(Scanner& scan, std::string_view wanted)
{
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    if (error != std::errc{} || end != wanted.data() + wanted.size())
        return std::nullopt;
    scan.take('[');
    for (; index > 0; --index) {
        scan.skipValue();
        if (!scan.take(','))
            return std::nullopt;
    }
    if (scan.peek() == ']' || scan.peek() == '\0')
        return std::nullopt;
    return Member{scan.offset(), scan.offset()};
}

std::string tokenText(std::string_view token)
{
    std::string text;
    for (std::size_t i = 0; i < token.size(); ++i) {
        if (token[i] == '~' && i + 1 < token.size())
            text += token[++i] == '0' ? '~' : '/';
        else
            text += token[i];
    }
    return text;
}

std::optional<Member> locate(std::string_view json, std::string_view pointer, int occurrence)
{
    Scanner scan(json);
    scan.peek();
    Member found{scan.offset(), scan.offset()};
    while (!pointer.empty()) {
        pointer.remove_prefix(1);
        const std::size_t slash = std::min(pointer.find('/'), pointer.size());
        const std::string token = tokenText(pointer.substr(0, slash));
        pointer.remove_prefix(slash);
        const char open = scan.peek();
        const auto next = open == '{'   ? enterObject(scan, token, pointer.empty() ? occurrence : 1)
                          : open == '[' ? enterArray(scan, token)
                                        : std::nullopt;
        if (!next)
            return std::nullopt;
        found = *next;
    }
    return found;
}

} // namespace

TextPlace placeAt(std::string_view text, std::size_t offset)
{
    const std::string_view before = text.substr(0, offset);
    const std::size_t lineStart = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    const auto startsCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    const auto line = std::count(before.begin(), before.end(), '\n');
    const std::string_view lineText = before.substr(lineStart);
    const auto column = std::count_if(lineText.begin(), lineText.end(), startsCharacter);
    return {static_cast<std::size_t>(line) + 1, static_cast<std::size_t>(column) + 1};
}

std::optional<std::size_t> locateValue(std::string_view json, std::string_view pointer, int occurrence)
{
    const auto found = locate(json, pointer, occurrence);
    return found ? std::optional(found->value) : std::nullopt;
}

std::optional<std::size_t> locateKey(std::string_view json, std::string_view pointer, int occurrence)
{
    const auto found = locate(json, pointer, occurrence);
    return found ? std::optional(found->key) : std::nullopt;
}

std::string pointerToken(std::string_view key)
{
    std::string token;
    for (const char c : key) {
        if (c == '~')
            token += "~0";
        else if (c == '/')
            token += "~1";
        else
            token += c;
    }
    return token;
}

} // namespace agv
