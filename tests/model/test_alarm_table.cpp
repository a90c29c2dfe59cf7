// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "model/alarm_table_model.h"
#include "model/alarm_words.h"

#include <QAbstractItemModelTester>
#include <QPersistentModelIndex>

#include <set>

using namespace agv;
using namespace agv::model;

namespace {

AlarmSnapshot alarm(AlarmKind kind, int subject, AlarmState state = AlarmState::Unacknowledged)
{
    AlarmSnapshot result;
    result.key = {kind, subject};
    result.state = state;
    result.holds = state != AlarmState::Returned;
    result.raised_utc_ms = 1'700'000'000'000;
    return result;
}

QString cell(const AlarmTableModel& model, int row, int column)
{
    return model.index(row, column).data().toString();
}

} // namespace

class AlarmTableTest : public QObject {
    Q_OBJECT

private slots:
    void staysAConsistentModelWhileAlarmsComeAndGo();
    void aChosenAlarmStaysChosenWhenTheOrderChanges();
    void countsWhatIsNewAndWhatHolds();
    void everyKindSaysWhatIsTheMatterAndWhatToDo();
    void saysHowOftenAnAlarmCame();
    void saysHowLongAnAlarmIsShelved();
};

void AlarmTableTest::staysAConsistentModelWhileAlarmsComeAndGo()
{
    AlarmTableModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setAlarms({alarm(AlarmKind::RobotLink, 1), alarm(AlarmKind::BatteryLow, 2)});
    QCOMPARE(model.rowCount(), 2);
    model.setAlarms({alarm(AlarmKind::BatteryLow, 2, AlarmState::Acknowledged)});
    QCOMPARE(cell(model, 0, AlarmTableModel::Source), QStringLiteral("AGV 2"));
    model.setAlarms({});
    QCOMPARE(model.rowCount(), 0);
    model.setAlarms({alarm(AlarmKind::AnchorMoved, 3)});
    QCOMPARE(cell(model, 0, AlarmTableModel::Source), QStringLiteral("Anchor 3"));
}

void AlarmTableTest::aChosenAlarmStaysChosenWhenTheOrderChanges()
{
    AlarmTableModel model;
    model.setAlarms({alarm(AlarmKind::RobotLink, 1), alarm(AlarmKind::BatteryLow, 2)});
    const QPersistentModelIndex chosen = model.index(1, 0);
    model.setAlarms(
        {alarm(AlarmKind::MayBeMoving, 4), alarm(AlarmKind::BatteryLow, 2), alarm(AlarmKind::RobotLink, 1)});
    QCOMPARE(chosen.row(), 1);
    model.setAlarms({alarm(AlarmKind::BatteryLow, 2), alarm(AlarmKind::RobotLink, 1)});
    QCOMPARE(chosen.row(), 0);
    model.setAlarms({alarm(AlarmKind::RobotLink, 1)});
    QVERIFY(!chosen.isValid());
}

void AlarmTableTest::countsWhatIsNewAndWhatHolds()
{
    AlarmTableModel model;
    AlarmSnapshot heldBack = alarm(AlarmKind::Stranger, 0);
    heldBack.heldBack = true;
    model.setAlarms({alarm(AlarmKind::RobotLink, 1),
                     alarm(AlarmKind::BatteryLow, 2, AlarmState::Acknowledged),
                     alarm(AlarmKind::ReaderLink, 2, AlarmState::Returned), heldBack,
                     alarm(AlarmKind::UwbLink, 0, AlarmState::Shelved)});
    QCOMPARE(model.newCount(), 2);
    QCOMPARE(model.activeCount(), 3);
}

void AlarmTableTest::everyKindSaysWhatIsTheMatterAndWhatToDo()
{
    std::set<QString> sentences;
    for (int kind = 0; kind <= static_cast<int>(AlarmKind::Stranger); ++kind) {
        AlarmSnapshot shown = alarm(static_cast<AlarmKind>(kind), 1);
        shown.detail = "17";
        const QString what = AlarmWords::what(shown);
        const QString remedy = AlarmWords::remedy(shown.key.kind);
        QVERIFY2(!what.isEmpty() && !what.endsWith(QLatin1Char('.')), qPrintable(what));
        QVERIFY2(remedy.endsWith(QLatin1Char('.')) || remedy.endsWith(QLatin1Char('?')), qPrintable(remedy));
        QVERIFY(sentences.insert(what).second && sentences.insert(remedy).second);
        QVERIFY(!AlarmWords::source(shown.key).isEmpty());
    }
}

void AlarmTableTest::saysHowOftenAnAlarmCame()
{
    AlarmTableModel model;
    AlarmSnapshot shown = alarm(AlarmKind::RobotLink, 1);
    shown.occurrences = 3;
    model.setAlarms({shown});
    QVERIFY(cell(model, 0, AlarmTableModel::Text).endsWith(QStringLiteral("(3 times)")));
}

void AlarmTableTest::saysHowLongAnAlarmIsShelved()
{
    AlarmTableModel model;
    AlarmSnapshot shown = alarm(AlarmKind::RobotLink, 1, AlarmState::Shelved);
    shown.shelvedFor_s = 300.0;
    model.setAlarms({shown});
    QVERIFY(cell(model, 0, AlarmTableModel::State).contains(QStringLiteral("5")));
}

QTEST_GUILESS_MAIN(AlarmTableTest)
#include "test_alarm_table.moc"
