// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

#include <cstdint>

namespace agv::session {

/// The monotonic clock; the one place where the session asks for the time.
inline Time monotonicNow() { return std::chrono::steady_clock::now(); }

/// Milliseconds since 1970, UTC; for what people and files see.
inline std::int64_t utcNow_ms()
{
    using std::chrono::duration_cast;
    return duration_cast<std::chrono::milliseconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

/// The same in microseconds.
inline std::int64_t utcNow_us()
{
    using std::chrono::duration_cast;
    return duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

} // namespace agv::session
