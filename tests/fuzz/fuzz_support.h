// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>

/// Called with every input, by libFuzzer or by the replay of the corpus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace agv::fuzz {

using Input = std::span<const std::uint8_t>;

/// Stops the fuzzer with the property that does not hold.
inline void require(bool holds, const char* property)
{
    if (holds)
        return;
    std::fprintf(stderr, "property violated: %s\n", property);
    std::abort();
}

inline std::string_view textOf(Input input)
{
    return {reinterpret_cast<const char*>(input.data()), input.size()};
}

/// Takes a value from the front of the input; zeros where the input is too short.
template<typename T>
T take(Input& input)
{
    T value{};
    const std::size_t n = std::min(sizeof(T), input.size());
    if (n > 0)
        std::memcpy(&value, input.data(), n);
    input = input.subspan(n);
    return value;
}

/// Cuts `bytes` into pieces of 1 to 16 bytes, 1 to 2 at times, that the seed determines.
template<typename Feed>
void feedInPieces(Input bytes, std::uint16_t seed, Feed feed)
{
    std::uint32_t state = seed;
    while (!bytes.empty()) {
        // Numerical Recipes' ranqd1; only the upper bits are used.
        state = state * 1664525U + 1013904223U;
        const std::uint32_t mask = (state & 0x80000000U) != 0 ? 0xFU : 0x1U;
        const std::size_t n = std::min<std::size_t>(((state >> 16U) & mask) + 1, bytes.size());
        feed(bytes.first(n));
        bytes = bytes.subspan(n);
    }
}

} // namespace agv::fuzz
