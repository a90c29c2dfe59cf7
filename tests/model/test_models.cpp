// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "core/units.h"
#include "model/event_table_model.h"
#include "model/link_table_model.h"
#include "model/stop_table_model.h"
#include "model/uncertainty.h"
#include "model/vehicle_table_model.h"
#include "model/words.h"
#include "recording/turn_file.h"

#include <QLocale>

#include <cmath>

using namespace agv;
using namespace agv::model;

namespace {

using Tester = QAbstractItemModelTester;

PlantSnapshot twoAgvs()
{
    PlantSnapshot snapshot;
    for (int i = 1; i <= 2; ++i) {
        AgvSnapshot agv;
        agv.id = {i};
        agv.name = "AGV " + std::to_string(i);
        agv.readerLink.name = "RFID reader";
        agv.readerLink.address = "192.168.0.100:8883";
        snapshot.agvs.push_back(agv);
    }
    return snapshot;
}

TurnSnapshot turnWithTags(std::vector<std::vector<std::pair<TagUid, int>>> stops)
{
    TurnSnapshot turn;
    for (std::size_t i = 0; i < stops.size(); ++i)
        turn.table.push_back({static_cast<int>(i + 1), stops[i], 3, true});
    return turn;
}

QString cell(const QAbstractItemModel& model, int row, int column)
{
    return model.index(row, column).data().toString();
}

} // namespace

class ModelTest : public QObject {
    Q_OBJECT
private slots:
    void init() { QLocale::setDefault(QLocale(QStringLiteral("en_GB"))); }
    void linkRowsStayInPlaceWhenValuesChange();
    void linkRowsAreRebuiltWhenThePlantGrows();
    void aLinkThatIsNotUpShowsNoRate();
    void theUwbUnitIsTheLastRowWithItsDialectAndGaps();
    void aChangedDialectChangesTheRowOfTheUwbUnit();
    void theReasonsForDroppedMessagesAreInTheToolTip();
    void valuesOfAnAbsentRobotAreNotShown();
    void aConnectedRobotThatReportedNothingIsInAnUnknownState();
    void aWeakBatteryAsksForAttention();
    void aRobotThatMayBeMovingAsksForAttention();
    void theTableOfStopsHasAsManyColumnsAsTheFullestStop();
    void theTableOfStopsIsCopiedWithFullIdsInPlainNumbers();
    void theCopiedTableOfStopsIsReadAsTheTurnItShows();
    void theCopiedTableOfATurnWithoutReadsHasNoTags();
    void theTableOfStopsChangesUnderTheModelTester();
    void theEventLogForgetsTheOldestBeyondItsCapacity();
    void aRepeatedEventIsCountedInItsRow();
    void anEventIsCopiedWithItsUtcTime();
    void numbersFollowTheLocaleAndCarryTheirUnit();
    void theEllipseOfADiagonalCovarianceLiesAlongTheAxes();
    void theEllipseTurnsWithTheCovariance();
    void aBrokenCovarianceGivesNoNan();
};

void ModelTest::linkRowsStayInPlaceWhenValuesChange()
{
    LinkTableModel model;
    Tester tester(&model, Tester::FailureReportingMode::QtTest);
    PlantSnapshot snapshot = twoAgvs();
    model.setSnapshot(snapshot);
    QCOMPARE(model.rowCount(), 4);
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    snapshot.agvs[1].robotLink.state = LinkState::Up;
    model.setSnapshot(snapshot);
    model.setSnapshot(snapshot);
    QCOMPARE(resets.count(), 0);
    QCOMPARE(changes.count(), 1);
    QCOMPARE(changes[0][0].toModelIndex().row(), 3);
    QCOMPARE(cell(model, 3, LinkTableModel::State), QStringLiteral("Up"));
    QCOMPARE(model.countIn(LinkState::Up), 1);
}

void ModelTest::linkRowsAreRebuiltWhenThePlantGrows()
{
    LinkTableModel model;
    Tester tester(&model, Tester::FailureReportingMode::QtTest);
    PlantSnapshot snapshot = twoAgvs();
    model.setSnapshot(snapshot);
    snapshot.agvs.pop_back();
    model.setSnapshot(snapshot);
    QCOMPARE(model.rowCount(), 2);
}

void ModelTest::aLinkThatIsNotUpShowsNoRate()
{
    LinkTableModel model;
    PlantSnapshot snapshot = twoAgvs();
    snapshot.agvs[0].readerLink.state = LinkState::Silent;
    snapshot.agvs[0].readerLink.messagesPerSecond = 20.0;
    model.setSnapshot(snapshot);
    QCOMPARE(cell(model, 0, LinkTableModel::Data), QStringLiteral("–"));
}

void ModelTest::theUwbUnitIsTheLastRowWithItsDialectAndGaps()
{
    LinkTableModel model;
    Tester tester(&model, Tester::FailureReportingMode::QtTest);
    PlantSnapshot snapshot = twoAgvs();
    UwbSnapshot uwb;
    uwb.link.name = "UWB";
    uwb.link.state = LinkState::Up;
    uwb.link.messagesPerSecond = 20.0;
    uwb.link.dropped = 3;
    uwb.dialect = UwbDialect::Trek;
    uwb.unit = UwbUnit{"Ver.2.25mx TREK", {true, 2, UwbRole::Anchor, 0}};
    uwb.missed = 17;
    snapshot.uwb = uwb;
    model.setSnapshot(snapshot);
    QCOMPARE(model.rowCount(), 5);
    QCOMPARE(cell(model, 4, LinkTableModel::Connection), QStringLiteral("UWB (trek)"));
    QCOMPARE(cell(model, 4, LinkTableModel::Data), QStringLiteral("20.0\u00a0/s"));
    QCOMPARE(cell(model, 4, LinkTableModel::Dropped), QStringLiteral("3"));
    QCOMPARE(model.index(4, 0).data(LinkTableModel::RobotRole).toInt(), 0);
    const QString toolTip = model.index(4, 0).data(Qt::ToolTipRole).toString();
    for (const char* text : {"trek, found from the reports", "Ver.2.25mx TREK", "channel 2", "6.81 Mb/s",
                             "Exchanges missed: 17"})
        QVERIFY2(toolTip.contains(QLatin1String(text)), qPrintable(toolTip));
}

void ModelTest::aChangedDialectChangesTheRowOfTheUwbUnit()
{
    LinkTableModel model;
    PlantSnapshot snapshot;
    snapshot.uwb = UwbSnapshot{};
    model.setSnapshot(snapshot);
    QCOMPARE(cell(model, 0, LinkTableModel::Connection), QStringLiteral("UWB"));
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    snapshot.uwb->tags.push_back({});
    snapshot.uwb->anchors.push_back({});
    snapshot.uwb->anchorPairs.push_back({});
    snapshot.uwb->calibration.progress = 0.5;
    model.setSnapshot(snapshot);
    QCOMPARE(changes.count(), 0);
    snapshot.uwb->dialect = UwbDialect::UlmFour;
    model.setSnapshot(snapshot);
    QCOMPARE(changes.count(), 1);
    QCOMPARE(cell(model, 0, LinkTableModel::Connection), QStringLiteral("UWB (ulm4)"));
}

void ModelTest::theReasonsForDroppedMessagesAreInTheToolTip()
{
    LinkTableModel model;
    PlantSnapshot snapshot = twoAgvs();
    snapshot.agvs[0].readerLink.dropped = 4;
    snapshot.agvs[0].readerLink.dropDetail = "3 garbled, 1 over-long";
    model.setSnapshot(snapshot);
    QVERIFY(model.index(0, 0)
                .data(Qt::ToolTipRole)
                .toString()
                .contains(QStringLiteral("3 garbled, 1 over-long")));
    QCOMPARE(cell(model, 0, LinkTableModel::Dropped), QStringLiteral("4"));
}

void ModelTest::valuesOfAnAbsentRobotAreNotShown()
{
    VehicleTableModel model;
    Tester tester(&model, Tester::FailureReportingMode::QtTest);
    PlantSnapshot snapshot = twoAgvs();
    snapshot.agvs[0].battery =
        BatteryStatus{ChargingState::NotCharging, 15.2, -0.5, 25, 1.5, 2.0, false, false};
    snapshot.agvs[0].robotState = RobotState::Idle;
    snapshot.agvs[0].robotLink.state = LinkState::Waiting;
    model.setSnapshot(snapshot);
    QCOMPARE(cell(model, 0, VehicleTableModel::Battery), QStringLiteral("–"));
    QCOMPARE(cell(model, 0, VehicleTableModel::State), QStringLiteral("Not connected"));
    snapshot.agvs[0].robotLink.state = LinkState::Up;
    model.setSnapshot(snapshot);
    QCOMPARE(cell(model, 0, VehicleTableModel::Battery), QStringLiteral("15.2\u00a0V"));
    QCOMPARE(cell(model, 0, VehicleTableModel::Charge), QStringLiteral("75\u00a0%"));
    QCOMPARE(cell(model, 0, VehicleTableModel::State), QStringLiteral("Idle"));
}

void ModelTest::aConnectedRobotThatReportedNothingIsInAnUnknownState()
{
    VehicleTableModel model;
    Tester tester(&model, Tester::FailureReportingMode::QtTest);
    PlantSnapshot snapshot = twoAgvs();
    snapshot.agvs[0].battery.reset();
    snapshot.agvs[0].robotState.reset();
    snapshot.agvs[0].robotLink.state = LinkState::Silent;
    model.setSnapshot(snapshot);
    QCOMPARE(cell(model, 0, VehicleTableModel::State), QStringLiteral("State unknown"));
    const QString tip = model.index(0, VehicleTableModel::State).data(Qt::ToolTipRole).toString();
    QVERIFY2(tip.contains(QStringLiteral("has not reported")), qPrintable(tip));
}

void ModelTest::aWeakBatteryAsksForAttention()
{
    VehicleTableModel model;
    PlantSnapshot snapshot = twoAgvs();
    snapshot.agvs[0].robotLink.state = LinkState::Up;
    snapshot.agvs[0].battery =
        BatteryStatus{ChargingState::NotCharging, 13.9, -0.5, 25, 0.3, 2.0, false, false};
    model.setSnapshot(snapshot);
    QVERIFY(model.index(0, VehicleTableModel::Charge).data(VehicleTableModel::WarningRole).toBool());
    QVERIFY(!model.index(1, VehicleTableModel::Charge).data(VehicleTableModel::WarningRole).toBool());
}

void ModelTest::aRobotThatMayBeMovingAsksForAttention()
{
    VehicleTableModel model;
    PlantSnapshot snapshot = twoAgvs();
    snapshot.agvs[1].mayBeMoving = true;
    model.setSnapshot(snapshot);
    QCOMPARE(cell(model, 1, VehicleTableModel::State), QStringLiteral("May be moving"));
    QVERIFY(model.index(1, VehicleTableModel::State).data(VehicleTableModel::WarningRole).toBool());
}

void ModelTest::theTableOfStopsHasAsManyColumnsAsTheFullestStop()
{
    StopTableModel model;
    const TagUid a{0xE00401503B000001};
    const TagUid b{0xE00401503B000AE4};
    model.setTurn(turnWithTags({{{a, 4}}, {{a, 1}, {b, 7}}}));
    QCOMPARE(model.tagColumns(), 2);
    QCOMPARE(model.columnCount(), 6);
    QCOMPARE(cell(model, 1, 3), QStringLiteral("AE4"));
    QCOMPARE(cell(model, 1, 5), QStringLiteral("7"));
    QCOMPARE(cell(model, 0, 3), QString());
    QCOMPARE(model.headerData(3, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("Tag 2"));
    QCOMPARE(model.headerData(4, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("RSSI 1"));
}

void ModelTest::theTableOfStopsIsCopiedWithFullIdsInPlainNumbers()
{
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    StopTableModel model;
    TurnSnapshot turn = turnWithTags({{{TagUid{0xE00401503B000001}, 4}}, {}});
    turn.table[1].reads = 1234;
    model.setTurn(turn);
    QCOMPARE(model.toText(), QStringLiteral("Stop\tReads\tTag 1\tRSSI 1\n"
                                            "1\t3\tE00401503B000001\t4\n"
                                            "2\t1234\t\t\n"));
}

void ModelTest::theCopiedTableOfStopsIsReadAsTheTurnItShows()
{
    const auto tags = tagGrid(3, 3, 0.1, {0.0, 0.0}, TagUid{0xE00401503B000001});
    const recording::TurnFileOptions options{tags, radFromDeg(45.0), 1.125, {}};
    const std::vector<std::vector<std::pair<TagUid, int>>> shown{
        {{tags[3].uid, 0}, {tags[0].uid, 7}}, {}, {{tags[4].uid, 3}}};
    StopTableModel model;
    for (const int widest : {2, 7}) { // seven columns of tags have no defect of the old program here
        auto stops = shown;
        for (int tag = 2; tag < widest; ++tag)
            stops[0].emplace_back(tags[static_cast<std::size_t>(tag + 2)].uid, tag);
        model.setTurn(turnWithTags(stops));
        const auto file = recording::parseTurns(model.toText().toStdString(), options);
        QVERIFY2(file.has_value(), file ? "" : file.error().detail.c_str());
        QCOMPARE(file->format, recording::TurnFileFormat::Table);
        QCOMPARE(file->turns.size(), std::size_t{1});
        const auto& record = file->turns[0].record;
        QVERIFY2(record.has_value(), record ? "" : record.error().reason.c_str());
        QCOMPARE(record->stops.size(), stops.size());
        for (std::size_t stop = 0; stop < stops.size(); ++stop) {
            std::vector<std::pair<TagUid, int>> read;
            for (const TagRead& one : record->stops[stop].reads)
                read.emplace_back(one.uid, one.rssi);
            QVERIFY(read == stops[stop]);
            QVERIFY(record->stops[stop].unknownIfUnseen.empty());
        }
    }
}

void ModelTest::theCopiedTableOfATurnWithoutReadsHasNoTags()
{
    const auto tags = tagGrid(3, 3, 0.1, {0.0, 0.0}, TagUid{0xE00401503B000001});
    StopTableModel model;
    TurnSnapshot turn = turnWithTags({{}, {}, {}});
    for (StopRow& row : turn.table)
        row.reads = 0;
    model.setTurn(turn);
    QCOMPARE(model.toText(), QStringLiteral("Stop\tReads\tTag 1\tRSSI 1\n1\t0\t\t\n2\t0\t\t\n3\t0\t\t\n"));
    const auto file = recording::parseTurns(model.toText().toStdString(), {tags, radFromDeg(45.0), {}, {}});
    QVERIFY(file.has_value());
    QCOMPARE(file->turns.at(0).record->stops.size(), std::size_t{3});
    for (const TurnStop& stop : file->turns[0].record->stops)
        QVERIFY(stop.reads.empty());
}

void ModelTest::theTableOfStopsChangesUnderTheModelTester()
{
    StopTableModel model;
    Tester tester(&model, Tester::FailureReportingMode::QtTest);
    const TagUid a{0xE00401503B000001};
    model.setTurn(turnWithTags({{}}));
    model.setTurn(turnWithTags({{{a, 4}}}));
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    model.setTurn(turnWithTags({{{a, 5}}}));
    QCOMPARE(changes.count(), 1);
    model.setTurn({});
    QCOMPARE(model.rowCount(), 0);
}

void ModelTest::theEventLogForgetsTheOldestBeyondItsCapacity()
{
    EventTableModel model(3);
    Tester tester(&model, Tester::FailureReportingMode::QtTest);
    for (int i = 0; i < 5; ++i)
        model.append({i, EventLevel::Info, "Console", "event " + std::to_string(i)});
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(cell(model, 0, EventTableModel::Text), QStringLiteral("event 2"));
    QCOMPARE(cell(model, 2, EventTableModel::Text), QStringLiteral("event 4"));
}

void ModelTest::aRepeatedEventIsCountedInItsRow()
{
    EventTableModel model;
    Tester tester(&model, Tester::FailureReportingMode::QtTest);
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    const EventEntry refused{1773761405123, EventLevel::Warning, "RFID reader 1", "refused"};
    model.append(refused);
    model.append({refused.utc_ms, EventLevel::Info, "AGV 2", "between"});
    model.append(refused);
    model.append(refused);
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(changes.count(), 2);
    QVERIFY(cell(model, 0, EventTableModel::Text).startsWith(QStringLiteral("refused (3 times, last at ")));
    // Something else happened to the same reader: the next loss is news.
    model.append({refused.utc_ms, EventLevel::Info, "RFID reader 1", "Connected"});
    model.append(refused);
    QCOMPARE(model.rowCount(), 4);
}

void ModelTest::anEventIsCopiedWithItsUtcTime()
{
    EventTableModel model;
    model.append({1773761405123, EventLevel::Warning, "AGV 1", "weak battery"});
    QCOMPARE(model.rowText(0), QStringLiteral("2026-03-17T15:30:05.123Z\tWarning\tAGV 1\tweak battery"));
}

void ModelTest::numbersFollowTheLocaleAndCarryTheirUnit()
{
    QCOMPARE(Words::millimetres(1.2044), QStringLiteral("1,204\u00a0mm"));
    QCOMPARE(Words::degrees(radFromDeg(-0.04), 1), QStringLiteral("0.0°"));
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    QCOMPARE(Words::millimetres(1.2044, 1), QStringLiteral("1.204,4\u00a0mm"));
    QCOMPARE(Words::milliseconds(1.125), QStringLiteral("1.125\u00a0ms"));
}

void ModelTest::theEllipseOfADiagonalCovarianceLiesAlongTheAxes()
{
    const Ellipse95 ellipse = ellipse95({9e-6, 0, 0, 0, 1e-6, 0, 0, 0, 0});
    QVERIFY(std::abs(ellipse.major_m - 2.4477468e-3 * 3.0) < 1e-8);
    QVERIFY(std::abs(ellipse.minor_m - 2.4477468e-3) < 1e-8);
    QVERIFY(std::abs(ellipse.angle) < 1e-12);
}

void ModelTest::theEllipseTurnsWithTheCovariance()
{
    // R diag(9, 1) R^T for 30 degrees.
    const double c = std::cos(radFromDeg(30.0));
    const double s = std::sin(radFromDeg(30.0));
    const double xy = (9.0 - 1.0) * c * s;
    const Ellipse95 ellipse = ellipse95({9.0 * c * c + s * s, xy, 0, xy, 9.0 * s * s + c * c, 0, 0, 0, 0});
    QVERIFY(std::abs(degFromRad(ellipse.angle) - 30.0) < 1e-9);
    QVERIFY(std::abs(ellipse.major_m / ellipse.minor_m - 3.0) < 1e-9);
}

void ModelTest::aBrokenCovarianceGivesNoNan()
{
    const Ellipse95 ellipse = ellipse95({1e-6, 5e-6, 0, 5e-6, 1e-6, 0, 0, 0, 0});
    QVERIFY(std::isfinite(ellipse.major_m));
    QCOMPARE(ellipse.minor_m, 0.0);
}

QTEST_GUILESS_MAIN(ModelTest)
#include "test_models.moc"
