// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ids.h"
#include "core/units.h"

namespace agv {

/// One complete read of a floor tag.
struct TagRead {
    Time time; ///< when the first byte of the line arrived
    TagUid uid;
    int rssi = 0; ///< main channel, 0 (weak) .. 7 (strong)
    friend bool operator==(const TagRead&, const TagRead&) = default;
};

} // namespace agv
