// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/snapshot.h"
#include "procedure/alarm_conditions.h"
#include "procedure/alarm_list.h"

#include <vector>

namespace agv::session {

/// The alarms of the session: watches its snapshots, takes what operators say of alarms. Lives in the
/// session thread.
class AlarmDesk : public QObject {
    Q_OBJECT
public:
    explicit AlarmDesk(QObject* parent = nullptr) : QObject(parent) {}

    /// Puts the alarms of now into the snapshot that is about to be published.
    void addTo(PlantSnapshot& snapshot);

public slots:
    // What cannot be done (the alarm has just gone, a weighty one cannot be shelved) changes nothing; the
    // next snapshot tells.
    void acknowledge(const std::vector<agv::AlarmKey>& keys);
    void shelve(const std::vector<agv::AlarmKey>& keys, double seconds);
    void unshelve(const std::vector<agv::AlarmKey>& keys);

signals:
    void changed();

private:
    procedure::AlarmConditions m_conditions;
    procedure::AlarmList m_alarms;
};

} // namespace agv::session
