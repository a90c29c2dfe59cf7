// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/alarm_words.h"

#include "model/messages.h"
#include "model/words.h"

#include <cmath>

namespace agv::model {

QString AlarmWords::priority(AlarmPriority priority)
{
    switch (priority) {
    case AlarmPriority::Low:
        return tr("Low");
    case AlarmPriority::Medium:
        return tr("Medium");
    case AlarmPriority::High:
        return tr("High");
    }
    return {};
}

QString AlarmWords::state(const AlarmSnapshot& alarm)
{
    switch (alarm.state) {
    case AlarmState::Unacknowledged:
        return alarm.heldBack ? tr("Held back") : tr("New");
    case AlarmState::Acknowledged:
        return tr("Acknowledged");
    case AlarmState::Returned:
        return tr("Over, new");
    case AlarmState::Shelved:
        return tr("Shelved, %1 left").arg(Words::age(std::ceil(alarm.shelvedFor_s.value_or(0.0))));
    }
    return {};
}

QString AlarmWords::source(const AlarmKey& key)
{
    switch (key.kind) {
    case AlarmKind::NotListening:
    case AlarmKind::Stranger:
        return tr("Plant");
    case AlarmKind::UwbLink:
        return tr("UWB");
    case AlarmKind::AnchorMoved:
        return tr("Anchor %1").arg(key.subject);
    default:
        return tr("AGV %1").arg(key.subject);
    }
}

namespace {

QString withCause(const QString& sentence, const std::string& detail)
{
    return detail.empty() ? sentence : QStringLiteral("%1: %2").arg(sentence, Messages::sentence(detail));
}

} // namespace

QString AlarmWords::what(const AlarmSnapshot& alarm)
{
    const QString detail = QString::fromStdString(alarm.detail);
    switch (alarm.key.kind) {
    case AlarmKind::MayBeMoving:
        return tr("It may be moving: its connection was lost while the wheels were turning");
    case AlarmKind::RobotError:
        return tr("The robot reports an error");
    case AlarmKind::NotListening:
        return withCause(tr("No robot can connect"), alarm.detail.substr(alarm.detail.find(':') + 1));
    case AlarmKind::RobotLink:
        return withCause(tr("The connection to the robot is disturbed"), alarm.detail);
    case AlarmKind::ReaderLink:
        return withCause(tr("The connection to the RFID reader is disturbed"), alarm.detail);
    case AlarmKind::UwbLink:
        return withCause(tr("The connection to the UWB unit is disturbed"), alarm.detail);
    case AlarmKind::PoseDoubted:
        return withCause(tr("Its position is doubted"), alarm.detail);
    case AlarmKind::BatteryLow:
        return tr("The battery is low");
    case AlarmKind::AnchorMoved:
        return withCause(tr("The anchor does not seem to stand where the list says"), alarm.detail);
    case AlarmKind::PosePredicted:
        return tr("Nothing has been measured for some way: the position is only predicted");
    case AlarmKind::TagsMissing:
        return tr("%1 floor tags that the last turn should have read were not read").arg(detail);
    case AlarmKind::TagsUnknown:
        return tr("The last turn read floor tags that the plant file does not name: %1").arg(detail);
    case AlarmKind::Stranger:
        return tr("%1 tried to connect and was refused").arg(detail);
    }
    return {};
}

QString AlarmWords::remedy(AlarmKind kind)
{
    switch (kind) {
    case AlarmKind::MayBeMoving:
        return tr("Go and look; use the switch of the AGV.");
    case AlarmKind::RobotError:
        return tr("Look at the display of the AGV; switch it off and on again.");
    case AlarmKind::NotListening:
        return tr("End the other program that uses the port, or change the port in the plant file.");
    case AlarmKind::RobotLink:
        return tr("Is the AGV switched on and in reach of the Wi-Fi?");
    case AlarmKind::ReaderLink:
        return tr("Has the WeMos bridge power and Wi-Fi? It is tried again by itself.");
    case AlarmKind::UwbLink:
        return tr("Is the UWB unit plugged in and in its report mode?");
    case AlarmKind::PoseDoubted:
        return tr("Calibrate the AGV again before it drives.");
    case AlarmKind::BatteryLow:
        return tr("Charge it soon; until then it turns more slowly than its sleeptime expects.");
    case AlarmKind::AnchorMoved:
        return tr("Put the anchor back, or enter its new place in the list of anchors.");
    case AlarmKind::PosePredicted:
        return tr("Drive slowly over floor tags, or calibrate again.");
    case AlarmKind::TagsMissing:
        return tr("The map marks them with crossed squares: are they there, and whole?");
    case AlarmKind::TagsUnknown:
        return tr("The map marks them with question marks: add them to the plant file.");
    case AlarmKind::Stranger:
        return tr(
            "If it is an AGV of this plant, enter its address in the plant file; else find out whose it is.");
    }
    return {};
}

} // namespace agv::model
