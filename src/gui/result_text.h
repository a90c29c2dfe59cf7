// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include "core/turn.h"

namespace agv::gui {

enum class Verdict { Good, Warning, Error };

/// The outcome of a turn in the operator's words.
class ResultText {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::ResultText)
public:
    static Verdict verdict(const TurnEstimate& estimate);
    /// "Position found", "Position found, please check", "No position"
    static QString headline(const TurnEstimate& estimate);
    /// "AGV 1 stands at x 1,204 mm, y 873 mm and faces 92°. With 95 % certainty ±3 mm and ±2°."
    static QString sentence(const QString& agv, const TurnEstimate& estimate);
    /// The same for the log: "x 1,204 mm, y 873 mm, facing 92.3° (95 %: ±3 mm, ±2°)". Empty without a pose.
    static QString shortForm(const TurnEstimate& estimate);
    /// One line per flag: what it means and what to do.
    static QStringList reasons(const TurnEstimate& estimate);
    /// "The steps were 43.1° instead of 45°: a sleeptime of 1,174 ms (±9 ms) fits better." Empty without one.
    static QString suggestion(const TurnEstimate& estimate, int stopsPerTurn);
    /// "So far: x 1,204 mm, ...", for the preview while the AGV still turns. Empty without a pose.
    static QString soFar(const TurnEstimate& preview);

private:
    static QString reason(TurnFlag flag, const TurnEstimate& estimate);
};

} // namespace agv::gui
