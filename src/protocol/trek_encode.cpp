// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_line.h"

#include <cstdarg>
#include <cstdio>

namespace agv::protocol {

namespace {

__attribute__((format(printf, 2, 3))) void append(std::string& text, const char* format, ...)
{
    char field[64];
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(field, sizeof field, format, values);
    va_end(values);
    text += field;
}

char letterOf(UwbRole role)
{
    switch (role) {
    case UwbRole::Anchor:
        return 'a';
    case UwbRole::Tag:
        return 't';
    case UwbRole::Listener:
        return 'l';
    }
    return 'a';
}

std::string imuLine(const TrekReport& report)
{
    std::string text = "mi";
    if (report.deviceTime_ms >= 0)
        append(text, ",%.3f", static_cast<double>(report.deviceTime_ms) / 1e3);
    for (std::size_t k = 0; k < report.rangeCount; ++k) {
        if ((report.mask >> k & 1U) != 0)
            append(text, ",%.3f", metresFromMm(report.range_mm[k]));
        else
            text += ",null";
    }
    for (std::size_t i = 0; i < report.motionCount; ++i)
        append(text, ",%.9g", static_cast<double>(report.motion[i]));
    append(text, ",T%d", report.tag);
    return text;
}

std::string singleLine(const TrekReport& report)
{
    const auto range = static_cast<unsigned>(report.range_mm[0]);
    std::string text;
    append(text, "ma%02x t%02x %08x %08x ", static_cast<unsigned>(report.firstAnchor),
           static_cast<unsigned>(report.tag), range, range);
    append(text, "%04x %02x %08x 404f 404f %c%d", static_cast<unsigned>(report.rangeNumber),
           static_cast<unsigned>(report.sequence), report.debug, letterOf(report.role), report.unit);
    return text;
}

} // namespace

std::string encodeTrekReport(const TrekReport& report)
{
    if (report.kind == TrekLineKind::Imu)
        return imuLine(report);
    if (report.kind == TrekLineKind::Single)
        return singleLine(report);
    std::string text = report.kind == TrekLineKind::Corrected ? "mc"
                       : report.kind == TrekLineKind::Raw     ? "mr"
                                                              : "ma";
    append(text, " %02x", static_cast<unsigned>(report.mask));
    for (std::size_t k = 0; k < report.rangeCount; ++k)
        append(text, " %08x", static_cast<unsigned>(report.range_mm[k]));
    append(text, " %04x %02x %08x %c%d:%d", static_cast<unsigned>(report.rangeNumber),
           static_cast<unsigned>(report.sequence), report.debug, letterOf(report.role), report.tag,
           report.unit);
    if (report.power)
        append(text, " %04x", static_cast<unsigned>(*report.power));
    return text;
}

} // namespace agv::protocol
