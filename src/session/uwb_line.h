// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "core/snapshot.h"
#include "session/event_log.h"
#include "session/uwb_link.h"

#include <set>
#include <string>

namespace agv::session {

/// The UWB unit of the plant and what is logged of it. Lives in the session thread.
class UwbLine : public QObject {
    Q_OBJECT
public:
    UwbLine(const PlantLayout& plant, const UwbLinkParameters& parameters, EventLog& events, QObject* parent);

    UwbLink& link() { return *m_link; }

signals:
    void changed();
    void bytesReceived(const agv::link::Chunk& chunk);

private:
    /// Each trouble once until data comes again: the tries of a link that is down repeat it for hours.
    void logState(LinkState state, const QString& reason);
    void log(EventLevel level, const std::string& text);

    EventLog& m_events;
    UwbLink* m_link;
    std::set<std::string> m_troubles; ///< logged since the link was last well
};

} // namespace agv::session
