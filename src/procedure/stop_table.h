// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "core/turn.h"

namespace agv::procedure {

/// One row of the operator's table: the tags of a stop in order of their first read, each with its most
/// frequent RSSI (the stronger one when two are equally frequent). `stop` is 1-based.
StopRow stopRow(int stop, const TurnStop& reads, bool done);

} // namespace agv::procedure
