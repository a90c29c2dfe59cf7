// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ids.h"

#include <charconv>
#include <cstdio>

namespace agv {

std::string fullText(TagUid uid)
{
    char text[17];
    std::snprintf(text, sizeof text, "%016llX", static_cast<unsigned long long>(uid.value));
    return text;
}

std::string shortText(TagUid uid)
{
    char text[4];
    std::snprintf(text, sizeof text, "%03X", static_cast<unsigned>(uid.value & 0xFFFU));
    return text;
}

Result<TagUid> parseTagUid(std::string_view text)
{
    TagUid uid;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, uid.value, 16);
    if (text.empty() || text.size() > 16 || error != std::errc{} || stop != end)
        return failure(ErrorCode::BadInput,
                       "'" + std::string(text) + "' is not a tag UID; expected 1 to 16 hexadecimal digits");
    return uid;
}

} // namespace agv
