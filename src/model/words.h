// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/robot_status.h"
#include "core/snapshot.h"

#include <optional>

namespace agv::model {

/// The words people read for the values of the plant, in the language of the program. Numbers are formatted
/// for the default QLocale and always carry their unit.
class Words {
    Q_DECLARE_TR_FUNCTIONS(agv::model::Words)
public:
    /// In place of a value that there is none of: "–"
    static QString none();
    static QString linkState(LinkState state);
    static QString robotState(RobotState state);
    /// "Not connected", "State unknown" until a connected robot has reported one, or the state.
    static QString robotState(bool connected, std::optional<RobotState> reported);
    static QString charging(ChargingState state);
    static QString eventLevel(EventLevel level);
    static QString turnPhase(TurnPhase phase);

    static QString millimetres(double metres, int decimals = 0);
    static QString millimetresPerSecond(double metresPerSecond);
    static QString degrees(double radians, int decimals = 0);
    static QString milliseconds(double seconds);
    static QString seconds(double seconds, int decimals = 0);
    /// "0.4 s", "12 s", "3 min": precise while it matters.
    static QString age(double seconds);
    /// "12.3 /s"
    static QString rate(double perSecond);
    static QString volts(double volts);
    static QString percent(double fraction);
};

} // namespace agv::model
