// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shift_checks.h"

#include "model/messages.h"
#include "model/words.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace agv::model {
namespace {

ShiftCheck passed(const QString& what, const QString& cause) { return {true, what, cause, {}}; }

ShiftCheck failed(const QString& what, const QString& cause, const QString& remedy)
{
    return {false, what, cause, remedy};
}

QString reasonOf(const LinkSnapshot& link)
{
    return link.reason.empty() ? Words::linkState(link.state) : Messages::sentence(link.reason);
}

} // namespace

std::vector<ShiftCheck> ShiftChecks::of(const PlantLayout& plant, const PlantSnapshot& snapshot,
                                        const ShiftFacts& facts)
{
    std::vector<ShiftCheck> checks{plantFile(plant), robotPort(snapshot)};
    const TagMap tags = tagMapOf(plant);
    for (const AgvSnapshot& agv : snapshot.agvs) {
        checks.push_back(robot(agv));
        checks.push_back(battery(agv));
        checks.push_back(reader(agv));
        checks.push_back(floorTags(agv, tags));
        if (const AgvConfig* config = plant.findAgv(agv.id))
            checks.push_back(sleeptime(agv, *config));
    }
    if (!plant.anchors.empty()) {
        checks.push_back(uwbUnit(snapshot));
        checks.push_back(anchors(plant, snapshot));
    }
    checks.push_back(disk(facts));
    return checks;
}

ShiftCheck ShiftChecks::plantFile(const PlantLayout& plant)
{
    const QString what = tr("Plant file");
    if (plant.floorTags.empty())
        return failed(what, tr("It holds no floor tags"), tr("Add them to the plant file and start again."));
    if (plant.agvs.empty())
        return failed(what, tr("It names no AGV"), tr("Add one to the plant file and start again."));
    return passed(what, tr("%1: %2 floor tags, %3 AGVs")
                            .arg(QString::fromStdString(plant.name))
                            .arg(plant.floorTags.size())
                            .arg(plant.agvs.size()));
}

ShiftCheck ShiftChecks::robotPort(const PlantSnapshot& snapshot)
{
    const QString what = tr("Port for robots");
    const QString found = Messages::sentence(snapshot.listening);
    if (snapshot.listening.starts_with("Not listening"))
        return failed(what, found,
                      tr("End the other program that uses the port, or change the port in the plant file."));
    return passed(what, found);
}

ShiftCheck ShiftChecks::robot(const AgvSnapshot& agv)
{
    const QString what = tr("AGV %1: robot").arg(agv.id.number);
    if (agv.robotLink.state != LinkState::Up)
        return failed(what, reasonOf(agv.robotLink), tr("Switch the AGV on; it connects by itself."));
    if (agv.robotState == RobotState::Error)
        return failed(what, tr("It reports an error"),
                      tr("Look at its display; switch it off and on again."));
    return passed(what, Words::robotState(true, agv.robotState));
}

ShiftCheck ShiftChecks::battery(const AgvSnapshot& agv)
{
    const QString what = tr("AGV %1: battery").arg(agv.id.number);
    if (!agv.battery || agv.battery->capacity_Ah <= 0.0)
        return failed(what, tr("It has not reported its charge"), tr("Wait until the robot is connected."));
    const double charge = agv.battery->charge_Ah / agv.battery->capacity_Ah;
    const QString found = tr("%1, %2").arg(Words::percent(charge), Words::volts(agv.battery->voltage_V));
    if (charge < enoughCharge)
        return failed(what, found,
                      tr("Charge it; a shift takes %1 or more.").arg(Words::percent(enoughCharge)));
    return passed(what, found);
}

ShiftCheck ShiftChecks::reader(const AgvSnapshot& agv)
{
    const QString what = tr("AGV %1: RFID reader").arg(agv.id.number);
    const LinkSnapshot& link = agv.readerLink;
    if (link.state == LinkState::Down)
        return failed(what, tr("It is closed"), tr("Press Open RFID."));
    if (link.state == LinkState::Silent)
        return failed(what, reasonOf(link),
                      tr("Push the AGV a little, so that its antenna is over a floor tag."));
    if (link.state != LinkState::Up)
        return failed(what, reasonOf(link),
                      tr("Has the WeMos bridge power and Wi-Fi? It is tried again by itself."));
    if (link.dataAge_s.value_or(freshFor_s + 1.0) > freshFor_s)
        return failed(what, tr("Nothing was read for %1").arg(Words::age(link.dataAge_s.value_or(0.0))),
                      tr("Push the AGV a little, so that its antenna is over a floor tag."));
    return passed(what, tr("%1 reads").arg(Words::rate(link.messagesPerSecond)));
}

ShiftCheck ShiftChecks::floorTags(const AgvSnapshot& agv, const TagMap& tags)
{
    const QString what = tr("AGV %1: floor tags").arg(agv.id.number);
    if (agv.recentReads.empty())
        return failed(what, tr("It reads none"),
                      tr("Push the AGV a little, so that its antenna is over a floor tag."));
    const auto stranger = std::ranges::find_if(
        agv.recentReads, [&tags](const TagRead& read) { return !tags.contains(read.uid); });
    if (stranger != agv.recentReads.end())
        return failed(what,
                      tr("It reads tag %1, which the plant file does not name")
                          .arg(QString::fromStdString(fullText(stranger->uid))),
                      tr("Is this the plant file of this plant? Else add the tag to it."));
    return passed(what, tr("What it reads is in the plant file"));
}

ShiftCheck ShiftChecks::sleeptime(const AgvSnapshot& agv, const AgvConfig& config)
{
    const QString what = tr("AGV %1: sleeptime").arg(agv.id.number);
    // A step of 45 degrees about the centre between the wheels.
    const double expected_s = std::numbers::pi / 4.0 * 0.5 * config.track_m / agv.turnSpeed_m_s;
    const QString found =
        tr("%1 for wheels at %2")
            .arg(Words::milliseconds(agv.turnTime_s), Words::millimetresPerSecond(agv.turnSpeed_m_s));
    if (std::abs(agv.turnTime_s / expected_s - 1.0) > sleeptimeTolerance)
        return failed(what, found,
                      tr("For its track about %1 is expected: correct the sleeptime, then calibrate.")
                          .arg(Words::milliseconds(expected_s)));
    return passed(what, found);
}

ShiftCheck ShiftChecks::uwbUnit(const PlantSnapshot& snapshot)
{
    const QString what = tr("UWB unit");
    if (!snapshot.uwb || snapshot.uwb->link.state != LinkState::Up)
        return failed(what, snapshot.uwb ? reasonOf(snapshot.uwb->link) : tr("There is none"),
                      tr("Plug the unit in and choose its serial port in the menu UWB."));
    return passed(what, QString::fromStdString(snapshot.uwb->link.address));
}

ShiftCheck ShiftChecks::anchors(const PlantLayout& plant, const PlantSnapshot& snapshot)
{
    const QString what = tr("UWB anchors");
    QStringList silent;
    QStringList moved;
    for (const UwbAnchor& anchor : plant.anchors) {
        const UwbAnchorSnapshot* heard = nullptr;
        if (snapshot.uwb) {
            const auto found = std::ranges::find(snapshot.uwb->anchors, anchor.id, &UwbAnchorSnapshot::id);
            heard = found == snapshot.uwb->anchors.end() ? nullptr : &*found;
        }
        const QString name =
            anchor.label.empty() ? QString::number(anchor.id) : QString::fromStdString(anchor.label);
        if (!heard || heard->age_s.value_or(freshFor_s + 1.0) > freshFor_s)
            silent << name;
        else if (!heard->warning.empty())
            moved << name;
    }
    if (!silent.isEmpty())
        return failed(what, tr("Not heard: %1").arg(silent.join(QStringLiteral(", "))),
                      tr("Have they power, and is a tag switched on?"));
    if (!moved.isEmpty())
        return failed(what, tr("Not where the list says: %1").arg(moved.join(QStringLiteral(", "))),
                      tr("Put them back, or enter their new places in the list of anchors."));
    return passed(what, tr("All %1 are heard").arg(plant.anchors.size()));
}

ShiftCheck ShiftChecks::disk(const ShiftFacts& facts)
{
    const QString what = tr("Disk");
    const QString found =
        tr("%1 free").arg(QLocale().formattedDataSize(std::max<qint64>(0, facts.freeDisk_bytes)));
    return facts.freeDisk_bytes < enoughDisk_bytes
               ? failed(what, found,
                        tr("Make room: %1 or more.").arg(QLocale().formattedDataSize(enoughDisk_bytes)))
               : passed(what, found);
}

} // namespace agv::model
