// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace agv::session {

/// Events per second, averaged over the last two seconds. Allocates only while the rate rises above any
/// before.
class RateMeter {
public:
    static constexpr Duration window = std::chrono::seconds(2);

    void add(Time now)
    {
        forget(now);
        if (m_count == m_ring.size())
            grow();
        m_ring[(m_first + m_count++) % m_ring.size()] = now;
    }
    double perSecond(Time now)
    {
        forget(now);
        return static_cast<double>(m_count) / secondsFrom(window);
    }

private:
    void forget(Time now)
    {
        while (m_count > 0 && m_ring[m_first] + window < now) {
            m_first = (m_first + 1) % m_ring.size();
            --m_count;
        }
    }
    void grow()
    {
        std::rotate(m_ring.begin(), m_ring.begin() + static_cast<std::ptrdiff_t>(m_first), m_ring.end());
        m_first = 0;
        m_ring.resize(std::max<std::size_t>(32, 2 * m_ring.size()));
    }

    std::vector<Time> m_ring; ///< of the times of the events in the window
    std::size_t m_first = 0;  ///< the oldest of them
    std::size_t m_count = 0;
};

} // namespace agv::session
