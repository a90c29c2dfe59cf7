// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "model/plot_csv.h"
#include "model/plot_feed.h"
#include "model/statistics_table_model.h"

#include <QAbstractItemModelTester>
#include <QDateTime>
#include <QSet>

using namespace agv;
using namespace agv::model;

namespace {

PlantSnapshot at(double seconds, std::optional<Pose2> pose)
{
    PlantSnapshot snapshot;
    snapshot.time = Time{std::chrono::hours(5)} + durationFromSeconds(seconds);
    AgvSnapshot& agv = snapshot.agvs.emplace_back();
    agv.id = RobotId{2};
    agv.pose = pose;
    agv.commanded = {0.1, -0.05};
    agv.battery = BatteryStatus{};
    agv.battery->voltage_V = 15.5;
    agv.battery->capacity_Ah = 4.0;
    agv.battery->charge_Ah = 3.0;
    agv.readerLink.messagesPerSecond = 24.5;
    agv.readerLink.dataAge_s = 0.012;
    snapshot.uwb = UwbSnapshot{};
    UwbTagSnapshot& tag = snapshot.uwb->tags.emplace_back();
    tag.id = 5;
    tag.ranges = {{0, 2.5, -0.012, false}, {3, 3.5, std::nullopt, false}};
    return snapshot;
}

double last(const PlotFeed& feed, SeriesKey key) { return feed.series().at(key).back().value; }

} // namespace

class PlotFeedTest : public QObject {
    Q_OBJECT

private slots:
    void valuesComeInTheUnitsOfTheScreen();
    void errorsAreFromTheReferenceFromWhenItWasGiven();
    void aNewReferenceBeginsTheErrorsAnew();
    void whatRestsIsNotedSeldomAndWhatMovesAlways();
    void everyGroupHasANameAUnitAndAColumn();
    void theCsvHasUnitsUtcAndEmptyFields();
    void theTableOfStatisticsIsAConsistentModel();
};

void PlotFeedTest::valuesComeInTheUnitsOfTheScreen()
{
    PlotFeed feed;
    feed.add(at(0.0, Pose2{{1.2, 0.8}, radFromDeg(90.0)}));
    QCOMPARE(last(feed, {PlotGroup::Position, 2, 0}), 1200.0);
    QCOMPARE(last(feed, {PlotGroup::Position, 2, 1}), 800.0);
    QCOMPARE(last(feed, {PlotGroup::Heading, 2, 0}), 90.0);
    QCOMPARE(last(feed, {PlotGroup::WheelSpeeds, 2, 1}), -50.0);
    QCOMPARE(last(feed, {PlotGroup::Charge, 2, 0}), 75.0);
    QCOMPARE(last(feed, {PlotGroup::Voltage, 2, 0}), 15.5);
    QCOMPARE(last(feed, {PlotGroup::Rates, 2, 0}), 24.5);
    QCOMPARE(last(feed, {PlotGroup::Ages, 2, 0}), 12.0);
    QCOMPARE(last(feed, {PlotGroup::Ranges, 5, 3}), 3500.0);
    QCOMPARE(last(feed, {PlotGroup::Residuals, 5, 0}), -12.0);
    QVERIFY(!feed.series().contains({PlotGroup::Residuals, 5, 3}));
    QVERIFY(!feed.series().contains({PlotGroup::PositionError, 2, 0}));
    QCOMPARE(feed.subjectsOf(PlotGroup::Ranges), std::vector<int>{5});
    QCOMPARE(feed.keysOf(PlotGroup::Ranges, 5).size(), std::size_t{2});
    QVERIFY(feed.keysOf(PlotGroup::Ranges, 6).empty());
}

void PlotFeedTest::errorsAreFromTheReferenceFromWhenItWasGiven()
{
    PlotFeed feed;
    feed.add(at(0.0, Pose2{{1.0, 1.0}, 0.0}));
    feed.setReference(2, Pose2{{1.003, 0.996}, radFromDeg(179.0)});
    feed.add(at(1.0, Pose2{{1.0, 1.0}, radFromDeg(-179.0)}));
    QCOMPARE(feed.series().at({PlotGroup::PositionError, 2, 0}).size(), std::size_t{1});
    QVERIFY(std::abs(last(feed, {PlotGroup::PositionError, 2, 0}) - 5.0) < 1e-9);
    QVERIFY(std::abs(last(feed, {PlotGroup::HeadingError, 2, 0}) - 2.0) < 1e-9); // across 180 degrees
}

void PlotFeedTest::aNewReferenceBeginsTheErrorsAnew()
{
    PlotFeed feed;
    feed.setReference(2, Pose2{});
    feed.add(at(0.0, Pose2{{1.0, 1.0}, 0.0}));
    feed.setReference(2, Pose2{{1.0, 1.0}, 0.0});
    QVERIFY(!feed.series().contains({PlotGroup::PositionError, 2, 0}));
    feed.add(at(1.0, Pose2{{1.0, 1.0}, 0.0}));
    QCOMPARE(last(feed, {PlotGroup::PositionError, 2, 0}), 0.0);
    feed.setReference(2, std::nullopt);
    QVERIFY(!feed.reference(2));
}

void PlotFeedTest::whatRestsIsNotedSeldomAndWhatMovesAlways()
{
    PlotFeed feed;
    for (int i = 0; i < 300; ++i)
        feed.add(at(i / 30.0, Pose2{{0.001 * i, 1.0}, 0.0}));
    QCOMPARE(feed.series().at({PlotGroup::Position, 2, 0}).size(), std::size_t{300});
    const std::size_t resting = feed.series().at({PlotGroup::Position, 2, 1}).size();
    QVERIFY2(resting >= 40 && resting <= 51, qPrintable(QString::number(resting)));
}

void PlotFeedTest::everyGroupHasANameAUnitAndAColumn()
{
    QSet<QString> names;
    QSet<QString> columns;
    for (int i = 0; i < plotGroupCount; ++i) {
        const auto group = static_cast<PlotGroup>(i);
        QVERIFY(!PlotFeed::name(group).isEmpty() && !PlotFeed::unit(group).isEmpty());
        names << PlotFeed::name(group);
        columns << PlotFeed::columnName({group, 1, 0});
    }
    QCOMPARE(names.size(), plotGroupCount);
    QCOMPARE(columns.size(), plotGroupCount);
    QCOMPARE(PlotFeed::columnName({PlotGroup::Position, 1, 0}), QStringLiteral("agv1_x_mm"));
    QCOMPARE(PlotFeed::columnName({PlotGroup::Residuals, 5, 3}), QStringLiteral("tag5_residual_anchor3_mm"));
    QCOMPARE(PlotFeed::columnName({PlotGroup::WheelSpeeds, 4, 1}), QStringLiteral("agv4_wheel_right_mm_s"));
}

void PlotFeedTest::theCsvHasUnitsUtcAndEmptyFields()
{
    PlotFeed feed;
    feed.add(at(0.0, Pose2{{1.0, 2.0}, 0.0}));
    feed.add(at(0.05, Pose2{{1.0005, 2.0}, 0.0})); // y rests
    feed.add(at(9.0, Pose2{{3.0, 2.0}, 0.0}));
    const QStringList lines =
        QString::fromStdString(plotCsv(feed, feed.keysOf(PlotGroup::Position, 2), 0.0, 1.0))
            .split(QStringLiteral("\r\n"));
    QCOMPARE(lines.size(), 4); // head, two rows, and the end
    QCOMPARE(lines[0], QStringLiteral("t_s,t_utc,agv2_x_mm,agv2_y_mm"));
    const QStringList first = lines[1].split(QLatin1Char(','));
    QCOMPARE(first[0], QStringLiteral("0.000"));
    QCOMPARE(QDateTime::fromString(first[1], Qt::ISODateWithMs).toMSecsSinceEpoch(), feed.began_utc_ms());
    QVERIFY(first[1].endsWith(QLatin1Char('Z')));
    QCOMPARE(first[2], QStringLiteral("1000"));
    QVERIFY(lines[2].endsWith(QStringLiteral(",1000.5,")));
}

void PlotFeedTest::theTableOfStatisticsIsAConsistentModel()
{
    StatisticsTableModel table;
    const QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::QtTest);
    SeriesStatistics statistics;
    statistics.count = 3;
    statistics.mean = 12.345;
    table.setRows(
        {{QStringLiteral("AGV 1"), std::nullopt, statistics}, {QStringLiteral("AGV 2"), 1.0, std::nullopt}},
        QStringLiteral("mm"));
    QCOMPARE(table.headerData(StatisticsTableModel::Mean, Qt::Horizontal, Qt::DisplayRole).toString(),
             QStringLiteral("Mean, mm"));
    QVERIFY(table.index(0, StatisticsTableModel::Mean).data().toString().startsWith(QStringLiteral("12")));
    table.setRows({}, QStringLiteral("mm"));
    QCOMPARE(table.rowCount(), 0);
}

QTEST_GUILESS_MAIN(PlotFeedTest)
#include "test_plot_feed.moc"
