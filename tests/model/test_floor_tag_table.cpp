// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "model/floor_tag_table_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

using namespace agv;
using namespace agv::model;

namespace {

PlantSnapshot reading(double seconds, std::optional<TagUid> uid, int robot = 2, int rssi = 5)
{
    PlantSnapshot snapshot;
    snapshot.time = Time{std::chrono::seconds(100)} + durationFromSeconds(seconds);
    AgvSnapshot& agv = snapshot.agvs.emplace_back();
    agv.id = RobotId{robot};
    if (uid)
        agv.recentReads.push_back({snapshot.time, *uid, rssi});
    return snapshot;
}

void turned(PlantSnapshot& snapshot, const std::vector<TagUid>& missed, const std::vector<TagUid>& unknown)
{
    auto result = std::make_shared<TurnEstimate>();
    result->valid = true;
    result->stops.emplace_back().antenna = {1.0, 2.0};
    result->stops[0].missed = missed;
    result->stops[0].unknown = unknown;
    snapshot.agvs[0].turn.result = result;
}

QString cell(const FloorTagTableModel& model, int row, int column)
{
    return model.index(row, column).data().toString();
}

} // namespace

class FloorTagTableTest : public QObject {
    Q_OBJECT

private slots:
    void aTagThatIsReadTellsByWhomHowStrongAndWhen();
    void aTurnTellsMissingAndUnknownTags();
    void staysAConsistentModelWhileUnknownTagsComeAndGo();
    void onlyRowsThatDifferAreTold();
    void sortsByNumbersNotByTheirText();
};

void FloorTagTableTest::aTagThatIsReadTellsByWhomHowStrongAndWhen()
{
    FloorTagTableModel model;
    const std::vector<FloorTag> tags = tagGrid(3, 3, 0.1, {}, TagUid{0x100});
    model.setTags(tags);
    model.setSnapshot(reading(0.0, std::nullopt));
    QCOMPARE(cell(model, 4, FloorTagTableModel::State),
             FloorTagTableModel::stateText(FloorTagState::NotSeen));
    model.setSnapshot(reading(1.0, tags[4].uid));
    QCOMPARE(cell(model, 4, FloorTagTableModel::State),
             FloorTagTableModel::stateText(FloorTagState::SeenNow));
    QCOMPARE(cell(model, 4, FloorTagTableModel::Robot), QStringLiteral("AGV 2"));
    QCOMPARE(cell(model, 4, FloorTagTableModel::Rssi), QStringLiteral("5"));
    model.setSnapshot(reading(31.0, std::nullopt));
    QCOMPARE(cell(model, 4, FloorTagTableModel::State),
             FloorTagTableModel::stateText(FloorTagState::SeenBefore));
    QVERIFY(cell(model, 4, FloorTagTableModel::Age).startsWith(QStringLiteral("30")));
}

void FloorTagTableTest::aTurnTellsMissingAndUnknownTags()
{
    FloorTagTableModel model;
    const std::vector<FloorTag> tags = tagGrid(3, 3, 0.1, {}, TagUid{0x100});
    model.setTags(tags);
    PlantSnapshot snapshot = reading(0.0, std::nullopt);
    turned(snapshot, {tags[7].uid}, {TagUid{0x999}});
    model.setSnapshot(snapshot);
    QCOMPARE(cell(model, 7, FloorTagTableModel::State),
             FloorTagTableModel::stateText(FloorTagState::Missing));
    QVERIFY(model.index(7, FloorTagTableModel::State).data(FloorTagTableModel::WarningRole).toBool());
    QCOMPARE(model.rowCount(), 10);
    QCOMPARE(cell(model, 9, FloorTagTableModel::State),
             FloorTagTableModel::stateText(FloorTagState::Unknown));
    QCOMPARE(model.placeOf(9), (Point2{1.0, 2.0}));
}

void FloorTagTableTest::staysAConsistentModelWhileUnknownTagsComeAndGo()
{
    FloorTagTableModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setTags(tagGrid(3, 3, 0.1, {}, TagUid{0x100}));
    int second = 0;
    for (const std::vector<TagUid>& unknown :
         {std::vector<TagUid>{TagUid{1}, TagUid{2}}, {}, {TagUid{3}}, {TagUid{3}}, {TagUid{4}, TagUid{3}}}) {
        PlantSnapshot snapshot = reading(++second, std::nullopt);
        turned(snapshot, {}, unknown);
        model.setSnapshot(snapshot);
        QCOMPARE(model.rowCount(), 9 + static_cast<int>(unknown.size()));
    }
    model.setTags({});
    QCOMPARE(model.rowCount(), 0);
}

void FloorTagTableTest::onlyRowsThatDifferAreTold()
{
    FloorTagTableModel model;
    const std::vector<FloorTag> tags = tagGrid(100, 100, 0.1, {}, TagUid{0x100});
    model.setTags(tags);
    model.setSnapshot(reading(0.0, std::nullopt));
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    model.setSnapshot(reading(1.0, tags[77].uid));
    QCOMPARE(changes.size(), 1);
    QCOMPARE(changes[0][0].toModelIndex().row(), 77);
    for (int i = 1; i < 10; ++i)
        model.setSnapshot(reading(1.0 + 0.033 * i, tags[77].uid)); // within half a second
    QCOMPARE(changes.size(), 1);
}

void FloorTagTableTest::sortsByNumbersNotByTheirText()
{
    FloorTagTableModel model;
    model.setTags(tagGrid(4, 4, 0.1, {}, TagUid{0x100}));
    const auto key = [&](int row, int column) {
        return model.index(row, column).data(FloorTagTableModel::SortRole);
    };
    QVERIFY(key(1, FloorTagTableModel::Number).toInt() < key(9, FloorTagTableModel::Number).toInt());
    QVERIFY(key(0, FloorTagTableModel::Y).toDouble() < key(1, FloorTagTableModel::Y).toDouble());
    QVERIFY(key(0, FloorTagTableModel::Age).toDouble() > 1e9); // never read comes last
}

QTEST_GUILESS_MAIN(FloorTagTableTest)
#include "test_floor_tag_table.moc"
