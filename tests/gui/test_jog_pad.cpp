// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/jog_fixture.h"

#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QPointingDevice>
#include <QPushButton>
#include <QSlider>

#include <cmath>

using namespace agv;
using namespace agv::gui;

/// What the hand does on the drive pad, and the words that leave the window.
class JogPadTest : public JogFixture {
    Q_OBJECT
private slots:
    void anArrowHeldWithTheMouseDrivesUntilItIsLetGo();
    void everyArrowDrivesItsWheels_data();
    void everyArrowDrivesItsWheels();
    void slidingOffAnArrowEndsTheHoldAndSlidingBackStartsNothing();
    void onlyTheLeftMouseButtonDrives();
    void aFingerHoldsAnArrowAndACancelledTouchLetsItGo();
    void keysDriveWhileThePadHasTheKeyboard_data();
    void keysDriveWhileThePadHasTheKeyboard();
    void twoKeysDriveACurveAndOpposingKeysEndTheHold();
    void keyRepeatsAreNeitherAPressNorARelease();
    void typingElsewhereAndShortcutsNeverDrive();
    void whatTakesTheHandAwayEndsTheHold_data();
    void whatTakesTheHandAwayEndsTheHold();
    void aPadBehindAnotherPageDrivesNothing();
    void afterAMousePressThatWasNeverLetGoTheArrowStillWorks();
    void afterAnEndTheKeyThatIsStillDownDrivesNothingUntilItComesUp();
    void mouseAndKeysDoNotDriveTogether();
};

void JogPadTest::anArrowHeldWithTheMouseDrivesUntilItIsLetGo()
{
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QCOMPARE(m_pressed->count(), 1);
    QCOMPARE((*m_pressed)[0][0].toInt(), 1);
    QCOMPARE(lastPress().source, JogSource::Pad);
    QCOMPARE(lastPress().speeds, (WheelSpeeds{0.1, 0.1})); // 100 mm/s unless told otherwise
    QCOMPARE(m_released->count(), 0);
    QTest::mouseRelease(arrow("jogAhead"), Qt::LeftButton);
    QCOMPARE(m_released->count(), 1);
    QCOMPARE((*m_released)[0][0].toInt(), 1);
    QCOMPARE((*m_released)[0][1].value<JogCommand>().press, lastPress().press);
    QCOMPARE((*m_released)[0][2].value<JogReason>(), JogReason::Released);
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QVERIFY(lastPress().press > (*m_pressed)[0][1].value<JogCommand>().press);
}

void JogPadTest::everyArrowDrivesItsWheels_data()
{
    QTest::addColumn<double>("left");
    QTest::addColumn<double>("right");
    QTest::newRow("jogAhead") << 0.1 << 0.1;
    QTest::newRow("jogBack") << -0.1 << -0.1;
    QTest::newRow("jogLeft") << -0.1 << 0.1;
    QTest::newRow("jogRight") << 0.1 << -0.1;
    QTest::newRow("jogAheadLeft") << 0.04 << 0.1;
    QTest::newRow("jogAheadRight") << 0.1 << 0.04;
    QTest::newRow("jogBackLeft") << -0.04 << -0.1;
    QTest::newRow("jogBackRight") << -0.1 << -0.04;
}

void JogPadTest::everyArrowDrivesItsWheels()
{
    QFETCH(double, left);
    QFETCH(double, right);
    QTest::mousePress(arrow(QTest::currentDataTag()), Qt::LeftButton);
    QVERIFY(std::abs(lastPress().speeds.left - left) < 1e-9);
    QVERIFY(std::abs(lastPress().speeds.right - right) < 1e-9);
}

void JogPadTest::slidingOffAnArrowEndsTheHoldAndSlidingBackStartsNothing()
{
    QWidget* ahead = arrow("jogAhead");
    QTest::mousePress(ahead, Qt::LeftButton);
    QTest::mouseMove(ahead, QPoint(-20, 5));
    QMouseEvent off(QEvent::MouseMove, QPointF(-20, 5), ahead->mapToGlobal(QPointF(-20, 5)), Qt::NoButton,
                    Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(ahead, &off);
    QCOMPARE(m_released->count(), 1);
    QMouseEvent back(QEvent::MouseMove, QPointF(5, 5), ahead->mapToGlobal(QPointF(5, 5)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(ahead, &back);
    QTest::mouseRelease(ahead, Qt::LeftButton);
    QCOMPARE(m_pressed->count(), 1);
    QCOMPARE(m_released->count(), 1);
}

void JogPadTest::onlyTheLeftMouseButtonDrives()
{
    QTest::mousePress(arrow("jogAhead"), Qt::RightButton);
    QTest::mouseRelease(arrow("jogAhead"), Qt::RightButton);
    QCOMPARE(m_pressed->count(), 0);
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QTest::mouseRelease(arrow("jogAhead"), Qt::RightButton);
    QCOMPARE(m_released->count(), 0);
}

void JogPadTest::aFingerHoldsAnArrowAndACancelledTouchLetsItGo()
{
    const std::unique_ptr<QPointingDevice> finger(QTest::createTouchDevice());
    const QWidget* left = arrow("jogLeft");
    const QPoint onIt = left->mapTo(m_window.get(), left->rect().center());
    const auto touch = [&] { return QTest::touchEvent(m_window->windowHandle(), finger.get()); };
    touch().press(0, onIt);
    QCOMPARE(m_pressed->count(), 1);
    QCOMPARE(lastPress().speeds, (WheelSpeeds{-0.1, 0.1}));
    touch().release(0, onIt);
    QCOMPARE(m_released->count(), 1);
    touch().press(0, onIt);
    touch().move(0, onIt + QPoint(left->width(), 0)); // slides off
    QCOMPARE(m_released->count(), 2);
    touch().release(0, onIt);
    touch().press(0, onIt);
    QCOMPARE(m_pressed->count(), 3);
    QTouchEvent cancelled(QEvent::TouchCancel, finger.get());
    QCoreApplication::sendEvent(arrow("jogLeft"), &cancelled);
    QCOMPARE(m_released->count(), 3);
    touch().release(0, onIt);
}

void JogPadTest::keysDriveWhileThePadHasTheKeyboard_data()
{
    QTest::addColumn<int>("key");
    QTest::addColumn<double>("left");
    QTest::addColumn<double>("right");
    QTest::newRow("W") << int(Qt::Key_W) << 0.1 << 0.1;
    QTest::newRow("A") << int(Qt::Key_A) << -0.1 << 0.1;
    QTest::newRow("S") << int(Qt::Key_S) << -0.1 << -0.1;
    QTest::newRow("D") << int(Qt::Key_D) << 0.1 << -0.1;
    QTest::newRow("up") << int(Qt::Key_Up) << 0.1 << 0.1;
    QTest::newRow("left") << int(Qt::Key_Left) << -0.1 << 0.1;
    QTest::newRow("down") << int(Qt::Key_Down) << -0.1 << -0.1;
    QTest::newRow("right") << int(Qt::Key_Right) << 0.1 << -0.1;
}

void JogPadTest::keysDriveWhileThePadHasTheKeyboard()
{
    QFETCH(int, key);
    QFETCH(double, left);
    QFETCH(double, right);
    focusPad();
    QTest::keyPress(pad(), Qt::Key(key));
    QCOMPARE(m_pressed->count(), 1);
    QCOMPARE(lastPress().source, JogSource::Keys);
    QCOMPARE(lastPress().speeds, (WheelSpeeds{left, right}));
    QTest::keyRelease(pad(), Qt::Key(key));
    QCOMPARE(m_released->count(), 1);
    QCOMPARE((*m_released)[0][2].value<JogReason>(), JogReason::Released);
}

void JogPadTest::twoKeysDriveACurveAndOpposingKeysEndTheHold()
{
    focusPad();
    QTest::keyPress(pad(), Qt::Key_W);
    QTest::keyPress(pad(), Qt::Key_A);
    QCOMPARE(m_pressed->count(), 1);
    QTRY_VERIFY(!m_held->isEmpty());
    QTRY_VERIFY(std::abs(m_held->last()[1].value<JogCommand>().speeds.left - 0.04) < 1e-9);
    QTest::keyRelease(pad(), Qt::Key_A);
    QCOMPARE(m_released->count(), 0);
    QTest::keyPress(pad(), Qt::Key_S);
    QCOMPARE(m_released->count(), 1);
    QCOMPARE((*m_released)[0][2].value<JogReason>(), JogReason::OpposingKeys);
    QTest::keyRelease(pad(), Qt::Key_S); // W is still down
    QCOMPARE(m_pressed->count(), 1);
    QTest::keyRelease(pad(), Qt::Key_W);
    QTest::keyPress(pad(), Qt::Key_W);
    QCOMPARE(m_pressed->count(), 2);
}

void JogPadTest::keyRepeatsAreNeitherAPressNorARelease()
{
    focusPad();
    const auto repeat = [this](QEvent::Type type) {
        QKeyEvent event(type, Qt::Key_W, Qt::NoModifier, QStringLiteral("w"), true);
        QCoreApplication::sendEvent(pad(), &event);
    };
    repeat(QEvent::KeyPress); // a key that went down in another window
    QCOMPARE(m_pressed->count(), 0);
    QTest::keyPress(pad(), Qt::Key_W);
    for (int i = 0; i < 20; ++i) {
        repeat(QEvent::KeyRelease);
        repeat(QEvent::KeyPress);
    }
    QCOMPARE(m_pressed->count(), 1);
    QCOMPARE(m_released->count(), 0);
    QTest::keyRelease(pad(), Qt::Key_W);
    QCOMPARE(m_released->count(), 1);
}

void JogPadTest::typingElsewhereAndShortcutsNeverDrive()
{
    for (QWidget* elsewhere : {static_cast<QWidget*>(find<QPushButton>("jogStopButton")),
                               static_cast<QWidget*>(find<QSlider>("jogSpeedSlider")),
                               static_cast<QWidget*>(find<QPushButton>("dockButton"))}) {
        elsewhere->setFocus();
        for (const Qt::Key key : {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Up})
            QTest::keyClick(elsewhere, key);
    }
    focusPad();
    QTest::keyClick(pad(), Qt::Key_S, Qt::ControlModifier);
    QTest::keyClick(pad(), Qt::Key_A, Qt::AltModifier);
    QCOMPARE(m_pressed->count(), 0);
}

void JogPadTest::whatTakesTheHandAwayEndsTheHold_data()
{
    QTest::addColumn<bool>("keys");
    QTest::addColumn<QString>("what");
    QTest::addColumn<JogReason>("why");
    const std::pair<const char*, JogReason> ways[] = {
        {"focus", JogReason::FocusLost},          {"deactivated", JogReason::FocusLost},
        {"minimised", JogReason::WindowHidden},   {"hidden", JogReason::FocusLost},
        {"dialog", JogReason::DialogOpened},      {"other page", JogReason::WindowHidden},
        {"dock closed", JogReason::WindowHidden}, {"suspended", JogReason::Suspended}};
    for (const auto& [what, why] : ways) {
        QTest::addRow("keys, %s", what) << true << what << why;
        QTest::addRow("mouse, %s", what) << false << what << why;
    }
}

void JogPadTest::whatTakesTheHandAwayEndsTheHold()
{
    QFETCH(bool, keys);
    QFETCH(QString, what);
    QFETCH(JogReason, why);
    focusPad();
    if (keys)
        QTest::keyPress(pad(), Qt::Key_W);
    else
        QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QCOMPARE(m_pressed->count(), 1);
    QDialog dialog(m_window.get());
    if (what == QLatin1String("focus"))
        find<QSlider>("jogSpeedSlider")->setFocus();
    else if (what == QLatin1String("minimised"))
        m_window->showMinimized();
    else if (what == QLatin1String("hidden"))
        m_window->hide();
    else if (what == QLatin1String("other page"))
        find<QDockWidget>("calibrationDock")->raise();
    else if (what == QLatin1String("dock closed"))
        find<QDockWidget>("jogDock")->hide();
    else if (what == QLatin1String("suspended"))
        emit qGuiApp->applicationStateChanged(Qt::ApplicationSuspended);
    else if (what == QLatin1String("deactivated")) {
        QEvent deactivated(QEvent::WindowDeactivate);
        QCoreApplication::sendEvent(m_window.get(), &deactivated);
    } else {
        dialog.setModal(true);
        dialog.show();
    }
    QTRY_COMPARE(m_released->count(), 1);
    QCOMPARE((*m_released)[0][2].value<JogReason>(), why);
    // Nothing is said of it any more.
    const auto said = m_held->count();
    QTest::qWait(120);
    QCOMPARE(m_held->count(), said);
    QCOMPARE(m_released->count(), 1);
}

void JogPadTest::aPadBehindAnotherPageDrivesNothing()
{
    focusPad();
    find<QDockWidget>("calibrationDock")->raise();
    QTRY_VERIFY(pad()->visibleRegion().isEmpty());
    QVERIFY(!pad()->hasFocus());
    pad()->setFocus();
    QTest::keyClick(pad(), Qt::Key_W);
    QCOMPARE(m_pressed->count(), 0);
}

void JogPadTest::afterAMousePressThatWasNeverLetGoTheArrowStillWorks()
{
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    pad()->cancel(JogReason::DialogOpened); // which got the release
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QCOMPARE(m_pressed->count(), 2);
    QTest::mouseRelease(arrow("jogAhead"), Qt::LeftButton);
    QCOMPARE(m_released->count(), 2);
}

void JogPadTest::afterAnEndTheKeyThatIsStillDownDrivesNothingUntilItComesUp()
{
    focusPad();
    QTest::keyPress(pad(), Qt::Key_W);
    pad()->cancel(JogReason::DialogOpened);
    QTest::keyPress(pad(), Qt::Key_A); // W is still down
    QCOMPARE(m_pressed->count(), 1);
    QTest::keyRelease(pad(), Qt::Key_A);
    QTest::keyRelease(pad(), Qt::Key_W);
    QCOMPARE(m_released->count(), 1);
    QTest::keyPress(pad(), Qt::Key_W);
    QCOMPARE(m_pressed->count(), 2);
}

void JogPadTest::mouseAndKeysDoNotDriveTogether()
{
    focusPad();
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QTest::keyPress(pad(), Qt::Key_S);
    QCOMPARE(m_pressed->count(), 1);
    QVERIFY(find<QLabel>("jogSentence")->text().contains(QStringLiteral("do not drive together")));
    QTest::mouseRelease(arrow("jogAhead"), Qt::LeftButton); // the key goes on being no press
    QCOMPARE(m_released->count(), 1);
    QTest::keyRelease(pad(), Qt::Key_S);
    QTest::keyPress(pad(), Qt::Key_S);
    QCOMPARE(m_pressed->count(), 2);
    QTest::mousePress(arrow("jogAhead"), Qt::LeftButton);
    QTest::mouseRelease(arrow("jogAhead"), Qt::LeftButton);
    QCOMPARE(m_pressed->count(), 2);
    QCOMPARE(m_released->count(), 1);
}

QTEST_MAIN(JogPadTest)
#include "test_jog_pad.moc"
