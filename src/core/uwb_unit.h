// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace agv {

/// What the unit on the port is.
enum class UwbRole : std::uint8_t { Anchor, Tag, Listener };
const char* toText(UwbRole role);

/// How the unit on the port writes its reports; found from the content (protocol/trek_dialect.h) or set by
/// the operator.
enum class UwbDialect : std::uint8_t {
    Unknown,  ///< nothing heard yet that tells
    Trek,     ///< TREK1000 firmware 2.x: field 2 is a mask of valid ranges
    TrekOld,  ///< TREK1000 firmware 1.06: one anchor per line
    UlmFour,  ///< ULM1, LD600: 4 ranges, field 2 is an SOS byte, time in decimal
    UlmEight, ///< ULM3: the same with 8 ranges
    Esp32,    ///< as Trek, without a time
    Imu,      ///< comma lines "mi,", ranges in metres, motion sensors
};
inline constexpr std::size_t uwbDialectCount = 7;

/// For people and for the option that overrides the detection: "unknown", "trek", "trek-1.06", "ulm4",
/// "ulm8", "esp32", "imu".
const char* toText(UwbDialect dialect);
std::optional<UwbDialect> parseUwbDialect(std::string_view text);

/// True for every dialect but those of the original firmware: nothing is sent to a clone unasked.
bool isClone(UwbDialect dialect);

/// Switches and radio mode of a unit, from the configuration byte of its handshake reply.
struct UwbConfiguration {
    bool fastMode = false; ///< 6.81 Mb/s, else 110 kb/s
    int channel = 2;       ///< 2 or 5
    UwbRole role = UwbRole::Tag;
    int address = 0; ///< 0..7

    /// Time between two reports of one tag, s; the age of the ranges in a report.
    double reportPeriod_s() const { return fastMode ? 0.100 : 0.280; }
    friend bool operator==(const UwbConfiguration&, const UwbConfiguration&) = default;
};

/// bit 1 = 6.81 Mb/s, bit 2 = channel 5, bit 3 = anchor, bits 4..6 = address, its *most* significant bit in
/// bit 4. The other bits mean nothing.
UwbConfiguration decodeUwbConfiguration(std::uint8_t byte);
/// The inverse; a listener is written as a tag. @pre address 0..7
std::uint8_t encodeUwbConfiguration(const UwbConfiguration& configuration);

/// What a unit said of itself.
struct UwbUnit {
    std::string version; ///< "Ver.2.25mx TREK"
    UwbConfiguration configuration;
    friend bool operator==(const UwbUnit&, const UwbUnit&) = default;
};

} // namespace agv
