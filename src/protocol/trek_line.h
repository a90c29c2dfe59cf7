// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "core/uwb_unit.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

/// Report lines of a TREK1000-type UWB unit, all dialects. Fixed widths, one blank between fields:
///
///   mc 0f 00000663 000005a3 00000512 000004cb 095f c1 00024c24 a0:0
///   id mask r0 r1 r2 r3 (r4 .. r7)            n    rseq debug  role tag:anchor (power)
///
///   ma00 t03 00000650 000005e7 0003 02 00003a82 404f 404f a0         firmware 1.06
///   anchor tag range raw       n    rseq time   tx   rx   role unit
///
///   mi,3.710,0.55,null,0.90,0.94,-1.3,0.6,9.5,...,T0                 IMU variant
///   time s, 4 or 8 ranges m, 6, 9 or 12 numbers of the motion sensors, tag
namespace agv::protocol {

enum class TrekLineKind : std::uint8_t {
    Corrected, ///< mc: ranges tag-anchor, corrected for their bias; the ones to use
    Raw,       ///< mr: the same, not corrected; follows its mc
    Anchors,   ///< ma: ranges between anchors
    Single,    ///< firmware 1.06: tag and one anchor
    Imu,       ///< mi
};

inline constexpr std::size_t mostTrekRanges = 8;

/// One report line. The fields are the wire's own; what they mean in SI is trek_ranges.h. @see TrekStream,
/// which fills `usable`, `deviceTime_ms` and `firstByte` because they depend on more than the line.
struct TrekReport {
    TrekLineKind kind = TrekLineKind::Corrected;
    UwbRole role = UwbRole::Anchor;     ///< of the unit on the port
    std::uint8_t mask = 0;              ///< second field as written: a mask or the SOS byte of a clone
    std::uint8_t rangeCount = 4;        ///< 4, 8, or 1 for Single
    std::uint8_t firstAnchor = 0;       ///< anchor of range_mm[0]
    std::uint8_t usable = 0;            ///< bit k: range k was measured, in the dialect of the stream
    std::uint8_t motionCount = 0;       ///< Imu: how many of `motion` the line has: 6, 9 or 12
    std::int16_t tag = 0;               ///< 0..255
    std::int16_t unit = 0;              ///< reporting anchor, 0..255; -1 where the line does not say
    std::int16_t sequence = -1;         ///< RSEQ 0..255; -1 where the line has none
    std::uint16_t rangeNumber = 0;      ///< running count of ranges, modulo 65536
    std::uint32_t debug = 0;            ///< digits of the debug or time field, read as hexadecimal
    std::int64_t deviceTime_ms = -1;    ///< clock of the unit; -1: the line has none
    std::optional<std::uint16_t> power; ///< receive power of clones, -0.01 dBm
    std::array<std::int32_t, mostTrekRanges> range_mm{}; ///< as written; 0 or -1 when not measured
    std::array<float, 12> motion{}; ///< accelerations, turn rates, ... in the units of the device
    Time firstByte;                 ///< arrival of the first byte of the line

    bool isUsable(std::size_t k) const { return (usable >> k & 1U) != 0; }
    friend bool operator==(const TrekReport&, const TrekReport&) = default;
};

/// Why some text on the port is not a report. The first four are what a damaged stream leaves; the rest is
/// text that units are known to print.
enum class TrekDrop : std::uint8_t {
    Noise,          ///< bytes that are no printable ASCII
    Truncated,      ///< a report that stops early
    BadField,       ///< a report with something else where a field belongs
    Overlong,       ///< no end of line within TrekStream::maxLine
    TimeoutNote,    ///< T%08x ...
    EventCounters,  ///< me ...
    CloneText,      ///< $...
    HandshakeReply, ///< n and the version
    OtherText,      ///< boot chatter and anything else printable
};
inline constexpr std::size_t trekDropCount = 9;
/// In words for a count of them: "noise", "truncated", ...
const char* toText(TrekDrop drop);
/// True for what only a damaged stream leaves.
constexpr bool isDamage(TrekDrop drop) { return drop <= TrekDrop::Overlong; }

/// Does a report begin here? "mc ", "mr ", "ma ", "maAA ", "mi,"
bool beginsTrekReport(std::string_view text);

/// Reads the report at the beginning of `text` into `report` and gives its length; anything may follow.
/// Truncated or BadField otherwise; then `report` holds nothing of use. Digits in either case. No allocation.
std::expected<std::size_t, TrekDrop> decodeTrekReport(std::string_view text, TrekReport& report);

/// The line of a report without its end; decodeTrekReport reads back the same. For the simulated kit and
/// tests.
std::string encodeTrekReport(const TrekReport& report);

/// Milliseconds as a debug field writes them in a dialect: clones print decimal digits.
std::uint32_t trekTimeField(std::uint32_t ms, UwbDialect dialect);
/// The inverse; nothing when the dialect has no time or the digits are not of its base.
std::optional<std::uint32_t> trekTime_ms(std::uint32_t field, UwbDialect dialect);

} // namespace agv::protocol
