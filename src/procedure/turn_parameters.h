// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/turn.h"

namespace agv::procedure {

inline constexpr double maxSettle_s = 5.0; ///< of TurnParameters; the other ranges are in core/turn.h

/// BadInput with the name of the first parameter that is wrong, its value and its range.
Result<void> validate(const TurnParameters& parameters);

} // namespace agv::procedure
