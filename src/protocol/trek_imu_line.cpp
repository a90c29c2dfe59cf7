// SPDX-License-Identifier: GPL-3.0-or-later
// The comma form of report lines. Its number of fields tells how many ranges and sensors it has:
// 4 or 8 ranges, 6, 9 or 12 numbers of the sensors; the time is left out by some.
#include "protocol/trek_line_parts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>

namespace agv::protocol {

namespace {

using Failure = std::unexpected<TrekDrop>;

constexpr std::size_t mostNumbers = 1 + mostTrekRanges + 12;
/// A DW1000 reaches 300 m; the rest is room for what a line may claim.
constexpr double longest_m = 1e6;
/// Of a sensor, in any unit: far beyond every reading, well within a float.
constexpr double largestMotion = 1e9;

/// The numbers of a line, the tag behind them, and what follows that.
struct Fields {
    std::array<std::string_view, mostNumbers> text;
    std::size_t count = 0;
    std::int16_t tag = -1;
    std::string_view rest;
};

bool isFieldCharacter(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
           c == '-' || c == '+';
}

bool isTagLetter(char c) { return c == 'T' || c == 't'; }

/// The fields behind "mi," up to "T0" or "t12", whatever comes next.
std::expected<Fields, TrekDrop> fieldsOf(std::string_view text)
{
    Fields fields;
    fields.rest = text.substr(3);
    while (!fields.rest.empty()) {
        if (isTagLetter(fields.rest.front())) {
            fields.rest.remove_prefix(1);
            const bool isCut = fields.rest.empty();
            fields.tag = takeTrekId(fields.rest);
            if (fields.tag >= 0 && mayFollowTrekReport(fields.rest))
                return fields;
            return Failure(isCut ? TrekDrop::Truncated : TrekDrop::BadField);
        }
        const auto* const stop = std::ranges::find_if_not(fields.rest, isFieldCharacter);
        const auto length = static_cast<std::size_t>(stop - fields.rest.begin());
        if (length == fields.rest.size())
            return Failure(TrekDrop::Truncated);
        if (length == 0 || *stop != ',' || fields.count == mostNumbers)
            return Failure(TrekDrop::BadField);
        fields.text[fields.count++] = fields.rest.substr(0, length);
        fields.rest.remove_prefix(length + 1);
    }
    return Failure(TrekDrop::Truncated);
}

std::optional<double> numberOf(std::string_view field)
{
    double value = 0.0;
    const char* const end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

bool isNull(std::string_view field) { return field == "null" || field == "NULL"; }

struct Shape {
    bool hasTime = false;
    std::size_t ranges = 0;
    std::size_t motion = 0;
    std::size_t numbers() const { return (hasTime ? 1 : 0) + ranges + motion; }
};

bool takeRanges(const Fields& fields, std::size_t at, std::size_t count, TrekReport& report)
{
    report.range_mm = {};
    report.mask = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::string_view field = fields.text[at + k];
        if (isNull(field))
            continue;
        const auto range_m = numberOf(field);
        if (!range_m || std::abs(*range_m) > longest_m)
            return false;
        report.range_mm[k] = static_cast<std::int32_t>(std::lround(mmFromMetres(*range_m)));
        report.mask = static_cast<std::uint8_t>(report.mask | 1U << k);
    }
    return true;
}

bool fits(const Fields& fields, const Shape& shape, TrekReport& report)
{
    if (shape.numbers() != fields.count)
        return false;
    std::size_t at = 0;
    report.motion = {};
    report.deviceTime_ms = -1;
    if (shape.hasTime) {
        const auto time_s = numberOf(fields.text[at++]);
        if (!time_s || *time_s < 0.0 || *time_s > 1e12)
            return false;
        report.deviceTime_ms = std::llround(*time_s * 1e3);
    }
    if (!takeRanges(fields, at, shape.ranges, report))
        return false;
    at += shape.ranges;
    for (std::size_t i = 0; i < shape.motion; ++i) {
        const auto value = numberOf(fields.text[at + i]);
        if (!value || std::abs(*value) > largestMotion)
            return false;
        report.motion[i] = static_cast<float>(*value);
    }
    report.rangeCount = static_cast<std::uint8_t>(shape.ranges);
    report.motionCount = static_cast<std::uint8_t>(shape.motion);
    return true;
}

bool fitsAnyShape(const Fields& fields, TrekReport& report)
{
    // Fourteen and seventeen numbers fit two shapes; sensors are never null, so the numbers tell.
    for (const bool hasTime : {true, false})
        for (const std::size_t ranges : {4U, 8U})
            for (const std::size_t motion : {6U, 9U, 12U})
                if (fits(fields, {hasTime, ranges, motion}, report))
                    return true;
    report.motion = {};
    return false;
}

} // namespace

std::expected<std::size_t, TrekDrop> decodeTrekImuLine(std::string_view text, TrekReport& report)
{
    const auto fields = fieldsOf(text);
    if (!fields)
        return Failure(fields.error());
    if (!fitsAnyShape(*fields, report))
        return Failure(TrekDrop::BadField);
    report.kind = TrekLineKind::Imu;
    report.role = UwbRole::Tag;
    report.tag = fields->tag;
    report.unit = -1;
    report.sequence = -1;
    report.rangeNumber = 0;
    report.debug = 0;
    report.firstAnchor = 0;
    report.power.reset();
    return text.size() - fields->rest.size();
}

} // namespace agv::protocol
