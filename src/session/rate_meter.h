// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

#include <deque>

namespace agv::session {

/// Events per second, averaged over the last two seconds.
class RateMeter {
public:
    static constexpr Duration window = std::chrono::seconds(2);

    void add(Time now)
    {
        m_events.push_back(now);
        forget(now);
    }
    double perSecond(Time now)
    {
        forget(now);
        return static_cast<double>(m_events.size()) / secondsFrom(window);
    }

private:
    void forget(Time now)
    {
        while (!m_events.empty() && m_events.front() + window < now)
            m_events.pop_front();
    }
    std::deque<Time> m_events;
};

} // namespace agv::session
