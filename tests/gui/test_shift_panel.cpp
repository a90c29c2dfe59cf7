// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hint_table_view.h"
#include "gui/shift_panel.h"
#include "gui/window_fixture.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

using namespace agv;
using namespace agv::gui;

class ShiftPanelTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theChecksBeginByKeyAndSayWhatIsWrong();
    void checksThatPassFoldToOneLine();
    void aCheckThatPassedOnceHasPassed();
    void theAgvsTurnOneAfterTheOtherAndTheVerdictGoesIntoTheLog();
    void aCheckThatFailedStandsInTheVerdict();
    void stopAllEndsTheSequence();
    void nothingIsCalibratedWhileNoAgvCan();

private:
    ShiftPanel* panel() const { return find<ShiftPanel>("shift"); }
    QString text(const char* label) const { return find<QLabel>(label)->text(); }
    void show() const { m_window->showSnapshot(m_snapshot); }
    void pass(double seconds)
    {
        m_snapshot.time += durationFromSeconds(seconds);
        show();
    }
    /// Everything connected and charged, every reader over a tag of the plant.
    void makeReady()
    {
        m_snapshot = scenes::linksUp();
        const TagUid tag = scenes::wholePlant().floorTags.front().uid;
        for (AgvSnapshot& agv : m_snapshot.agvs) {
            agv.readerLink.state = agv.robotLink.state = LinkState::Up;
            agv.readerLink.dataAge_s = 0.1;
            agv.robotState = RobotState::Idle;
            agv.battery = BatteryStatus{};
            agv.battery->capacity_Ah = 3.0;
            agv.battery->charge_Ah = 2.4;
            agv.recentReads.assign(1, TagRead{});
            agv.recentReads[0].uid = tag;
            agv.turn = {};
        }
        show();
        panel()->setFactsSource([] { return model::ShiftFacts{50'000'000'000}; });
    }
    void playTurn(int robot)
    {
        TurnSnapshot& turn = m_snapshot.agvs[static_cast<std::size_t>(robot - 1)].turn;
        turn.phase = TurnPhase::Reading;
        pass(0.1);
        turn.phase = TurnPhase::Finished;
        turn.result = scenes::goodEstimate();
        pass(20.0);
        pass(0.1);
    }
    QString log() const
    {
        QString lines;
        const QAbstractItemModel* events = find<HintTableView>("table")->model();
        for (int row = 0; row < events->rowCount(); ++row)
            lines += events->index(row, 3).data().toString() + QLatin1Char('\n');
        return lines;
    }

    PlantSnapshot m_snapshot;
};

void ShiftPanelTest::theChecksBeginByKeyAndSayWhatIsWrong()
{
    makeReady();
    m_snapshot.agvs[1].battery->charge_Ah = 0.3;
    show();
    QTest::keyClick(m_window.get(), Qt::Key_F7);
    QCOMPARE(text("summaryLabel"), QStringLiteral("Checking …"));
    QVERIFY(!find<QPushButton>("calibrateButton")->isEnabled());
    pass(3.1);
    QVERIFY2(text("summaryLabel").startsWith(QStringLiteral("1 of ")), qPrintable(text("summaryLabel")));
    QVERIFY(text("checksLabel").contains(QStringLiteral("AGV 2: battery")));
    QVERIFY(text("checksLabel").contains(QStringLiteral("Charge it")));
    QVERIFY(!text("checksLabel").contains(QStringLiteral("AGV 1")));
    QVERIFY(log().contains(QStringLiteral("Start of shift: 1 of ")));
}

void ShiftPanelTest::checksThatPassFoldToOneLine()
{
    makeReady();
    panel()->check();
    QVERIFY2(text("summaryLabel").startsWith(QStringLiteral("All ")), qPrintable(text("summaryLabel")));
    QVERIFY(!find<QLabel>("checksLabel")->isVisible());
    QVERIFY(log().contains(QStringLiteral("checks passed")));
    find<QToolButton>("allButton")->setChecked(true);
    QVERIFY(text("checksLabel").contains(QStringLiteral("AGV 4: RFID reader")));
}

void ShiftPanelTest::aCheckThatPassedOnceHasPassed()
{
    makeReady();
    const std::vector<TagRead> reads = m_snapshot.agvs[0].recentReads;
    m_snapshot.agvs[0].recentReads.clear();
    show();
    panel()->check();
    pass(1.0);
    m_snapshot.agvs[0].recentReads = reads; // between two tags for a moment
    m_snapshot.agvs[1].recentReads.clear(); // passed before
    pass(0.1);
    QVERIFY(text("summaryLabel").startsWith(QStringLiteral("All ")));
}

void ShiftPanelTest::theAgvsTurnOneAfterTheOtherAndTheVerdictGoesIntoTheLog()
{
    makeReady();
    QSignalSpy turns(m_window.get(), &MainWindow::startTurnRequested);
    find<QAction>("checkShiftAction")->trigger();
    click("calibrateButton");
    QVERIFY(!find<QPushButton>("calibrateButton")->isEnabled());
    for (int robot = 1; robot <= 4; ++robot) {
        QCOMPARE(turns.size(), robot);
        QCOMPARE(turns.last()[0].toInt(), robot);
        playTurn(robot);
        pass(0.1);
    }
    QCOMPARE(turns.size(), 4);
    QVERIFY2(text("shiftVerdictLabel").contains(QStringLiteral("Ready: all AGVs (1, 2, 3, 4)")),
             qPrintable(text("shiftVerdictLabel")));
    QVERIFY(text("turnsLabel").contains(QStringLiteral("Position found")));
    QVERIFY(log().contains(
        QStringLiteral("Start of shift: Ready: all AGVs (1, 2, 3, 4) were located in 1\u00a0min 2")));
}

void ShiftPanelTest::aCheckThatFailedStandsInTheVerdict()
{
    makeReady();
    m_snapshot.agvs[1].battery->charge_Ah = 0.3;
    show();
    find<QAction>("checkShiftAction")->trigger();
    pass(3.1);
    click("calibrateButton");
    for (int robot = 1; robot <= 4; ++robot) {
        playTurn(robot);
        pass(0.1);
    }
    QVERIFY2(text("shiftVerdictLabel").contains(QStringLiteral("but 1 of the checks failed")),
             qPrintable(text("shiftVerdictLabel")));
}

void ShiftPanelTest::stopAllEndsTheSequence()
{
    makeReady();
    QSignalSpy turns(m_window.get(), &MainWindow::startTurnRequested);
    QSignalSpy aborts(m_window.get(), &MainWindow::abortTurnRequested);
    find<QAction>("checkShiftAction")->trigger();
    click("calibrateButton");
    m_snapshot.agvs[0].turn.phase = TurnPhase::Reading;
    pass(0.1);
    find<QAction>("stopAllAction")->trigger();
    QCOMPARE(aborts.size(), 1);
    m_snapshot.agvs[0].turn.phase = TurnPhase::Aborted;
    for (int i = 0; i < 10; ++i)
        pass(1.0);
    QCOMPARE(turns.size(), 1);
    QVERIFY(text("shiftVerdictLabel").contains(QStringLiteral("Not ready")));
    QVERIFY(text("turnsLabel").contains(QStringLiteral("stopped")));
    QVERIFY(find<QPushButton>("calibrateButton")->isEnabled());
}

void ShiftPanelTest::nothingIsCalibratedWhileNoAgvCan()
{
    makeReady();
    for (AgvSnapshot& agv : m_snapshot.agvs)
        agv.robotLink.state = LinkState::Waiting;
    show();
    QVERIFY(!find<QPushButton>("calibrateButton")->isEnabled());
    m_snapshot.agvs[2].robotLink.state = LinkState::Up;
    show();
    QVERIFY(find<QPushButton>("calibrateButton")->isEnabled());
    QVERIFY(find<QPushButton>("calibrateButton")->text().contains(QStringLiteral("AGV 3")));
}

QTEST_MAIN(ShiftPanelTest)
#include "test_shift_panel.moc"
