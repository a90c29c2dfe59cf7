// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "gui/application_setup.h"
#include "gui/next_step.h"
#include "gui/scenes.h"
#include "gui/shift_log.h"

#include <QApplication>

using namespace agv;
using namespace agv::gui;

namespace {

QString textOf(const EventEntry& entry)
{
    return QString::fromStdString(entry.text).replace(QChar(QChar::Nbsp), QLatin1Char(' '));
}

PlantSnapshot withCharge(double share)
{
    PlantSnapshot snapshot = scenes::linksUp();
    for (AgvSnapshot& agv : snapshot.agvs) {
        agv.battery->capacity_Ah = 2.0;
        agv.battery->charge_Ah = 2.0;
    }
    snapshot.agvs[2].battery->charge_Ah = 2.0 * share;
    return snapshot;
}

} // namespace

class ShiftLogTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { setUpApplication(*qApp, QLocale(QStringLiteral("en_GB"))); }
    void aFinishedTurnIsWrittenOnce();
    void anAmbiguousTurnIsAWarning();
    void aChangedSleeptimeIsWrittenWithBothValues();
    void aChangedWheelSpeedIsWrittenWithBothValues();
    void theNextStepLeadsFromClosedReadersToLocatedAgvs();
};

void ShiftLogTest::aFinishedTurnIsWrittenOnce()
{
    ShiftLog log;
    QVERIFY(log.linesFor(withCharge(1.0), 1).empty());
    PlantSnapshot finished = withCharge(1.0);
    finished.agvs[0].turn = scenes::finished().agvs[0].turn;
    const std::vector<EventEntry> lines = log.linesFor(finished, 1773761405123);
    QCOMPARE(lines.size(), std::size_t{1});
    QCOMPARE(lines[0].utc_ms, 1773761405123);
    QVERIFY(lines[0].level == EventLevel::Info);
    QCOMPARE(lines[0].source, std::string("AGV 1"));
    QCOMPARE(textOf(lines[0]),
             QStringLiteral("Position found: x 1,204 mm, y 873 mm, facing 92.3° (95 %: ±3 mm, ±1.8°)"));
    QVERIFY(log.linesFor(finished, 2).empty());
}

void ShiftLogTest::anAmbiguousTurnIsAWarning()
{
    ShiftLog log;
    PlantSnapshot snapshot = withCharge(1.0);
    snapshot.agvs[0].turn = scenes::ambiguous().agvs[0].turn;
    const std::vector<EventEntry> lines = log.linesFor(snapshot, 1);
    QCOMPARE(lines.size(), std::size_t{1});
    QVERIFY(lines[0].level == EventLevel::Warning);
}

void ShiftLogTest::aChangedWheelSpeedIsWrittenWithBothValues()
{
    ShiftLog log;
    PlantSnapshot snapshot = withCharge(1.0);
    log.linesFor(snapshot, 1);
    snapshot.agvs[3].turnSpeed_m_s = 0.08;
    const std::vector<EventEntry> lines = log.linesFor(snapshot, 2);
    QCOMPARE(lines.size(), std::size_t{1});
    QCOMPARE(textOf(lines[0]), QStringLiteral("Wheel speed of its turns changed from 100 mm/s to 80 mm/s"));
}

void ShiftLogTest::aChangedSleeptimeIsWrittenWithBothValues()
{
    ShiftLog log;
    PlantSnapshot snapshot = withCharge(1.0);
    log.linesFor(snapshot, 1);
    snapshot.agvs[3].turnTime_s = 1.18;
    const std::vector<EventEntry> lines = log.linesFor(snapshot, 2);
    QCOMPARE(lines.size(), std::size_t{1});
    QCOMPARE(lines[0].source, std::string("AGV 4"));
    QCOMPARE(textOf(lines[0]), QStringLiteral("Sleeptime changed from 1,125 ms to 1,180 ms"));
}

void ShiftLogTest::theNextStepLeadsFromClosedReadersToLocatedAgvs()
{
    const PlantLayout plant = scenes::wholePlant();
    QVERIFY(NextStep::text(plant, scenes::idle()).contains(QStringLiteral("Open RFID")));
    PlantSnapshot away = scenes::linksUp();
    for (AgvSnapshot& agv : away.agvs)
        agv.robotLink.state = LinkState::Waiting;
    QVERIFY(NextStep::text(plant, away).contains(QStringLiteral("Switch the AGVs on")));
    QVERIFY(NextStep::text(plant, scenes::linksUp()).contains(QStringLiteral("AGV 1, 2, 3, 4")));
    QVERIFY(NextStep::text(plant, scenes::turning()).contains(QStringLiteral("Turning: AGV 1")));
    PlantSnapshot located = scenes::linksUp();
    for (AgvSnapshot& agv : located.agvs)
        agv.pose = Pose2{};
    QVERIFY(NextStep::text(plant, located).isEmpty());
    QVERIFY(!NextStep::text({}, {}).isEmpty());
}

QTEST_MAIN(ShiftLogTest)
#include "test_shift_log.moc"
