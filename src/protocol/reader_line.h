// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ids.h"

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <variant>

namespace agv::protocol {

/// SCAN:+UID=E00402000018313E,+RSSI=7/6 (the comma may be missing; the auxiliary channel too)
struct CompleteRead {
    TagUid uid;
    int rssi = 0;           ///< main channel, 0 (weak) .. 7 (strong)
    int auxiliaryRssi = -1; ///< 0..7, -1 when the line has none
    friend bool operator==(const CompleteRead&, const CompleteRead&) = default;
};

/// SCAN:-UID=E00401503A5BDAE4: counted, never used for a position.
struct IncompleteRead {
    TagUid uid;
    friend bool operator==(const IncompleteRead&, const IncompleteRead&) = default;
};

/// OK
struct ReaderOk {
    friend bool operator==(const ReaderOk&, const ReaderOk&) = default;
};

/// +TAGS=n: an inventory reply of the successor plant's reader; n lines "+UID=...,+RSSI=a/b" follow, which
/// decode as CompleteRead.
struct InventoryCount {
    int tags = 0; ///< 0..9999
    friend bool operator==(const InventoryCount&, const InventoryCount&) = default;
};

/// "Card read UID: 233,148,35,65" of the Raspberry Pi + RC522 reader: four decimal bytes, the first one is
/// the most significant of the low 32 bits of uid. It has no RSSI.
struct Rc522Read {
    TagUid uid; ///< 0..0xFFFFFFFF
    friend bool operator==(const Rc522Read&, const Rc522Read&) = default;
};

using ReaderReport = std::variant<CompleteRead, IncompleteRead, ReaderOk, InventoryCount, Rc522Read>;

/// Why a line is not a report.
enum class ReaderLineError : std::uint8_t {
    Noise,     ///< no known beginning (echo of a command, line noise), or bytes that are not printable ASCII
    BadUid,    ///< something else than 16 hexadecimal digits (RC522: 4 bytes 0..255) where the UID belongs
    BadRssi,   ///< no RSSI after the UID, or out of 0..7
    Truncated, ///< a known beginning that stops early
    TrailingText, ///< a whole report followed by something else: two lines ran into each other
    Overlong,     ///< counted by the framer
    BadCount,     ///< +TAGS= without a number of 1 to 4 digits
};
inline constexpr std::size_t readerLineErrorCount = 7;

/// In words for a count of them: "noise", "bad UID", ...
const char* toText(ReaderLineError error);

/// Decodes one line without its end. Blanks around the line and around its separators are ignored; the
/// digits of a UID are accepted in either case. Never throws.
std::expected<ReaderReport, ReaderLineError> decodeReaderLine(std::string_view line);

/// The line of a report as the device writes it, without its end; the inverse of decodeReaderLine for values
/// within the ranges above. For the simulated plant and tests.
std::string encodeReaderLine(const ReaderReport& report);

} // namespace agv::protocol
