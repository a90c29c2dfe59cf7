// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/plant_layout.h"
#include "core/snapshot.h"

namespace agv::gui {

/// The line under the map, in two parts.
class NextStep {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::NextStep)
public:
    /// What must be seen to before everything else: AGVs that may still be moving; empty when there are none.
    static QString warning(const PlantSnapshot& snapshot);
    /// What the operator should do next, one sentence; empty when every AGV has been located.
    static QString text(const PlantLayout& plant, const PlantSnapshot& snapshot);
};

} // namespace agv::gui
