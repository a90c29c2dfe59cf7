// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace agv::protocol {

/// Type byte of a frame or datagram of the robot link.
enum class FrameType : std::uint8_t { networkToUart = 0, uartToTcp = 1, uartToUdp = 2 };

/// type, length
inline constexpr std::size_t frameHeaderBytes = 2;
inline constexpr std::size_t maxPayloadBytes = 255;

/// Appends an integer big-endian, two's complement.
template<typename Integer>
void appendBigEndian(std::vector<std::uint8_t>& bytes, Integer value)
{
    auto rest = static_cast<std::make_unsigned_t<Integer>>(value);
    bytes.resize(bytes.size() + sizeof(Integer));
    for (auto byte = bytes.rbegin(); byte != bytes.rbegin() + sizeof(Integer); ++byte) {
        *byte = static_cast<std::uint8_t>(rest & 0xFFU);
        rest = static_cast<decltype(rest)>(sizeof(Integer) > 1 ? static_cast<std::uint64_t>(rest) >> 8U : 0U);
    }
}

/// Takes fields from the front of a payload. Reading past the end gives zeros and is remembered, so that the
/// length is checked once, after the last field.
class FieldReader {
public:
    explicit FieldReader(std::span<const std::uint8_t> bytes) : m_rest(bytes) {}

    template<typename Integer>
    Integer take()
    {
        if (m_rest.size() < sizeof(Integer)) {
            m_rest = {};
            m_ranOut = true;
            return 0;
        }
        std::uint64_t value = 0;
        for (const std::uint8_t byte : m_rest.first(sizeof(Integer)))
            value = value << 8U | byte;
        m_rest = m_rest.subspan(sizeof(Integer));
        return static_cast<Integer>(static_cast<std::make_unsigned_t<Integer>>(value));
    }

    /// A text up to its NUL; nothing when the NUL is missing.
    std::optional<std::string> takeText()
    {
        const auto end = std::ranges::find(m_rest, std::uint8_t{0});
        if (end == m_rest.end())
            return std::nullopt;
        std::string text(m_rest.begin(), end);
        m_rest = m_rest.subspan(text.size() + 1);
        return text;
    }

    std::size_t bytesLeft() const { return m_rest.size(); }
    /// Every byte was taken, and none was missing.
    bool endedExactly() const { return !m_ranOut && m_rest.empty(); }

private:
    std::span<const std::uint8_t> m_rest;
    bool m_ranOut = false;
};

inline bool isAscii(std::string_view text)
{
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80U; });
}

} // namespace agv::protocol
