// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/tag_numbers.h"

#include "recording/text_lines.h"

#include <limits>

namespace agv::recording {

TagNumbers::TagNumbers(std::span<const FloorTag> tags)
{
    for (const FloorTag& tag : tags) {
        m_uids.insert(tag.uid);
        if (tag.number > 0)
            m_uidByNumber.emplace(tag.number, tag.uid);
    }
}

TagUid TagNumbers::uidOf(int number) const
{
    const auto found = m_uidByNumber.find(number);
    return found != m_uidByNumber.end() ? found->second : TagUid{static_cast<std::uint64_t>(number)};
}

std::optional<TagUid> TagNumbers::parse(std::string_view text) const
{
    constexpr std::size_t uidDigits = 16;
    if (text.size() != uidDigits) {
        const auto number = parseInteger(text);
        return number && *number >= 1 ? std::optional(uidOf(*number)) : std::nullopt;
    }
    const auto uid = parseTagUid(text);
    if (!uid || uid->value == 0)
        return std::nullopt;
    const bool isNumber =
        !knows(*uid) && uid->value <= static_cast<std::uint64_t>(std::numeric_limits<int>::max());
    return isNumber ? uidOf(static_cast<int>(uid->value)) : *uid;
}

std::optional<std::string> TagNumbers::whyForeign(const TurnRecord& record) const
{
    std::size_t reads = 0;
    std::size_t foreign = 0;
    TagUid example;
    for (const TurnStop& stop : record.stops) {
        for (const TagRead& read : stop.reads) {
            ++reads;
            if (knows(read.uid))
                continue;
            ++foreign;
            example = read.uid;
        }
    }
    if (2 * foreign <= reads)
        return std::nullopt;
    const bool isNumber = example.value <= static_cast<std::uint64_t>(std::numeric_limits<int>::max());
    return std::to_string(foreign) + " of " + std::to_string(reads) +
           " reads are of tags that the plant with its " + std::to_string(m_uids.size()) +
           " tags does not have, such as " + (isNumber ? std::to_string(example.value) : fullText(example)) +
           "; is it the right plant or field?";
}

} // namespace agv::recording
