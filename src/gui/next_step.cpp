// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/next_step.h"

#include "gui/turn_progress.h"
#include "model/words.h"

#include <QStringList>

#include <algorithm>

namespace agv::gui {
namespace {

bool isLocated(const AgvSnapshot& agv) { return agv.pose || (agv.turn.result && agv.turn.result->valid); }

} // namespace

QString NextStep::warning(const PlantSnapshot& snapshot)
{
    QStringList moving;
    for (const AgvSnapshot& agv : snapshot.agvs) {
        if (agv.mayBeMoving)
            moving << QString::number(agv.id.number);
    }
    return moving.isEmpty() ? QString()
                            : tr("AGV %1 may still be moving: go and look, and use the switch of the AGV.")
                                  .arg(moving.join(QStringLiteral(", ")));
}

QString NextStep::text(const PlantLayout& plant, const PlantSnapshot& snapshot)
{
    const std::vector<AgvSnapshot>& agvs = snapshot.agvs;
    if (plant.floorTags.empty())
        return tr("The plant file holds no floor tags, so no AGV can be located.");
    if (plant.agvs.empty())
        return tr("The plant file names no AGV. Add one there and start again.");
    QStringList turning;
    QStringList unknown;
    QStringList doubted;
    for (const AgvSnapshot& agv : agvs) {
        if (isRunning(agv.turn.phase))
            turning << QString::number(agv.id.number);
        else if (!isLocated(agv))
            unknown << QString::number(agv.id.number);
        else if (agv.poseHealth == PoseHealth::Doubted)
            doubted << QString::number(agv.id.number);
    }
    if (!turning.isEmpty())
        return tr("Turning: AGV %1. Esc stops all AGVs.").arg(turning.join(QStringLiteral(", ")));
    if (!doubted.isEmpty())
        return tr("No longer where it was located: AGV %1. Choose it and press Calibrate.")
            .arg(doubted.join(QStringLiteral(", ")));
    if (agvs.empty() || unknown.isEmpty())
        return {};
    const auto isClosed = [](const AgvSnapshot& agv) { return agv.readerLink.state == LinkState::Down; };
    if (std::all_of(agvs.begin(), agvs.end(), isClosed))
        return tr("First press Open RFID, so that the AGVs can read the floor tags.");
    const auto isAway = [](const AgvSnapshot& agv) { return agv.robotLink.state != LinkState::Up; };
    if (std::all_of(agvs.begin(), agvs.end(), isAway))
        return tr("Switch the AGVs on. They connect by themselves; none has yet.");
    return tr("Not located yet: AGV %1. Choose one and press Calibrate.")
        .arg(unknown.join(QStringLiteral(", ")));
}

} // namespace agv::gui
