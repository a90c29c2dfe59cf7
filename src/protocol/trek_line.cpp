// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_line.h"

#include "protocol/trek_line_parts.h"

#include <algorithm>

namespace agv::protocol {

namespace {

using Failure = std::unexpected<TrekDrop>;
constexpr std::uint8_t noDigit = 0x80;

constexpr std::array<std::uint8_t, 256> hexDigits = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(noDigit);
    for (unsigned i = 0; i < 10; ++i)
        values['0' + i] = static_cast<std::uint8_t>(i);
    for (unsigned i = 0; i < 6; ++i) {
        values['a' + i] = static_cast<std::uint8_t>(10 + i);
        values['A' + i] = static_cast<std::uint8_t>(10 + i);
    }
    return values;
}();

bool isHexDigit(char c) { return hexDigits[static_cast<unsigned char>(c)] != noDigit; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Reads fields of fixed width one after the other; a wrong one is remembered, so that it is asked once.
class FixedFields {
public:
    explicit FixedFields(const char* at) : m_at(at) {}

    template<int digits>
    std::uint32_t hex()
    {
        std::uint32_t value = 0;
        for (int i = 0; i < digits; ++i) {
            const std::uint8_t digit = hexDigits[static_cast<unsigned char>(*m_at++)];
            m_wrong |= digit;
            value = value << 4U | digit;
        }
        return value;
    }
    void expect(char c) { m_wrong |= *m_at++ == c ? std::uint8_t{0} : noDigit; }
    bool allRight() const { return (m_wrong & noDigit) == 0; }
    const char* at() const { return m_at; }

private:
    const char* m_at;
    std::uint8_t m_wrong = 0;
};

std::optional<UwbRole> roleOf(char c)
{
    switch (c) {
    case 'a':
        return UwbRole::Anchor;
    case 't':
        return UwbRole::Tag;
    case 'l':
        return UwbRole::Listener;
    default:
        return std::nullopt;
    }
}

/// " 0123" and no more digits: the receive power that clones append.
void takePower(std::string_view& rest, TrekReport& report)
{
    constexpr std::size_t width = 5;
    report.power.reset();
    if (rest.size() < width || rest.front() != ' ' || (rest.size() > width && isHexDigit(rest[width])))
        return;
    FixedFields field(rest.data() + 1);
    const std::uint32_t power = field.hex<4>();
    if (!field.allRight())
        return;
    report.power = static_cast<std::uint16_t>(power);
    rest.remove_prefix(width);
}

/// "a0:0" and the power; gives what is left of the text.
std::expected<std::string_view, TrekDrop> takeUnits(std::string_view rest, TrekReport& report)
{
    const auto role = rest.empty() ? std::nullopt : roleOf(rest.front());
    if (!role)
        return Failure(rest.empty() ? TrekDrop::Truncated : TrekDrop::BadField);
    report.role = *role;
    rest.remove_prefix(1);
    report.tag = takeTrekId(rest);
    if (report.tag >= 0 && rest.empty())
        return Failure(TrekDrop::Truncated);
    if (report.tag < 0 || rest.front() != ':')
        return Failure(rest.empty() ? TrekDrop::Truncated : TrekDrop::BadField);
    rest.remove_prefix(1);
    const bool isCut = rest.empty();
    report.unit = takeTrekId(rest);
    if (report.unit < 0)
        return Failure(isCut ? TrekDrop::Truncated : TrekDrop::BadField);
    takePower(rest, report);
    return rest;
}

/// Offsets of the line with n ranges.
constexpr std::size_t rangesAt = 6;
constexpr std::size_t countAt(std::size_t ranges) { return rangesAt + 9 * ranges; }
constexpr std::size_t unitsAt(std::size_t ranges) { return countAt(ranges) + 5 + 3 + 9; }

/// mc, mr, ma
std::expected<std::size_t, TrekDrop> decodeRangeLine(std::string_view text, TrekReport& report)
{
    // Where the count of a line with four ranges ends, a line with eight has a digit of its fifth range.
    const std::size_t endOfCount = countAt(4) + 4;
    if (text.size() <= endOfCount)
        return Failure(TrekDrop::Truncated);
    const std::size_t ranges = text[endOfCount] == ' ' ? 4 : 8;
    if (text.size() <= unitsAt(ranges))
        return Failure(TrekDrop::Truncated);

    FixedFields fields(text.data() + 3);
    report.mask = static_cast<std::uint8_t>(fields.hex<2>());
    fields.expect(' ');
    for (std::size_t k = 0; k < ranges; ++k) {
        report.range_mm[k] = static_cast<std::int32_t>(fields.hex<8>());
        fields.expect(' ');
    }
    report.rangeNumber = static_cast<std::uint16_t>(fields.hex<4>());
    fields.expect(' ');
    report.sequence = static_cast<std::int16_t>(fields.hex<2>());
    fields.expect(' ');
    report.debug = fields.hex<8>();
    fields.expect(' ');
    if (!fields.allRight())
        return Failure(TrekDrop::BadField);

    for (std::size_t k = ranges; k < mostTrekRanges; ++k)
        report.range_mm[k] = 0;
    report.rangeCount = static_cast<std::uint8_t>(ranges);
    report.firstAnchor = 0;
    report.kind = text[1] == 'c'   ? TrekLineKind::Corrected
                  : text[1] == 'r' ? TrekLineKind::Raw
                                   : TrekLineKind::Anchors;
    const auto rest = takeUnits(text.substr(unitsAt(ranges)), report);
    if (!rest)
        return Failure(rest.error());
    return text.size() - rest->size();
}

/// Firmware 1.06.
std::expected<std::size_t, TrekDrop> decodeSingleLine(std::string_view text, TrekReport& report)
{
    constexpr std::size_t roleAt = 54;
    if (text.size() <= roleAt + 1)
        return Failure(TrekDrop::Truncated);
    FixedFields fields(text.data() + 2);
    report.firstAnchor = static_cast<std::uint8_t>(fields.hex<2>());
    fields.expect(' ');
    fields.expect('t');
    report.tag = static_cast<std::int16_t>(fields.hex<2>());
    fields.expect(' ');
    report.range_mm = {static_cast<std::int32_t>(fields.hex<8>())};
    fields.expect(' ');
    fields.hex<8>(); // the raw range
    fields.expect(' ');
    report.rangeNumber = static_cast<std::uint16_t>(fields.hex<4>());
    fields.expect(' ');
    report.sequence = static_cast<std::int16_t>(fields.hex<2>());
    fields.expect(' ');
    report.debug = fields.hex<8>();
    fields.expect(' ');
    fields.hex<4>(); // antenna delays
    fields.expect(' ');
    fields.hex<4>();
    fields.expect(' ');
    const auto role = roleOf(*fields.at());
    std::string_view rest = text.substr(roleAt + 1);
    report.unit = takeTrekId(rest);
    if (!fields.allRight() || !role || report.unit < 0)
        return Failure(TrekDrop::BadField);
    report.role = *role;
    report.kind = TrekLineKind::Single;
    report.mask = 1;
    report.rangeCount = 1;
    report.power.reset();
    return text.size() - rest.size();
}

} // namespace

std::int16_t takeTrekId(std::string_view& text)
{
    int id = 0;
    std::size_t n = 0;
    for (; n < text.size() && isDigit(text[n]); ++n)
        id = n < 3 ? id * 10 + (text[n] - '0') : 256;
    text.remove_prefix(n);
    return static_cast<std::int16_t>(n == 0 || id > 255 ? -1 : id);
}

bool isTrekTimeoutNote(std::string_view text)
{
    constexpr std::size_t digits = 8;
    return text.size() > digits && text.front() == 'T' &&
           std::ranges::all_of(text.substr(1, digits), isHexDigit);
}

bool mayFollowTrekReport(std::string_view rest)
{
    if (rest.empty())
        return true;
    const char next = rest.front();
    return next <= ' ' || next > '~' || next == '$' || beginsTrekReport(rest) || isTrekTimeoutNote(rest) ||
           rest.starts_with("me ");
}

bool beginsTrekReport(std::string_view text)
{
    if (text.size() < 3 || text[0] != 'm')
        return false;
    if (text[1] == 'i')
        return text[2] == ',';
    if (text[1] != 'c' && text[1] != 'r' && text[1] != 'a')
        return false;
    return text[2] == ' ' || (text[1] == 'a' && text.size() >= 5 && isHexDigit(text[2]) &&
                              isHexDigit(text[3]) && text[4] == ' ');
}

std::expected<std::size_t, TrekDrop> decodeTrekReport(std::string_view text, TrekReport& report)
{
    if (!beginsTrekReport(text))
        return Failure(TrekDrop::BadField);
    report.usable = 0;
    if (report.motionCount != 0)
        report.motion = {};
    report.motionCount = 0;
    report.deviceTime_ms = -1;
    if (text[1] == 'i')
        return decodeTrekImuLine(text, report);
    return text[2] == ' ' ? decodeRangeLine(text, report) : decodeSingleLine(text, report);
}

std::uint32_t trekTimeField(std::uint32_t ms, UwbDialect dialect)
{
    if (dialect != UwbDialect::UlmFour && dialect != UwbDialect::UlmEight)
        return dialect == UwbDialect::Esp32 ? 0 : ms;
    std::uint32_t field = 0;
    for (unsigned shift = 0; shift < 32; shift += 4) {
        field |= ms % 10 << shift;
        ms /= 10;
    }
    return field;
}

std::optional<std::uint32_t> trekTime_ms(std::uint32_t field, UwbDialect dialect)
{
    switch (dialect) {
    case UwbDialect::Trek:
    case UwbDialect::TrekOld:
        return field;
    case UwbDialect::UlmFour:
    case UwbDialect::UlmEight: {
        std::uint32_t ms = 0;
        for (unsigned shift = 32; shift > 0; shift -= 4) {
            const std::uint32_t digit = field >> (shift - 4) & 0xFU;
            if (digit > 9)
                return std::nullopt;
            ms = ms * 10 + digit;
        }
        return ms;
    }
    case UwbDialect::Unknown:
    case UwbDialect::Esp32:
    case UwbDialect::Imu:
        break;
    }
    return std::nullopt;
}

const char* toText(TrekDrop drop)
{
    switch (drop) {
    case TrekDrop::Noise:
        return "noise";
    case TrekDrop::Truncated:
        return "truncated";
    case TrekDrop::BadField:
        return "bad field";
    case TrekDrop::Overlong:
        return "over-long";
    case TrekDrop::TimeoutNote:
        return "time-out note";
    case TrekDrop::EventCounters:
        return "event counters";
    case TrekDrop::CloneText:
        return "clone text";
    case TrekDrop::HandshakeReply:
        return "handshake reply";
    case TrekDrop::OtherText:
        return "other text";
    }
    return "unknown";
}

} // namespace agv::protocol
