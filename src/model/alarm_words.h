// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/alarm.h"

namespace agv::model {

/// Alarms in words, in the language of the program.
class AlarmWords {
    Q_DECLARE_TR_FUNCTIONS(agv::model::AlarmWords)
public:
    static QString priority(AlarmPriority priority);
    static QString state(const AlarmSnapshot& alarm);
    /// "AGV 2", "Anchor 3", "UWB", "Plant"
    static QString source(const AlarmKey& key);
    /// What is the matter, one sentence with what is known of the cause.
    static QString what(const AlarmSnapshot& alarm);
    /// What to do, one sentence.
    static QString remedy(AlarmKind kind);
};

} // namespace agv::model
