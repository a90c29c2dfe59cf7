// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/uwb_unit.h"

#include <algorithm>
#include <array>

namespace agv {

namespace {

constexpr std::array<const char*, uwbDialectCount> dialectTexts{"unknown", "trek",  "trek-1.06", "ulm4",
                                                                "ulm8",    "esp32", "imu"};

constexpr unsigned fastBit = 1U << 1U;
constexpr unsigned channelBit = 1U << 2U;
constexpr unsigned anchorBit = 1U << 3U;
/// Bit of the byte and what it counts in the address.
struct AddressBit {
    unsigned inByte;
    unsigned inAddress;
};
constexpr std::array<AddressBit, 3> addressBits{AddressBit{1U << 4U, 4}, {1U << 5U, 2}, {1U << 6U, 1}};

} // namespace

const char* toText(UwbRole role)
{
    switch (role) {
    case UwbRole::Anchor:
        return "anchor";
    case UwbRole::Tag:
        return "tag";
    case UwbRole::Listener:
        return "listener";
    }
    return "unknown";
}

const char* toText(UwbDialect dialect) { return dialectTexts[static_cast<std::size_t>(dialect)]; }

std::optional<UwbDialect> parseUwbDialect(std::string_view text)
{
    const auto* const found = std::ranges::find(dialectTexts, text);
    if (found == dialectTexts.end())
        return std::nullopt;
    return static_cast<UwbDialect>(found - dialectTexts.begin());
}

bool isClone(UwbDialect dialect)
{
    return dialect == UwbDialect::UlmFour || dialect == UwbDialect::UlmEight ||
           dialect == UwbDialect::Esp32 || dialect == UwbDialect::Imu;
}

UwbConfiguration decodeUwbConfiguration(std::uint8_t byte)
{
    UwbConfiguration configuration;
    configuration.fastMode = (byte & fastBit) != 0;
    configuration.channel = (byte & channelBit) != 0 ? 5 : 2;
    configuration.role = (byte & anchorBit) != 0 ? UwbRole::Anchor : UwbRole::Tag;
    unsigned address = 0;
    for (const AddressBit& bit : addressBits)
        address += (byte & bit.inByte) != 0 ? bit.inAddress : 0;
    configuration.address = static_cast<int>(address);
    return configuration;
}

std::uint8_t encodeUwbConfiguration(const UwbConfiguration& configuration)
{
    unsigned byte = 0;
    byte |= configuration.fastMode ? fastBit : 0;
    byte |= configuration.channel == 5 ? channelBit : 0;
    byte |= configuration.role == UwbRole::Anchor ? anchorBit : 0;
    for (const AddressBit& bit : addressBits)
        byte |= (static_cast<unsigned>(configuration.address) & bit.inAddress) != 0 ? bit.inByte : 0;
    return static_cast<std::uint8_t>(byte);
}

} // namespace agv
