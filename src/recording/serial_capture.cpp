// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/serial_capture.h"

#include "recording/number_text.h"
#include "recording/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace agv::recording {

namespace {

constexpr std::string_view firstLine = "# agv-uwb-capture";
constexpr double longest_ms = 1e12; // thirty years

struct Escape {
    char letter;
    char byte;
};
constexpr std::array escapes{Escape{'r', '\r'}, Escape{'n', '\n'}, Escape{'t', '\t'}, Escape{'\\', '\\'}};

void appendEscaped(std::string& text, char byte)
{
    const auto* const escape = std::ranges::find(escapes, byte, &Escape::byte);
    if (escape != escapes.end()) {
        text += '\\';
        text += escape->letter;
    } else if (byte >= ' ' && byte <= '~') {
        text += byte;
    } else {
        constexpr std::string_view digits = "0123456789ABCDEF";
        const auto value = static_cast<unsigned char>(byte);
        text += "\\x";
        text += digits[value >> 4U];
        text += digits[value & 0xFU];
    }
}

/// Takes one byte, escaped or not, from the front of a text that is not empty.
std::optional<char> takeByte(std::string_view& text)
{
    const char first = text.front();
    text.remove_prefix(1);
    if (first != '\\')
        return first;
    if (text.empty())
        return std::nullopt;
    const auto* const escape = std::ranges::find(escapes, text.front(), &Escape::letter);
    if (escape != escapes.end()) {
        text.remove_prefix(1);
        return escape->byte;
    }
    unsigned value = 0;
    constexpr std::size_t length = 3; // xHH
    if (text.front() != 'x' || text.size() < length)
        return std::nullopt;
    const auto [stop, error] = std::from_chars(text.data() + 1, text.data() + length, value, 16);
    if (error != std::errc{} || stop != text.data() + length)
        return std::nullopt;
    text.remove_prefix(length);
    return static_cast<char>(value);
}

std::optional<SerialChunk> chunkOf(std::string_view line)
{
    line.remove_prefix(1); // the @
    const std::size_t blank = std::min(line.find(' '), line.size());
    const auto ms = parseNumber(line.substr(0, blank));
    if (!ms || *ms < 0.0 || *ms > longest_ms)
        return std::nullopt;
    SerialChunk chunk{Duration(std::llround(*ms * 1e6)), {}};
    line.remove_prefix(std::min(blank + 1, line.size()));
    while (!line.empty()) {
        const auto byte = takeByte(line);
        if (!byte)
            return std::nullopt;
        chunk.bytes += *byte;
    }
    return chunk;
}

bool beginsLikeReport(std::string_view line)
{
    constexpr std::array<std::string_view, 4> begins{"mc ", "mr ", "ma ", "mi,"};
    if (std::ranges::any_of(begins, [line](std::string_view begin) { return line.starts_with(begin); }))
        return true;
    return line.size() > 6 && line.starts_with("ma") && line.substr(4, 2) == " t"; // maAA tTT, firmware 1.06
}

} // namespace

SerialCaptureWriter::SerialCaptureWriter(Sink sink, Time begin) : m_sink(std::move(sink)), m_begin(begin)
{
    m_sink(std::string(firstLine) + " 1\n");
}

void SerialCaptureWriter::note(std::string_view text)
{
    std::string line = "# ";
    for (const char c : text)
        appendEscaped(line, c);
    m_sink(line + "\n");
}

void SerialCaptureWriter::bytes(std::string_view chunk, Time at)
{
    std::string line = "@" + numberText(secondsFrom(at - m_begin) * 1e3) + " ";
    for (const char byte : chunk)
        appendEscaped(line, byte);
    m_sink(line + "\n");
}

SerialCapture readSerialCapture(std::string_view text)
{
    SerialCapture capture;
    capture.hasTimes = looksLikeTimedCapture(text);
    if (!capture.hasTimes) {
        capture.chunks.push_back({Duration{}, std::string(text)});
        return capture;
    }
    for (const TextLine& line : linesOf(text)) {
        if (line.text.empty() || line.text.starts_with('#'))
            continue;
        auto chunk = line.text.starts_with('@') ? chunkOf(line.text) : std::nullopt;
        if (chunk)
            capture.chunks.push_back(std::move(*chunk));
        else
            capture.problems.add(line.number,
                                 "is no read of a capture; expected @ms and the bytes, with \\r \\n "
                                 "\\t \\\\ \\xHH for those that are not printable (is " +
                                     inQuotes(line.text) + ")");
    }
    return capture;
}

bool looksLikeTimedCapture(std::string_view text) { return text.starts_with(firstLine); }

bool looksLikeRawCapture(std::string_view text)
{
    constexpr std::size_t enough = std::size_t{64} << 10U;
    const auto lines = linesOf(text.substr(0, enough));
    return std::ranges::any_of(lines, [](const TextLine& line) { return beginsLikeReport(line.text); });
}

} // namespace agv::recording
