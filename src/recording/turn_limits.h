// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/turn.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace agv::recording {

/// What every turn file must keep to, whatever its format.
inline constexpr int leastRssi = 0;
inline constexpr int mostRssi = 7;
inline constexpr std::size_t mostStops = 361; ///< a turn in steps of a degree and its closing reading
inline constexpr std::size_t mostReadsPerStop = 100'000;

/// rad: from one degree to half a turn.
bool isStep(double rad);
/// Sleeptime: over 0 and up to an hour, s.
bool isTurnTime_s(double s);
/// Time of a read: not negative, up to ten days, s.
bool isTime_s(double s);

/// "ccw", "cw"
std::optional<Rotation> parseRotation(std::string_view text);
/// "timed", "measured"
std::optional<TurnKind> parseTurnKind(std::string_view text);
const char* toText(TurnKind kind);

} // namespace agv::recording
