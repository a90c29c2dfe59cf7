// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QString>

#include "core/units.h"

namespace agv::link {

/// Peers that are not in the plant file, so that one that knocks all the time is reported only now and then.
/// Pure; remembers a bounded number of them.
class StrangerWatch {
public:
    /// The same stranger is news again only after this time.
    static constexpr Duration interval = std::chrono::seconds(10);
    static constexpr qsizetype mostKept = 64;

    /// Whether this visit is to be reported.
    bool isNews(const QString& address, Time now)
    {
        const auto known = m_reported.constFind(address);
        if (known != m_reported.cend() && now - *known < interval)
            return false;
        if (known == m_reported.cend() && m_reported.size() >= mostKept)
            m_reported.clear();
        m_reported.insert(address, now);
        return true;
    }

private:
    QHash<QString, Time> m_reported; ///< when each was last reported
};

} // namespace agv::link
