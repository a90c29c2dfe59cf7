// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/trek_line.h"

/// What the decoders of the two forms of report lines share; private to protocol.
namespace agv::protocol {

/// The comma form, in trek_imu_line.cpp; the contract is decodeTrekReport's.
std::expected<std::size_t, TrekDrop> decodeTrekImuLine(std::string_view text, TrekReport& report);

/// Takes "0", "12" or "007" from the front; -1 when no digit is there or the number is over 255.
std::int16_t takeTrekId(std::string_view& text);

/// May this stand behind the tag of a comma line? Anything else says that the tag itself was damaged. The
/// other forms have their tag before a colon or a blank and need no such check.
bool mayFollowTrekReport(std::string_view rest);

/// "T" and eight hexadecimal digits.
bool isTrekTimeoutNote(std::string_view text);

} // namespace agv::protocol
