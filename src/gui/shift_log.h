// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include "core/snapshot.h"

#include <map>
#include <memory>
#include <vector>

namespace agv::gui {

/// What an operator would write into the shift log between two snapshots: the outcome of a turn in words, a
/// sleeptime or wheel speed that was changed. The session logs what links and robots do; this is what it
/// means. What an operator has to act on is an alarm (AlarmLog). GUI thread.
class ShiftLog {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::ShiftLog)
public:
    /// `utc_ms` is the wall clock put on the lines.
    std::vector<EventEntry> linesFor(const PlantSnapshot& snapshot, std::int64_t utc_ms);

private:
    struct Known {
        std::shared_ptr<const TurnEstimate> result;
        double turnTime_s = 0.0;
        double turnSpeed_m_s = 0.0;
    };
    static EventEntry outcome(const AgvSnapshot& agv, const TurnEstimate& estimate);

    std::map<int, Known> m_known;
};

} // namespace agv::gui
