// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/words.h"

#include "core/units.h"

#include <QLocale>

namespace agv::model {
namespace {

// A number never leaves its unit at a line break.
QString withUnit(double value, int decimals, const QString& unit)
{
    // No "-0".
    const double scale = std::pow(10.0, decimals);
    const double rounded = std::round(value * scale) / scale;
    QString number = QLocale().toString(rounded == 0.0 ? 0.0 : rounded, 'f', decimals);
    number.replace(QLatin1Char('-'), QChar(0x2212)); // a minus sign; a hyphen invites a line break
    return number + QChar(QChar::Nbsp) + unit;
}

} // namespace

QString Words::none() { return QStringLiteral("–"); }

QString Words::linkState(LinkState state)
{
    switch (state) {
    case LinkState::Down:
        return tr("Closed");
    case LinkState::Opening:
        return tr("Opening");
    case LinkState::Up:
        return tr("Up");
    case LinkState::Silent:
        return tr("Silent");
    case LinkState::Waiting:
        return tr("Waiting");
    case LinkState::Failed:
        return tr("Failed");
    }
    return {};
}

QString Words::robotState(RobotState state)
{
    switch (state) {
    case RobotState::Idle:
        return tr("Idle");
    case RobotState::SegmentDriving:
        return tr("Driving a segment");
    case RobotState::SegmentWaiting:
        return tr("Waiting for a segment");
    case RobotState::DirectDriving:
        return tr("Driving directly");
    case RobotState::StationDocking:
        return tr("Docking");
    case RobotState::StationDocked:
        return tr("Docked");
    case RobotState::StationUndocking:
        return tr("Undocking");
    case RobotState::DemoDocking:
        return tr("Docking (demo)");
    case RobotState::Error:
        return tr("Error");
    }
    return {};
}

QString Words::robotState(bool connected, std::optional<RobotState> reported)
{
    if (!connected)
        return tr("Not connected");
    return reported ? robotState(*reported) : tr("State unknown");
}

QString Words::charging(ChargingState state)
{
    switch (state) {
    case ChargingState::NotCharging:
        return tr("not charging");
    case ChargingState::Reconditioning:
        return tr("reconditioning");
    case ChargingState::FullCharging:
        return tr("charging");
    case ChargingState::Trickle:
        return tr("trickle charging");
    case ChargingState::Waiting:
        return tr("waiting to charge");
    case ChargingState::Fault:
        return tr("charging fault");
    }
    return {};
}

QString Words::eventLevel(EventLevel level)
{
    switch (level) {
    case EventLevel::Detail:
        return tr("Detail");
    case EventLevel::Info:
        return tr("Info");
    case EventLevel::Warning:
        return tr("Warning");
    case EventLevel::Error:
        return tr("Error");
    }
    return {};
}

QString Words::turnPhase(TurnPhase phase)
{
    switch (phase) {
    case TurnPhase::Idle:
        return tr("No turn yet");
    case TurnPhase::Settling:
        return tr("coming to rest");
    case TurnPhase::Reading:
        return tr("reading tags");
    case TurnPhase::Turning:
        return tr("turning");
    case TurnPhase::Solving:
        return tr("Computing the position");
    case TurnPhase::Finished:
        return tr("Finished");
    case TurnPhase::Aborted:
        return tr("Aborted");
    case TurnPhase::Failed:
        return tr("Failed");
    }
    return {};
}

QString Words::millimetres(double metres, int decimals)
{
    return withUnit(mmFromMetres(metres), decimals, tr("mm"));
}

QString Words::millimetresPerSecond(double metresPerSecond)
{
    return withUnit(mmFromMetres(metresPerSecond), 0, tr("mm/s"));
}

QString Words::degrees(double radians, int decimals)
{
    QString text = withUnit(degFromRad(radians), decimals, QString());
    text.chop(1);
    return text + QChar(0x00B0);
}

QString Words::milliseconds(double seconds) { return withUnit(seconds * 1e3, 0, tr("ms")); }

QString Words::seconds(double seconds, int decimals) { return withUnit(seconds, decimals, tr("s")); }

QString Words::age(double seconds)
{
    if (seconds < 9.95)
        return withUnit(seconds, 1, tr("s"));
    return seconds < 119.5 ? withUnit(seconds, 0, tr("s")) : withUnit(seconds / 60.0, 0, tr("min"));
}

QString Words::rate(double perSecond)
{
    return withUnit(perSecond, perSecond < 99.5 ? 1 : 0, tr("/s", "per second"));
}

QString Words::volts(double volts) { return withUnit(volts, 1, tr("V")); }

QString Words::percent(double fraction) { return withUnit(fraction * 100.0, 0, QStringLiteral("%")); }

} // namespace agv::model
