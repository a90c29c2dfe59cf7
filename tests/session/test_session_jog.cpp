// SPDX-License-Identifier: GPL-3.0-or-later
// Driving by hand, read from the wire of a robot on a real socket.
#include "link/vanishing_peer.h"
#include "session/jog_hand.h"
#include "session/scripted_plant.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace agv::session {

using namespace std::chrono_literals;

namespace {

constexpr WheelSpeeds ahead{0.1, 0.1};

const protocol::RobotCommand zero = protocol::DirectDrive{};

int drives(const ScriptedPlant& plant, std::size_t from, const WheelSpeeds& speeds)
{
    const auto& wire = plant.robot.wire();
    return int(std::count(wire.begin() + std::ptrdiff_t(from), wire.end(),
                          protocol::RobotCommand(protocol::DirectDrive{speeds})));
}

/// The last thing said is a whole burst of zeros, and then nothing for half a second.
void expectFiveZerosAndSilence(const ScriptedPlant& plant)
{
    QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(plant.robot.behindLastMotion()) >= 5, patience_ms);
    QTest::qWait(500);
    const std::size_t first = plant.robot.behindLastMotion();
    QCOMPARE(plant.robot.wire().size() - first, std::size_t{5});
    QCOMPARE(plant.robot.zerosAfter(first), 5);
}

} // namespace

class SessionJogTest : public QObject {
    Q_OBJECT
private slots:
    void aHeldPressDrivesAt20HzWithItsSpeedsAndARelaseSaysZeroFiveTimesAndThenNothing()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        const std::size_t before = plant.robot.wire().size();
        hand.press({0.04, 0.1});
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, {0.04, 0.1}) >= 41, patience_ms);
        QCOMPARE(plant.robot.wire()[before], protocol::RobotCommand(protocol::DirectDrive{{0.04, 0.1}}));
        // The pace of two seconds; single frames may be late on a busy computer, but none comes early.
        std::vector<Duration> gaps;
        for (std::size_t i = before + 1; i < plant.robot.wire().size(); ++i)
            gaps.push_back(plant.robot.times()[i] - plant.robot.times()[i - 1]);
        std::ranges::nth_element(gaps, gaps.begin() + std::ptrdiff_t(gaps.size() / 2));
        const Duration median = gaps[gaps.size() / 2];
        QVERIFY2(median > 48ms && median < 53ms, std::to_string(secondsFrom(median)).c_str());
        QVERIFY(plant.robot.times()[before + 40] - plant.robot.times()[before] >= 1990ms);

        hand.turnTo({-0.1, 0.1});
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, {-0.1, 0.1}) >= 2, patience_ms);
        const std::size_t held = plant.robot.wire().size();
        hand.letGo();
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.wire().size() > held, patience_ms);
        QCOMPARE(plant.robot.wire()[held], zero);
        expectFiveZerosAndSilence(plant);
        QVERIFY(plant.agv().jog.note.empty());
        QVERIFY(plant.logged(EventLevel::Detail, "Driven by hand, with the pad"));
        QVERIFY(plant.logged(EventLevel::Detail, "Driving by hand ended: the operator let go"));
    }
    void aWindowThatSaysNoMoreThatTheHandHoldsStopsTheRobotWithin300Ms()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        // On a busy computer test and session stand still together; only a run without that tells something.
        Time lastBeat;
        Duration longestGap;
        QTimer beat;
        beat.setTimerType(Qt::PreciseTimer);
        QObject::connect(&beat, &QTimer::timeout, this, [&] {
            const Time now = std::chrono::steady_clock::now();
            longestGap = std::max(longestGap, now - lastBeat);
            lastBeat = now;
        });
        beat.start(5ms);
        Duration toZero;
        for (int attempt = 0; attempt < 20; ++attempt) {
            const std::size_t before = plant.robot.wire().size();
            hand.press();
            QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, ahead) >= 3, patience_ms);
            hand.freeze();
            lastBeat = std::chrono::steady_clock::now();
            longestGap = Duration::zero();
            const Time lastWord = hand.lastWord();
            QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(before) >= 1, patience_ms);
            toZero = plant.robot.times()[plant.robot.behindLastMotion()] - lastWord;
            expectFiveZerosAndSilence(plant);
            QVERIFY(toZero >= 250ms);
            if (longestGap < 30ms)
                break;
        }
        QVERIFY2(toZero < 300ms, std::to_string(secondsFrom(toZero)).c_str());
        QCOMPARE(plant.agv().jog.note,
                 std::string("Stopped: no word came from the operator's hand for 250 ms"));
        // What it says when it thaws belongs to a press that is over.
        const std::size_t stopped = plant.robot.wire().size();
        hand.thaw();
        QTest::qWait(300);
        QCOMPARE(plant.robot.wire().size(), stopped);
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().jog.state, JogState::Spent, patience_ms);
        hand.letGo();
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().jog.state, JogState::Ready, patience_ms);
        hand.press();
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, stopped, ahead) >= 1, patience_ms);
    }
    void whatTakesTheHandAwayStopsTheRobot_data()
    {
        QTest::addColumn<JogReason>("why");
        QTest::addColumn<QString>("note");
        QTest::newRow("focus") << JogReason::FocusLost << "Stopped: the keyboard went elsewhere";
        QTest::newRow("dialog") << JogReason::DialogOpened << "Stopped: a dialog opened over the window";
        QTest::newRow("hidden") << JogReason::WindowHidden
                                << "Stopped: the drive pad is no longer to be seen";
    }
    void whatTakesTheHandAwayStopsTheRobot()
    {
        QFETCH(JogReason, why);
        QFETCH(QString, note);
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Keys);
        hand.press();
        hand.letGo(why);
        expectFiveZerosAndSilence(plant);
        QCOMPARE(QString::fromStdString(plant.agv().jog.note), note);
        QVERIFY(plant.logged(EventLevel::Warning, note.mid(9).toUtf8().constData()));
    }
    void aLockedScreenStopsTheRobotThoughTheKeyIsStillHeld()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Keys);
        hand.press();
        plant.session->jogDesk()->endAll(JogReason::ScreenLocked);
        expectFiveZerosAndSilence(plant);
        QCOMPARE(plant.agv().jog.note, std::string("Stopped: the screen was locked"));
    }
    void aCutLinkEndsTheHoldAndTheRobotIsSaidToMoveAndStoppedWhenItComesBack()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        const std::size_t before = plant.robot.wire().size();
        hand.press();
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, ahead) >= 2, patience_ms);
        plant.robot.cut();
        QTRY_VERIFY_WITH_TIMEOUT(plant.agv().mayBeMoving, patience_ms);
        QCOMPARE(plant.agv().jog.note, std::string("Stopped: the link to the robot was lost"));
        QCOMPARE(plant.agv().jog.obstacle, std::string("the robot is not connected"));
        const std::size_t back = plant.robot.wire().size();
        plant.robot.connectTo(plant.port);
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(back) >= 5, patience_ms);
        QTest::qWait(300); // the hand still holds
        QCOMPARE(plant.robot.motionsAfter(back), 0);
    }
    void aRobotThatConfirmsNothingIsToldToStopAfter250MsThoughItsConnectionStands()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        const std::size_t before = plant.robot.wire().size();
        hand.press();
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, ahead) >= 2, patience_ms);
        plant.robot.vanish();
        QTRY_COMPARE_WITH_TIMEOUT(
            plant.agv().jog.note,
            std::string("Stopped: the robot did not confirm a command for 250 ms: check its Wi-Fi"),
            4000); // the connection is given up after five seconds
        QCOMPARE(plant.agv().commanded, WheelSpeeds{});
        hand.letGo();
        hand.press();
        QTRY_COMPARE_WITH_TIMEOUT(
            plant.agv().jog.note,
            std::string("It does not drive: the robot did not confirm a command for 250 ms: check its Wi-Fi"),
            4000);
    }
    void aSecondSourceIsRefusedAndTheFirstGoesOn()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand pad(plant, JogSource::Pad);
        Hand keys(plant, JogSource::Keys);
        const std::size_t before = plant.robot.wire().size();
        pad.press();
        keys.press({-0.1, -0.1});
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, ahead) >= 5, patience_ms);
        QCOMPARE(drives(plant, before, {-0.1, -0.1}), 0);
        QCOMPARE(plant.agv().jog.note, std::string("It does not drive: it is driven from elsewhere: mouse "
                                                   "and keys do not drive together"));
        keys.letGo();
        const int driven = drives(plant, before, ahead);
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, ahead) >= driven + 2, patience_ms);
        pad.letGo();
        expectFiveZerosAndSilence(plant);
    }
    void whileATurnRunsNobodyDrivesByHandAndWhileAHandDrivesNoTurnStarts()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        hand.press();
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QCOMPARE(plant.phase, TurnPhase::Idle);
        QVERIFY(plant.logged(EventLevel::Warning, "it is driven by hand: let go first"));
        hand.letGo();

        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QVERIFY(plant.reach(TurnPhase::Settling, 1));
        const std::size_t before = plant.robot.wire().size();
        hand.press({0.2, 0.2});
        QVERIFY(plant.reach(TurnPhase::Settling, 2));
        QCOMPARE(drives(plant, before, {0.2, 0.2}), 0);
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().jog.note, std::string("It does not drive: a turn is running"),
                                  patience_ms);
    }
    void stopAllStopsTheHandAndLocksItUntilItIsReleasedAndPressedAnew()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        const std::size_t before = plant.robot.wire().size();
        hand.press();
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, ahead) >= 2, patience_ms);
        const std::size_t pressed = plant.robot.wire().size();
        plant.session->stopAll("Operator");
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.wire().size() > pressed, patience_ms);
        QCOMPARE(plant.robot.wire()[pressed], zero);
        expectFiveZerosAndSilence(plant); // though the hand holds on
        QCOMPARE(plant.agv().jog.state, JogState::Latched);
        hand.letGo();
        hand.press();
        QTest::qWait(120);
        plant.session->jogDesk()->releaseStopAll(); // the hand holds: it must let go first
        QTest::qWait(120);
        QCOMPARE(plant.robot.motionsAfter(pressed), 0);
        hand.letGo();
        hand.press();
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.motionsAfter(pressed) > 0, patience_ms);
    }
    void theStopOfOneAgvEndsTheHoldButLocksNothing()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        hand.press();
        plant.session->jogDesk()->stop(1);
        expectFiveZerosAndSilence(plant);
        QCOMPARE(plant.agv().jog.note, std::string("Stopped: Stop was pressed"));
        // It always transmits, even with nobody driving.
        const std::size_t before = plant.robot.wire().size();
        plant.session->jogDesk()->stop(1);
        QTRY_COMPARE_WITH_TIMEOUT(plant.robot.zerosAfter(before), 5, patience_ms);
        hand.letGo();
        hand.press();
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.motionsAfter(before) > 0, patience_ms);
    }
    void noWheelIsFasterThanTheLimits()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        const std::size_t before = plant.robot.wire().size();
        hand.press({0.2, 0.5});
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, {0.1, 0.25}) >= 2, patience_ms);
        hand.turnTo({-9.0, 9.0});
        QTRY_VERIFY_WITH_TIMEOUT(drives(plant, before, {-0.25, 0.25}) >= 1, patience_ms);
        hand.turnTo({std::nan(""), 0.1});
        expectFiveZerosAndSilence(plant);
        QCOMPARE(plant.agv().jog.note, std::string("Stopped: the speed is zero"));
    }
    void aRobotInErrorOrDockedIsNotDriven()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        Hand hand(plant, JogSource::Pad);
        hand.press();
        plant.robot.report(protocol::StateUpdate{RobotState::Error});
        expectFiveZerosAndSilence(plant);
        QCOMPARE(plant.agv().jog.note,
                 std::string("Stopped: the robot is in error: look at the robot, then switch it off and on"));
        plant.robot.report(protocol::StateUpdate{RobotState::StationDocked});
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().jog.obstacle,
                                  std::string("the robot is docked: undock it first"), patience_ms);
        hand.letGo();
        const std::size_t before = plant.robot.wire().size();
        hand.press();
        QTest::qWait(120);
        QCOMPARE(plant.robot.wire().size(), before);
    }
    void dockUndockAndChargeGoOverTheWireAndStopAllInterruptsThem()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        JogDesk* desk = plant.session->jogDesk();
        const std::size_t before = plant.robot.wire().size();
        desk->order(1, DockOrder::Dock);
        QTRY_COMPARE_WITH_TIMEOUT(plant.robot.wire().size(), before + 1, patience_ms);
        QCOMPARE(plant.robot.wire()[before], protocol::RobotCommand(protocol::Dock{}));
        // Until it stands again it takes no other order, and no hand drives it.
        desk->order(1, DockOrder::Undock);
        QTRY_COMPARE_WITH_TIMEOUT(
            plant.agv().jog.note,
            std::string("It does not undock: the robot docks or undocks by itself: wait, or press Stop"),
            patience_ms);
        plant.robot.report(protocol::StateUpdate{RobotState::StationDocking});
        plant.robot.report(protocol::StateUpdate{RobotState::StationDocked});
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().robotState, RobotState::StationDocked, patience_ms);
        desk->order(1, DockOrder::Charge);
        QTRY_COMPARE_WITH_TIMEOUT(
            plant.agv().jog.note,
            std::string("It does not dock to charge: the robot is docked: undock it first"), patience_ms);
        desk->order(1, DockOrder::Undock);
        QTRY_COMPARE_WITH_TIMEOUT(plant.robot.wire().size(), before + 2, patience_ms);
        QCOMPARE(plant.robot.wire()[before + 1], protocol::RobotCommand(protocol::Undock{}));
        plant.robot.report(protocol::StateUpdate{RobotState::StationUndocking});
        plant.robot.report(protocol::StateUpdate{RobotState::Idle});
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().robotState, RobotState::Idle, patience_ms);
        desk->order(1, DockOrder::Charge);
        QTRY_COMPARE_WITH_TIMEOUT(plant.robot.wire().size(), before + 3, patience_ms);
        QCOMPARE(plant.robot.wire()[before + 2], protocol::RobotCommand(protocol::DockDemo{}));
        plant.session->stopAll("Operator");
        QTRY_COMPARE_WITH_TIMEOUT(plant.robot.zerosAfter(before), 5, patience_ms);
        QCOMPARE(plant.robot.wire()[before + 3], protocol::RobotCommand(protocol::Interrupt{}));
        desk->order(1, DockOrder::Dock);
        QTest::qWait(100);
        QCOMPARE(plant.robot.wire().size(), before + 9);
    }
    void aDockingRobotWhoseLinkIsLostMayBeMoving()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.session->jogDesk()->order(1, DockOrder::Dock);
        QTRY_COMPARE_WITH_TIMEOUT(plant.robot.wire().back(), protocol::RobotCommand(protocol::Dock{}),
                                  patience_ms);
        plant.robot.cut();
        QTRY_VERIFY_WITH_TIMEOUT(plant.agv().mayBeMoving, patience_ms);
    }
    void ordersToARobotThatIsNotThereSayWhyAndUnknownAgvsAreIgnored()
    {
        ScriptedPlant plant;
        JogDesk* desk = plant.session->jogDesk();
        desk->order(1, DockOrder::Dock);
        QTRY_VERIFY_WITH_TIMEOUT(plant.last.agvs.size() == 1, patience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().jog.note,
                                  std::string("It does not dock: the robot is not connected"), patience_ms);
        desk->press(9, {});
        desk->hold(9, {});
        desk->release(9, {}, JogReason::Released);
        desk->order(9, DockOrder::Dock);
        desk->stop(9);
    }
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::SessionJogTest)
#include "test_session_jog.moc"
