// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <compare>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace agv {

/// Number of an AGV as people call it: 1, 2, 3, ...
struct RobotId {
    int number = 0;
    friend auto operator<=>(const RobotId&, const RobotId&) = default;
};

/// The full unique identifier of a floor tag, 64 bits (ISO 15693; NXP tags start with E004).
struct TagUid {
    std::uint64_t value = 0;
    friend auto operator<=>(const TagUid&, const TagUid&) = default;
};

/// "E00401503A5BDAE4": 16 upper-case hexadecimal digits.
std::string fullText(TagUid uid);

/// "AE4": the last three hexadecimal digits, by which the plant's tags differ; for display only.
std::string shortText(TagUid uid);

/// Reads 1 to 16 hexadecimal digits, either case. BadInput when there is anything else.
Result<TagUid> parseTagUid(std::string_view text);

} // namespace agv

template<>
struct std::hash<agv::TagUid> {
    std::size_t operator()(agv::TagUid uid) const noexcept { return std::hash<std::uint64_t>{}(uid.value); }
};

template<>
struct std::hash<agv::RobotId> {
    std::size_t operator()(agv::RobotId id) const noexcept { return std::hash<int>{}(id.number); }
};
