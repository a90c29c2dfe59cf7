// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/turn.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace agv::recording {

/// Tag numbers of old files <-> UIDs of the plant.
class TagNumbers {
public:
    explicit TagNumbers(std::span<const FloorTag> tags);

    /// UID of tag `number` (>= 1). A number that the plant lacks stands for itself: it is then an unknown tag
    /// to every solver, and its report shows the number (in hexadecimal).
    TagUid uidOf(int number) const;

    /// Reads "29" as a number and 16 hexadecimal digits as a UID; one with a small value, as the emulator
    /// writes it, is a number too. Empty for anything else.
    std::optional<TagUid> parse(std::string_view text) const;

    bool knows(TagUid uid) const { return m_uids.contains(uid); }

    /// Why the turn cannot belong to this plant: more than half of its reads are of tags that it lacks.
    std::optional<std::string> whyForeign(const TurnRecord& record) const;

private:
    std::unordered_map<int, TagUid> m_uidByNumber;
    std::unordered_set<TagUid> m_uids;
};

} // namespace agv::recording
