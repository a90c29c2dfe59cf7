// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

#include <optional>

namespace agv::procedure {

/// Zero wheel speed is said several times, because a robot that missed it would drive on: five times at
/// 20 Hz, the rate of a hand control. Pure: the caller sends a zero whenever begin() or onTimer() says so.
class ZeroBurst {
public:
    static constexpr int repeats = 5;
    static constexpr Duration interval = std::chrono::milliseconds(50);

    /// The caller sends the first zero now.
    void begin(Time now)
    {
        m_left = repeats - 1;
        m_next = now + interval;
    }
    /// True: the caller sends another zero now.
    bool onTimer(Time now)
    {
        if (!m_next || now < *m_next)
            return false;
        --m_left;
        m_next = m_left > 0 ? std::optional(now + interval) : std::nullopt;
        return true;
    }
    /// Before the wheels are told to turn again.
    void cancel() { m_next.reset(); }
    std::optional<Time> deadline() const { return m_next; }

private:
    int m_left = 0;
    std::optional<Time> m_next;
};

} // namespace agv::procedure
