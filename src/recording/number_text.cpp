// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace agv::recording {

std::string numberText(double value)
{
    constexpr int digits = 10;
    if (!std::isfinite(value))
        return {};
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0.0 ? 0.0 : value,
                                   std::chars_format::general, digits)
                         .ptr;
    return {text.data(), end};
}

std::string exactNumberText(double value)
{
    if (!std::isfinite(value))
        return {};
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

} // namespace agv::recording
