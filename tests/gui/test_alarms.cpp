// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/alarm_panel.h"
#include "gui/hint_table_view.h"
#include "gui/window_fixture.h"

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QSignalSpy>
#include <QToolButton>

using namespace agv;
using namespace agv::gui;

namespace {

AlarmSnapshot alarmOf(AlarmKind kind, int subject, AlarmPriority priority,
                      AlarmState state = AlarmState::Unacknowledged)
{
    AlarmSnapshot alarm;
    alarm.key = {kind, subject};
    alarm.priority = priority;
    alarm.state = state;
    alarm.holds = state != AlarmState::Returned;
    alarm.raised_utc_ms = 1'700'000'000'000;
    return alarm;
}

PlantSnapshot with(const std::vector<AlarmSnapshot>& alarms)
{
    PlantSnapshot snapshot = scenes::linksUp();
    snapshot.alarms = alarms;
    return snapshot;
}

const AlarmSnapshot moving = alarmOf(AlarmKind::MayBeMoving, 1, AlarmPriority::High);
const AlarmSnapshot battery = alarmOf(AlarmKind::BatteryLow, 2, AlarmPriority::Medium);
const AlarmSnapshot seen = alarmOf(AlarmKind::ReaderLink, 3, AlarmPriority::Medium, AlarmState::Acknowledged);

using Keys = std::vector<AlarmKey>;

} // namespace

class AlarmsTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theButtonAlwaysTellsHowManyThereAre();
    void theButtonShowsTheList();
    void theEmptyListSaysSo();
    void allNewOnesAreAcknowledgedWhenNoneIsChosen();
    void onlyTheChosenOnesAreAcknowledged();
    void aChosenOneIsShelvedAndBroughtBack();
    void aHighOneIsNotShelved();
    void aFloodIsSaid();
    void theEventLogTellsTheirStory();
    void theKeysWork();

private:
    void show(const std::vector<AlarmSnapshot>& alarms) const { m_window->showSnapshot(with(alarms)); }
    HintTableView* table() const { return find<HintTableView>("alarmTable"); }
    QString log() const
    {
        QString text;
        const QAbstractItemModel* events = find<HintTableView>("table")->model();
        for (int row = 0; row < events->rowCount(); ++row)
            text += events->index(row, 3).data().toString() + QLatin1Char('\n');
        return text;
    }
    /// What the window asks for while `act` runs.
    template<typename Signal>
    QList<QVariantList> asked(Signal signal, const std::function<void()>& act) const
    {
        QSignalSpy spy(m_window.get(), signal);
        act();
        return spy;
    }
};

void AlarmsTest::theButtonAlwaysTellsHowManyThereAre()
{
    auto* button = find<QToolButton>("alarmButton");
    QVERIFY(button->isVisible());
    show({});
    QCOMPARE(button->text(), QStringLiteral("No alarms"));
    show({moving, battery, seen});
    QCOMPARE(button->text(), QStringLiteral("Alarms: 3, 2 new"));
    QCOMPARE(button->accessibleName(), button->text());
    show({seen});
    QCOMPARE(button->text(), QStringLiteral("Alarms: 1"));
}

void AlarmsTest::theButtonShowsTheList()
{
    show({battery});
    find<QDockWidget>("alarmsDock")->close();
    QVERIFY(!table()->isVisible());
    click("alarmButton");
    QVERIFY(table()->isVisible());
    QCOMPARE(table()->model()->rowCount(), 1);
}

void AlarmsTest::theEmptyListSaysSo()
{
    show({});
    QVERIFY(table()->hint().startsWith(QStringLiteral("No alarms")));
    QVERIFY(!find<QAbstractButton>("acknowledgeButton")->isEnabled());
}

void AlarmsTest::allNewOnesAreAcknowledgedWhenNoneIsChosen()
{
    show({moving, battery, seen});
    const auto asks = asked(&MainWindow::acknowledgeAlarmsRequested, [this] {
        find<QAction>("showAlarmsAction")->trigger();
        click("acknowledgeButton");
    });
    QCOMPARE(asks.size(), 1);
    QCOMPARE(asks[0][0].value<Keys>(), (Keys{moving.key, battery.key}));
}

void AlarmsTest::onlyTheChosenOnesAreAcknowledged()
{
    show({moving, battery, seen});
    table()->selectRow(1);
    const auto asks = asked(&MainWindow::acknowledgeAlarmsRequested,
                            [this] { find<QAction>("acknowledgeAction")->trigger(); });
    QCOMPARE(asks.size(), 1);
    QCOMPARE(asks[0][0].value<Keys>(), Keys{battery.key});
    table()->selectRow(2);
    QVERIFY(!find<QAbstractButton>("acknowledgeButton")->isEnabled());
    QVERIFY(asked(&MainWindow::acknowledgeAlarmsRequested, [this] {
                find<QAction>("acknowledgeAction")->trigger();
            }).isEmpty());
}

void AlarmsTest::aChosenOneIsShelvedAndBroughtBack()
{
    show({battery});
    table()->selectRow(0);
    const auto asks =
        asked(&MainWindow::shelveAlarmsRequested, [this] { find<QAction>("shelve60Action")->trigger(); });
    QCOMPARE(asks.size(), 1);
    QCOMPARE(asks[0][0].value<Keys>(), Keys{battery.key});
    QCOMPARE(asks[0][1].toDouble(), 3600.0);
    AlarmSnapshot shelved = battery;
    shelved.state = AlarmState::Shelved;
    shelved.shelvedFor_s = 3600.0;
    show({shelved});
    QVERIFY(!find<QToolButton>("shelveButton")->isEnabled());
    find<QAction>("showAlarmsAction")->trigger();
    const auto back = asked(&MainWindow::unshelveAlarmsRequested, [this] { click("unshelveButton"); });
    QCOMPARE(back.size(), 1);
    QCOMPARE(back[0][0].value<Keys>(), Keys{battery.key});
}

void AlarmsTest::aHighOneIsNotShelved()
{
    show({moving});
    table()->selectRow(0);
    QVERIFY(!find<QToolButton>("shelveButton")->isEnabled());
    QVERIFY(asked(&MainWindow::shelveAlarmsRequested, [this] {
                find<QAction>("shelve10Action")->trigger();
            }).isEmpty());
}

void AlarmsTest::aFloodIsSaid()
{
    find<QAction>("showAlarmsAction")->trigger();
    show({battery});
    QVERIFY(!find<QLabel>("floodLabel")->isVisible());
    PlantSnapshot flood = with({battery});
    flood.alarmFlood = true;
    m_window->showSnapshot(flood);
    QVERIFY(find<QLabel>("floodLabel")->isVisible());
}

void AlarmsTest::theEventLogTellsTheirStory()
{
    show({battery});
    QVERIFY(log().contains(QStringLiteral("Alarm: The battery is low. Charge it soon")));
    show({battery});
    QCOMPARE(log().count(QStringLiteral("Alarm: The battery is low")), 1);
    AlarmSnapshot known = battery;
    known.state = AlarmState::Acknowledged;
    show({known});
    QVERIFY(log().contains(QStringLiteral("Alarm acknowledged: The battery is low")));
    show({});
    QVERIFY(log().contains(QStringLiteral("Alarm over: The battery is low")));
}

void AlarmsTest::theKeysWork()
{
    show({battery});
    find<QDockWidget>("alarmsDock")->close();
    QTest::keyClick(m_window.get(), Qt::Key_F8);
    QVERIFY(table()->isVisible());
    const auto asks = asked(&MainWindow::acknowledgeAlarmsRequested,
                            [this] { QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ControlModifier); });
    QCOMPARE(asks.size(), 1);
}

QTEST_MAIN(AlarmsTest)
#include "test_alarms.moc"
