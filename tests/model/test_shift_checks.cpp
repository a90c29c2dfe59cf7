// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "model/shift_checks.h"

using namespace agv;
using namespace agv::model;

namespace {

PlantLayout plantOfOne()
{
    PlantLayout plant;
    plant.name = "Hall";
    plant.floorTags = tagGrid(3, 3, 0.1, {}, TagUid{0x100});
    plant.agvs.emplace_back().id = RobotId{2};
    plant.anchors = {{0, "A0", 0, 0, 1, true}, {1, "A1", 3, 0, 1, true}};
    return plant;
}

/// Everything is as it should be.
PlantSnapshot goodSnapshot()
{
    PlantSnapshot snapshot;
    snapshot.listening = "127.0.0.1:2001 (TCP), 2000 (UDP)";
    AgvSnapshot& agv = snapshot.agvs.emplace_back();
    agv.id = RobotId{2};
    agv.robotLink.state = agv.readerLink.state = LinkState::Up;
    agv.readerLink.dataAge_s = 0.1;
    agv.robotState = RobotState::Idle;
    agv.battery = BatteryStatus{};
    agv.battery->capacity_Ah = 3.0;
    agv.battery->charge_Ah = 2.4;
    agv.recentReads.emplace_back().uid = TagUid{0x101};
    snapshot.uwb = UwbSnapshot{};
    snapshot.uwb->link.state = LinkState::Up;
    snapshot.uwb->link.address = "/dev/ttyACM0";
    for (int id : {0, 1}) {
        snapshot.uwb->anchors.emplace_back().id = id;
        snapshot.uwb->anchors.back().age_s = 0.1;
    }
    return snapshot;
}

constexpr ShiftFacts roomy{50'000'000'000};

QStringList failuresOf(const PlantLayout& plant, const PlantSnapshot& snapshot,
                       const ShiftFacts& facts = roomy)
{
    QStringList failures;
    for (const ShiftCheck& check : ShiftChecks::of(plant, snapshot, facts)) {
        if (!check.passed)
            failures << check.what;
    }
    return failures;
}

struct Fault {
    const char* name;
    std::function<void(PlantLayout&, PlantSnapshot&)> make;
    QStringList failed;
};

} // namespace

class ShiftChecksTest : public QObject {
    Q_OBJECT

private slots:
    void everythingPassesInAPlantThatIsReady();
    void eachFaultFailsItsOwnCheckWithCauseAndRemedy_data();
    void eachFaultFailsItsOwnCheckWithCauseAndRemedy();
    void aPlantWithoutAnchorsHasNoChecksOfUwb();
    void aFullDiskFails();
};

void ShiftChecksTest::everythingPassesInAPlantThatIsReady()
{
    const std::vector<ShiftCheck> checks = ShiftChecks::of(plantOfOne(), goodSnapshot(), roomy);
    QCOMPARE(checks.size(), std::size_t{10});
    for (const ShiftCheck& check : checks) {
        QVERIFY2(check.passed, qPrintable(check.what + check.cause));
        QVERIFY(!check.cause.isEmpty() && check.remedy.isEmpty());
    }
}

Q_DECLARE_METATYPE(Fault)

void ShiftChecksTest::eachFaultFailsItsOwnCheckWithCauseAndRemedy_data()
{
    QTest::addColumn<Fault>("fault");
    const Fault faults[] = {
        {"no tags", [](auto& plant, auto&) { plant.floorTags.clear(); }, {"Plant file", "AGV 2: floor tags"}},
        {"port in use",
         [](auto&, auto& s) { s.listening = "Not listening: port 2001 is in use"; },
         {"Port for robots"}},
        {"robot off",
         [](auto&, auto& s) { s.agvs[0].robotLink.state = LinkState::Waiting; },
         {"AGV 2: robot"}},
        {"robot error", [](auto&, auto& s) { s.agvs[0].robotState = RobotState::Error; }, {"AGV 2: robot"}},
        {"battery unknown", [](auto&, auto& s) { s.agvs[0].battery.reset(); }, {"AGV 2: battery"}},
        {"battery low", [](auto&, auto& s) { s.agvs[0].battery->charge_Ah = 0.6; }, {"AGV 2: battery"}},
        {"reader closed",
         [](auto&, auto& s) { s.agvs[0].readerLink.state = LinkState::Down; },
         {"AGV 2: RFID reader"}},
        {"reader away",
         [](auto&, auto& s) { s.agvs[0].readerLink.state = LinkState::Waiting; },
         {"AGV 2: RFID reader"}},
        {"reader silent",
         [](auto&, auto& s) { s.agvs[0].readerLink.state = LinkState::Silent; },
         {"AGV 2: RFID reader"}},
        {"reader stale",
         [](auto&, auto& s) { s.agvs[0].readerLink.dataAge_s = 3.0; },
         {"AGV 2: RFID reader"}},
        {"no tag below", [](auto&, auto& s) { s.agvs[0].recentReads.clear(); }, {"AGV 2: floor tags"}},
        {"tag of another plant",
         [](auto&, auto& s) { s.agvs[0].recentReads[0].uid = TagUid{7}; },
         {"AGV 2: floor tags"}},
        {"sleeptime too short", [](auto&, auto& s) { s.agvs[0].turnTime_s = 0.7; }, {"AGV 2: sleeptime"}},
        {"sleeptime of another speed",
         [](auto&, auto& s) { s.agvs[0].turnSpeed_m_s = 0.05; },
         {"AGV 2: sleeptime"}},
        {"unit unplugged", [](auto&, auto& s) { s.uwb->link.state = LinkState::Waiting; }, {"UWB unit"}},
        {"no unit", [](auto&, auto& s) { s.uwb.reset(); }, {"UWB unit", "UWB anchors"}},
        {"anchor silent", [](auto&, auto& s) { s.uwb->anchors[1].age_s = 5.0; }, {"UWB anchors"}},
        {"anchor moved", [](auto&, auto& s) { s.uwb->anchors[1].warning = "moved"; }, {"UWB anchors"}},
    };
    for (const Fault& fault : faults)
        QTest::newRow(fault.name) << fault;
}

void ShiftChecksTest::eachFaultFailsItsOwnCheckWithCauseAndRemedy()
{
    QFETCH(Fault, fault);
    PlantLayout plant = plantOfOne();
    PlantSnapshot snapshot = goodSnapshot();
    fault.make(plant, snapshot);
    QCOMPARE(failuresOf(plant, snapshot), fault.failed);
    for (const ShiftCheck& check : ShiftChecks::of(plant, snapshot, roomy))
        QVERIFY2(check.passed || (!check.cause.isEmpty() && !check.remedy.isEmpty()), qPrintable(check.what));
}

void ShiftChecksTest::aPlantWithoutAnchorsHasNoChecksOfUwb()
{
    PlantLayout plant = plantOfOne();
    plant.anchors.clear();
    PlantSnapshot snapshot = goodSnapshot();
    snapshot.uwb.reset();
    QCOMPARE(failuresOf(plant, snapshot), QStringList{});
    QCOMPARE(ShiftChecks::of(plant, snapshot, roomy).size(), std::size_t{8});
}

void ShiftChecksTest::aFullDiskFails()
{
    QCOMPARE(failuresOf(plantOfOne(), goodSnapshot(), ShiftFacts{10'000'000}),
             QStringList{QStringLiteral("Disk")});
    QCOMPARE(failuresOf(plantOfOne(), goodSnapshot(), ShiftFacts{-1}), QStringList{QStringLiteral("Disk")});
}

QTEST_GUILESS_MAIN(ShiftChecksTest)
#include "test_shift_checks.moc"
