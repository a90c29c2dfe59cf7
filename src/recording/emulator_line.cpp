// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/emulator_line.h"

#include "recording/text_lines.h"
#include "recording/turn_limits.h"

namespace agv::recording {

namespace {

struct TagAndRssi {
    std::string_view tag;
    std::string_view rssi;
};

/// "29+RSSI=4", "000000000000001D,+RSSI=4/3": what follows "SCAN:+UID=".
std::optional<TagAndRssi> splitReaderText(std::string_view text)
{
    constexpr std::string_view rssiMark = "+RSSI=";
    const std::size_t mark = text.find(rssiMark);
    if (mark == std::string_view::npos)
        return std::nullopt;
    std::string_view tag = text.substr(0, mark);
    if (tag.ends_with(','))
        tag.remove_suffix(1);
    const std::string_view rssi = text.substr(mark + rssiMark.size());
    return TagAndRssi{trimmed(tag), rssi.substr(0, rssi.find('/'))};
}

std::optional<TagAndRssi> splitBlanks(std::string_view text)
{
    const std::vector<std::string_view> tokens = tokensOf(text);
    if (tokens.size() != 2)
        return std::nullopt;
    return TagAndRssi{tokens[0], tokens[1]};
}

} // namespace

std::string_view withoutLiteralReturn(std::string_view line)
{
    constexpr std::string_view literalReturn = "<\\r>";
    line = trimmed(line);
    while (line.ends_with(literalReturn)) {
        line.remove_suffix(literalReturn.size());
        line = trimmed(line);
    }
    return line;
}

std::expected<std::optional<EmulatorReading>, std::string> parseEmulatorLine(std::string_view line,
                                                                             const TagNumbers& numbers)
{
    constexpr std::string_view complete = "SCAN:+UID=";
    constexpr std::string_view incomplete = "SCAN:-UID=";
    line = withoutLiteralReturn(line);
    if (line.empty() || line == "OK")
        return std::nullopt;
    const std::size_t angleEnd = std::min(line.find_first_of(" \t"), line.size());
    const auto angle = parseNumber(line.substr(0, angleEnd));
    if (!angle || *angle < 0.0)
        return std::unexpected("expected the angle in degrees, from 0, at the beginning, not " +
                               inQuotes(line.substr(0, angleEnd)));
    const std::string_view text = trimmed(line.substr(angleEnd));
    if (text.empty() || text == "OK" || text.starts_with(incomplete))
        return std::nullopt;
    const auto parts =
        text.starts_with(complete) ? splitReaderText(text.substr(complete.size())) : splitBlanks(text);
    if (!parts)
        return std::unexpected("expected 'tag rssi' or 'SCAN:+UID=tag+RSSI=rssi' after the angle, not " +
                               inQuotes(text));
    const auto tag = numbers.parse(parts->tag);
    if (!tag)
        return std::unexpected(inQuotes(parts->tag) +
                               " is not a tag; expected a number from 1 or 16 hexadecimal digits");
    const auto rssi = parseInteger(parts->rssi);
    if (!rssi || *rssi < leastRssi || *rssi > mostRssi)
        return std::unexpected("RSSI " + inQuotes(parts->rssi) + " is not a whole number from 0 to 7");
    return EmulatorReading{0, *angle, *tag, *rssi};
}

} // namespace agv::recording
