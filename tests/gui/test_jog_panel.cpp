// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/jog_fixture.h"
#include "model/words.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSlider>

using namespace agv;
using namespace agv::gui;

/// Around the drive pad: speed, docks, the release after Stop all, what the sentence says.
class JogPanelTest : public JogFixture {
    Q_OBJECT
private slots:
    void choosingAnotherAgvEndsTheHoldOfTheFirst();
    void theHoldIsSaidEvery50Ms();
    void speedAndFineModeAreHeededWhileHeld();
    void theSpeedStaysBelowTheLimitOfTheAgv();
    void theStopOfThisAgvAndTheDocksAskTheSession();
    void stopAllShowsItsReleaseAndOnlyThen();
    void theSentenceSaysWhatDrivesOrWhyNothingDoes();
    void theChoiceOfTheAgvIsTheSameOnBothPages();
    void ctrlJGivesThePadTheKeyboard();
    void tabVisitsTheFieldsInReadingOrder();
    void noAltKeyMovesARobotFromBehindAnotherPage();

private:
    static PlantSnapshot scene(const JogSnapshot& jog)
    {
        PlantSnapshot snapshot = scenes::linksUp();
        snapshot.agvs.front().jog = jog;
        return snapshot;
    }
};

void JogPanelTest::choosingAnotherAgvEndsTheHoldOfTheFirst()
{
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    find<QAction>("chooseAgv3Action")->trigger();
    QCOMPARE(m_released->count(), 1);
    QCOMPARE((*m_released)[0][0].toInt(), 1);
    QCOMPARE((*m_released)[0][2].value<JogReason>(), JogReason::OtherChosen);
    QTest::mouseRelease(arrow("jogAhead"), Qt::LeftButton);
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QCOMPARE(m_pressed->last()[0].toInt(), 3);
}

void JogPanelTest::theHoldIsSaidEvery50Ms()
{
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QTRY_VERIFY(m_held->count() >= 3);
    const auto command = m_held->last()[1].value<JogCommand>();
    QCOMPARE(command.press, lastPress().press);
    QVERIFY(command.input > lastPress().input);
}

void JogPanelTest::speedAndFineModeAreHeededWhileHeld()
{
    const auto heldSpeed = [this] { return m_held->last()[1].value<JogCommand>().speeds.right; };
    find<QSlider>("jogSpeedSlider")->setValue(250);
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QCOMPARE(lastPress().speeds, (WheelSpeeds{0.25, 0.25}));
    find<QCheckBox>("fineCheck")->setChecked(true);
    QTRY_VERIFY(!m_held->isEmpty());
    QTRY_COMPARE(heldSpeed(), 0.05);
    QCOMPARE(find<QLabel>("speedValueLabel")->text(), model::Words::millimetresPerSecond(0.05));
    find<QSlider>("jogSpeedSlider")->setValue(10); // never slower than the wheels can turn
    QTRY_COMPARE(heldSpeed(), 0.01);
}

void JogPanelTest::theSpeedStaysBelowTheLimitOfTheAgv()
{
    QCOMPARE(find<QSlider>("jogSpeedSlider")->maximum(), 250);
    PlantLayout plant = scenes::wholePlant();
    plant.agvs[1].maxSpeed_m_s = 0.18;
    MainWindow window(plant);
    window.findChild<QComboBox*>(QStringLiteral("jogRobotCombo"))->setCurrentIndex(1);
    QCOMPARE(window.findChild<QSlider*>(QStringLiteral("jogSpeedSlider"))->maximum(), 180);
}

void JogPanelTest::theStopOfThisAgvAndTheDocksAskTheSession()
{
    QSignalSpy stops(m_window.get(), &MainWindow::stopRequested);
    QSignalSpy orders(m_window.get(), &MainWindow::dockRequested);
    click("jogStopButton");
    focusPad();
    QTest::keyClick(pad(), Qt::Key_Space);
    QCOMPARE(stops.count(), 2);
    QCOMPARE(stops[0][0].toInt(), 1);
    for (const char* name : {"dockButton", "undockButton", "chargeButton"})
        click(name);
    QCOMPARE(orders.count(), 3);
    QCOMPARE(orders[0][1].value<DockOrder>(), DockOrder::Dock);
    QCOMPARE(orders[1][1].value<DockOrder>(), DockOrder::Undock);
    QCOMPARE(orders[2][1].value<DockOrder>(), DockOrder::Charge);
    QCOMPARE(m_pressed->count(), 0);
}

void JogPanelTest::stopAllShowsItsReleaseAndOnlyThen()
{
    QSignalSpy released(m_window.get(), &MainWindow::stopAllReleased);
    QVERIFY(!find<QPushButton>("releaseButton")->isVisible());
    m_window->showSnapshot(
        scene({JogState::Latched, {}, "Stop all was pressed: look that the way is free, then release it"}));
    QVERIFY(find<QPushButton>("releaseButton")->isVisible());
    click("releaseButton");
    QCOMPARE(released.count(), 1);
    m_window->showSnapshot(scene({}));
    QVERIFY(!find<QPushButton>("releaseButton")->isVisible());
}

void JogPanelTest::theSentenceSaysWhatDrivesOrWhyNothingDoes()
{
    const auto shows = [&](const JogSnapshot& jog) {
        m_window->showSnapshot(scene(jog));
        const auto visible = [&](const char* name) {
            const auto* label = find<QLabel>(name);
            return label->isVisible() ? label->text() : QString();
        };
        return visible("jogSentence") + visible("jogNotice");
    };
    QCOMPARE(shows({}), QStringLiteral("Ready. AGV 1 drives as long as you hold an arrow."));
    QVERIFY(shows({JogState::Driving, {}, {}}).startsWith(QStringLiteral("AGV 1 drives: left wheel")));
    QCOMPARE(shows({JogState::Spent, "Stopped: the screen was locked", {}}),
             QStringLiteral("Stopped: the screen was locked. Let go, then press again."));
    QCOMPARE(shows({JogState::Ready, "It does not dock: the robot is not connected", {}}),
             QStringLiteral("It does not dock: the robot is not connected."));
    QCOMPARE(shows({JogState::Ready, {}, "a turn is running"}),
             QStringLiteral("AGV 1 cannot be driven now: a turn is running."));
    QVERIFY(shows({JogState::Latched, {}, {}}).isEmpty()); // the release says it
}

void JogPanelTest::theChoiceOfTheAgvIsTheSameOnBothPages()
{
    find<QComboBox>("jogRobotCombo")->setCurrentIndex(2);
    QCOMPARE(find<QComboBox>("robotCombo")->currentIndex(), 2);
    find<QComboBox>("robotCombo")->setCurrentIndex(1);
    QCOMPARE(find<QComboBox>("jogRobotCombo")->currentIndex(), 1);
}

void JogPanelTest::ctrlJGivesThePadTheKeyboard()
{
    find<QDockWidget>("jogDock")->hide();
    QCOMPARE(find<QAction>("driveAction")->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_J));
    find<QAction>("driveAction")->trigger();
    QVERIFY(pad()->isVisible());
    QVERIFY(pad()->hasFocus());
}

void JogPanelTest::tabVisitsTheFieldsInReadingOrder()
{
    find<QComboBox>("jogRobotCombo")->setFocus();
    for (const char* next : {"fineCheck", "jogSpeedSlider", "jogPad", "jogStopButton", "dockButton",
                             "undockButton", "chargeButton"}) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget()->objectName(), QString::fromLatin1(next));
    }
}

// A dock behind another one counts as visible, so the Alt keys of its buttons would work unseen.
void JogPanelTest::noAltKeyMovesARobotFromBehindAnotherPage()
{
    for (const char* name : {"dockButton", "undockButton", "chargeButton", "releaseButton", "jogStopButton"})
        QVERIFY2(find<QPushButton>(name)->shortcut().isEmpty(), name);
}

QTEST_MAIN(JogPanelTest)
#include "test_jog_panel.moc"
