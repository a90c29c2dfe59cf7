// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace agv::protocol {

/// The non-zero counts with the words that toText(Reason) has for them: "3 noise, 1 over-long".
template<typename Reason, std::size_t n>
std::string dropText(const std::array<std::uint64_t, n>& dropped)
{
    std::string text;
    for (std::size_t i = 0; i < n; ++i) {
        if (dropped[i] == 0)
            continue;
        if (!text.empty())
            text += ", ";
        text += std::to_string(dropped[i]) + " " + toText(static_cast<Reason>(i));
    }
    return text;
}

} // namespace agv::protocol
