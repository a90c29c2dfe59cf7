// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/dwell_rule.h"

#include <algorithm>

namespace agv::procedure {

DwellRule::DwellRule(const TurnParameters& parameters)
    : m_shortest(durationFromSeconds(parameters.minDwell_s)),
      m_longest(durationFromSeconds(parameters.maxDwell_s)),
      m_adaptive(parameters.adaptiveDwell)
{}

void DwellRule::begin(Time now)
{
    m_begin = now;
    m_lastNewTag = now;
    m_reads.clear();
    m_loneTags = 0;
}

void DwellRule::add(const TagRead& read)
{
    const int count = ++m_reads[read.uid];
    if (count == 1) {
        ++m_loneTags;
        m_lastNewTag = std::max(m_lastNewTag, read.time);
    } else if (count == 2) {
        --m_loneTags;
    }
}

Time DwellRule::leaveAt() const
{
    const Time last = m_begin + m_longest;
    if (!m_adaptive || m_reads.empty())
        return last;
    const Time stable = m_lastNewTag + (m_loneTags > 0 ? loneTagTime : quietTime);
    return std::clamp(stable, m_begin + m_shortest, last);
}

} // namespace agv::procedure
