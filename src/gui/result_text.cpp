// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/result_text.h"

#include "model/uncertainty.h"
#include "model/words.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace agv::gui {

using model::Words;

namespace {

struct Bounds {
    QString position;
    QString heading;
};

/// Half widths of the 95 % regions, rounded up: a bound must not promise more than is known.
Bounds boundsOf(const TurnEstimate& estimate)
{
    const double position_m = model::ellipse95(estimate.covariance).major_m;
    const double heading = model::normal95 * estimate.lastHeadingSd;
    return {
        Words::millimetres(metresFromMm(std::max(1.0, std::ceil(mmFromMetres(position_m) - 1e-6)))),
        Words::degrees(radFromDeg(std::max(0.1, std::ceil(degFromRad(heading) * 10.0 - 1e-6) / 10.0)), 1)};
}

} // namespace

Verdict ResultText::verdict(const TurnEstimate& estimate)
{
    if (!estimate.valid)
        return Verdict::Error;
    return estimate.flags.empty() ? Verdict::Good : Verdict::Warning;
}

QString ResultText::headline(const TurnEstimate& estimate)
{
    switch (verdict(estimate)) {
    case Verdict::Good:
        return tr("Position found");
    case Verdict::Warning:
        return std::find(estimate.flags.begin(), estimate.flags.end(), TurnFlag::Ambiguous) !=
                       estimate.flags.end()
                   ? tr("Two positions are possible")
                   : tr("Position found, please check");
    case Verdict::Error:
        return tr("No position found");
    }
    return {};
}

QString ResultText::sentence(const QString& agv, const TurnEstimate& estimate)
{
    if (!estimate.valid)
        return tr("The reads of this turn do not tell where %1 stands.").arg(agv);
    const Bounds bounds = boundsOf(estimate);
    return tr("%1 stands at x %2, y %3 and faces %4. With 95 % certainty within ±%5 and ±%6.")
        .arg(agv, Words::millimetres(estimate.pose.position.x), Words::millimetres(estimate.pose.position.y),
             Words::degrees(estimate.pose.heading, 1), bounds.position, bounds.heading);
}

QString ResultText::shortForm(const TurnEstimate& estimate)
{
    if (!estimate.valid)
        return {};
    const Bounds bounds = boundsOf(estimate);
    return tr("x %1, y %2, facing %3 (95 %: ±%4, ±%5)")
        .arg(Words::millimetres(estimate.pose.position.x), Words::millimetres(estimate.pose.position.y),
             Words::degrees(estimate.pose.heading, 1), bounds.position, bounds.heading);
}

QStringList ResultText::reasons(const TurnEstimate& estimate)
{
    QStringList lines;
    for (TurnFlag flag : estimate.flags)
        lines << reason(flag, estimate);
    if (estimate.flags.empty() && !estimate.valid)
        lines << tr("Solver status: %1.").arg(QString::fromStdString(estimate.status));
    return lines;
}

QString ResultText::reason(TurnFlag flag, const TurnEstimate& estimate)
{
    switch (flag) {
    case TurnFlag::Weak:
        return tr("The uncertainty is too large for driving. Repeat the turn with a longer dwell.");
    case TurnFlag::Ambiguous:
        if (estimate.alternative) {
            const Pose2& other = estimate.alternative->pose;
            return tr("A second position explains the reads nearly as well: x %1, y %2, facing %3 (dashed on "
                      "the "
                      "map). Look which one is right, or repeat the turn with 12 or 16 stops.")
                .arg(Words::millimetres(other.position.x), Words::millimetres(other.position.y),
                     Words::degrees(other.heading));
        }
        return tr(
            "A second position explains the reads nearly as well. Repeat the turn with 12 or 16 stops.");
    case TurnFlag::FewReads:
        return tr("Too few tags were read. Is the AGV on the tag field, and the reader powered?");
    case TurnFlag::WrongRotation:
        return tr("The AGV turned against the commanded direction. Check that its wheels are not swapped.");
    case TurnFlag::UnevenSteps:
        return tr("The steps differ more than usual. Check the wheels for slip and the battery.");
    case TurnFlag::PoorFit:
        return tr("The reads contradict the plant file. Check the floor tags and the RSSI table.");
    case TurnFlag::NoReads:
        return tr("No tag was read. Check the RFID reader's link and that the AGV stands on the tag field.");
    case TurnFlag::NotConverged:
        return tr("The computation ran out of its budget. Repeat the turn.");
    }
    return {};
}

QString ResultText::soFar(const TurnEstimate& preview)
{
    if (!preview.valid)
        return {};
    const bool ambiguous =
        std::find(preview.flags.begin(), preview.flags.end(), TurnFlag::Ambiguous) != preview.flags.end();
    const QString pose = shortForm(preview);
    return ambiguous ? tr("So far: %1; a second position is still possible").arg(pose)
                     : tr("So far: %1").arg(pose);
}

QString ResultText::suggestion(const TurnEstimate& estimate, int stopsPerTurn)
{
    if (!estimate.valid || !estimate.suggestedTurnTime_s || stopsPerTurn < 1)
        return {};
    return tr("The steps were %1 instead of %2: a sleeptime of %3 fits (±%4).")
        .arg(Words::degrees(estimate.step, 1), Words::degrees(radFromDeg(360.0 / stopsPerTurn), 1),
             Words::milliseconds(*estimate.suggestedTurnTime_s),
             Words::milliseconds(std::max(0.001, model::normal95 * estimate.suggestedTurnTimeSd_s)));
}

} // namespace agv::gui
