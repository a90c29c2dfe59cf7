// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include "core/snapshot.h"

#include <map>
#include <vector>

namespace agv::gui {

/// What happened to the alarms between two snapshots, for the event log: came, went, acknowledged, shelved.
class AlarmLog {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::AlarmLog)
public:
    /// `utc_ms` is the wall clock put on the lines.
    std::vector<EventEntry> linesFor(const std::vector<AlarmSnapshot>& alarms, std::int64_t utc_ms);

private:
    static QString change(const AlarmSnapshot* before, const AlarmSnapshot& now);

    std::map<AlarmKey, AlarmSnapshot> m_known;
};

} // namespace agv::gui
