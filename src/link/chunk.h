// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "core/units.h"

namespace agv::link {

/// Bytes as they came from a device, with the monotonic time at which the socket reported them.
struct Chunk {
    QByteArray bytes;
    Time time;
};

} // namespace agv::link
