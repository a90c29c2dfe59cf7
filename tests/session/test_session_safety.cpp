// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the wire: whatever is cut in whatever phase of a turn, zero wheel speed is the last word to the
// robot.
#include "link/vanishing_peer.h"
#include "session/scripted_plant.h"

#include <QTest>

namespace agv::session {
namespace {

struct Moment {
    const char* name;
    TurnPhase phase;
    int stop;
};

const Moment moments[] = {
    {"settling at the first stop", TurnPhase::Settling, 1},
    {"reading the first stop", TurnPhase::Reading, 1},
    {"turning to the second stop", TurnPhase::Turning, 2},
    {"settling at the second stop", TurnPhase::Settling, 2},
    {"reading the second stop", TurnPhase::Reading, 2},
};

/// They take a whole turn.
const Moment lateMoments[] = {
    {"turning to the closing stop", TurnPhase::Turning, 9},
    {"solving", TurnPhase::Solving, 9},
};

} // namespace

class SessionSafetyTest : public QObject {
    Q_OBJECT
private:
    static void everyMomentAndKind()
    {
        QTest::addColumn<TurnKind>("kind");
        QTest::addColumn<TurnPhase>("phase");
        QTest::addColumn<int>("stop");
        for (const TurnKind kind : {TurnKind::Timed, TurnKind::Measured}) {
            for (const Moment& moment : moments) {
                const QByteArray name =
                    QByteArray(kind == TurnKind::Timed ? "timed, " : "measured, ") + moment.name;
                QTest::newRow(name.constData()) << kind << moment.phase << moment.stop;
            }
        }
    }
    static void lateMomentsToo()
    {
        everyMomentAndKind();
        for (const Moment& moment : lateMoments)
            QTest::newRow(moment.name) << TurnKind::Timed << moment.phase << moment.stop;
    }
    static bool begin(ScriptedPlant& plant, double maxDwell_s = ScriptedPlant::quickTurn().maxDwell_s)
    {
        QFETCH(TurnKind, kind);
        QFETCH(TurnPhase, phase);
        QFETCH(int, stop);
        if (!plant.bringUp())
            return false;
        TurnParameters parameters = ScriptedPlant::quickTurn(kind);
        parameters.maxDwell_s = maxDwell_s;
        plant.session->startTurn(1, parameters);
        return plant.reach(phase, stop);
    }
    /// While the solver works a lost reader no longer matters.
    static bool readerMatters()
    {
        QFETCH(TurnPhase, phase);
        return phase != TurnPhase::Solving;
    }
    static bool interruptedAfter(const ScriptedPlant& plant, std::size_t index)
    {
        const auto& wire = plant.robot.wire();
        return std::find(wire.begin() + std::ptrdiff_t(index), wire.end(),
                         protocol::RobotCommand(protocol::Interrupt{})) != wire.end();
    }
    /// From the cut on, behind a motion that was still on its way then: zeros and, for a measured turn, an
    /// interrupt. Zero is the last word.
    static void expectStandstill(const ScriptedPlant& plant, std::size_t cut)
    {
        QFETCH(TurnKind, kind);
        const auto from = [&] { return std::max(cut, plant.robot.behindLastMotion()); };
        QTRY_VERIFY_WITH_TIMEOUT(kind == TurnKind::Timed || interruptedAfter(plant, from()), patience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(from()) >= 5, patience_ms);
        QCOMPARE(plant.robot.wire().back(), protocol::RobotCommand(protocol::DirectDrive{}));
    }

private slots:
    void cuttingTheReaderStopsTheRobot_data() { lateMomentsToo(); }
    void cuttingTheReaderStopsTheRobot()
    {
        ScriptedPlant plant(SolveMethod::Auto); // it takes long enough to be caught solving
        QVERIFY(begin(plant));
        const std::size_t cut = plant.robot.wire().size();
        plant.reader.cut();
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, patience_ms);
        if (readerMatters()) {
            QCOMPARE(plant.ended[0].phase, TurnPhase::Failed);
            QVERIFY(plant.ended[0].message.find("RFID reader") != std::string::npos);
            expectStandstill(plant, cut);
        } else {
            QCOMPARE(plant.ended[0].phase, TurnPhase::Finished);
            QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(plant.robot.behindLastMotion()) >= 5,
                                     patience_ms);
        }
    }
    // A WeMos that lost its power keeps its socket open and says nothing more.
    void aSilentReaderStopsTheRobot_data() { lateMomentsToo(); }
    void aSilentReaderStopsTheRobot()
    {
        ScriptedPlant plant(SolveMethod::Auto);
        QVERIFY(begin(plant, 0.1)); // half a turn without reads is over in a second
        plant.reader.setMute(true);
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, patience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(plant.robot.behindLastMotion()) >= 5, patience_ms);
        QCOMPARE(plant.robot.wire().back(), protocol::RobotCommand(protocol::DirectDrive{}));
    }
    void cuttingTheReaderDuringARetakeStopsTheRobot()
    {
        for (const TurnKind kind : {TurnKind::Timed, TurnKind::Measured}) {
            ScriptedPlant plant;
            QVERIFY(plant.bringUp());
            plant.session->startTurn(1, ScriptedPlant::quickTurn(kind));
            QVERIFY(plant.reach(TurnPhase::Finished, 9));
            plant.session->retakeStop(1, 4);
            QVERIFY(plant.reach(TurnPhase::Turning, 5));
            const std::size_t cut = plant.robot.wire().size();
            plant.reader.cut();
            QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{2}, patience_ms);
            QCOMPARE(plant.ended[1].phase, TurnPhase::Failed);
            const auto from = [&] { return std::max(cut, plant.robot.behindLastMotion()); };
            QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(from()) >= 5, patience_ms);
            QCOMPARE(plant.robot.wire().back(), protocol::RobotCommand(protocol::DirectDrive{}));
        }
    }
    void stopAllStopsTheRobot_data() { everyMomentAndKind(); }
    void stopAllStopsTheRobot()
    {
        ScriptedPlant plant(SolveMethod::Auto);
        QVERIFY(begin(plant));
        const std::size_t cut = plant.robot.wire().size();
        plant.session->stopAll("Operator");
        QCOMPARE(plant.ended.size(), std::size_t{1});
        QCOMPARE(plant.ended[0].phase, TurnPhase::Aborted);
        expectStandstill(plant, cut);
    }
    void abortingStopsTheRobot_data() { everyMomentAndKind(); }
    void abortingStopsTheRobot()
    {
        ScriptedPlant plant(SolveMethod::Auto);
        QVERIFY(begin(plant));
        const std::size_t cut = plant.robot.wire().size();
        plant.session->abortTurn(1, "Operator");
        QCOMPARE(plant.ended.size(), std::size_t{1});
        QCOMPARE(plant.ended[0].message, std::string("Operator"));
        expectStandstill(plant, cut);
    }
    void aRobotInErrorIsStopped_data() { everyMomentAndKind(); }
    void aRobotInErrorIsStopped()
    {
        ScriptedPlant plant(SolveMethod::Auto);
        QVERIFY(begin(plant));
        const std::size_t cut = plant.robot.wire().size();
        plant.robot.report(protocol::StateUpdate{RobotState::Error});
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, patience_ms);
        QCOMPARE(plant.ended[0].phase, TurnPhase::Failed);
        expectStandstill(plant, cut);
    }
    void cuttingTheRobotIsSaidLoudlyAndItIsStoppedWhenItComesBack_data() { lateMomentsToo(); }
    void cuttingTheRobotIsSaidLoudlyAndItIsStoppedWhenItComesBack()
    {
        QFETCH(TurnKind, kind);
        QFETCH(TurnPhase, phase);
        QFETCH(int, stop);
        ScriptedPlant plant(SolveMethod::Auto);
        QVERIFY(begin(plant));
        const bool timed = kind == TurnKind::Timed;
        if (timed && phase == TurnPhase::Reading && stop == 2)
            QTRY_VERIFY_WITH_TIMEOUT(plant.logged(EventLevel::Detail, "The robot is idle"), patience_ms);
        plant.robot.cut();
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, patience_ms);
        QCOMPARE(plant.ended[0].phase, TurnPhase::Failed);
        // At the second stop of a timed turn zero has just been sent; the robot has not said that it stands.
        const bool drove =
            phase == TurnPhase::Turning || (timed && phase == TurnPhase::Settling && stop == 2);
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().mayBeMoving, drove, patience_ms);
        QCOMPARE(plant.logged(EventLevel::Error, "MAY STILL BE MOVING"), drove);
        QVERIFY(plant.logged(EventLevel::Error, "The link to the robot was lost"));
        QVERIFY(!plant.logged(EventLevel::Warning, "The link to the robot was lost")); // not twice
        const std::size_t back = plant.robot.wire().size();
        plant.robot.connectTo(plant.port);
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(back) >= 5, patience_ms);
        QCOMPARE(plant.robot.wire()[back], protocol::RobotCommand(protocol::DirectDrive{}));
        QCOMPARE(plant.robot.motionsAfter(back), 0);
        QTRY_VERIFY_WITH_TIMEOUT(!plant.agv().mayBeMoving, patience_ms);
    }
    void endingTheSessionStopsTheRobot_data() { lateMomentsToo(); }
    void endingTheSessionStopsTheRobot()
    {
        ScriptedPlant plant(SolveMethod::Auto);
        QVERIFY(begin(plant));
        const std::size_t cut = plant.robot.wire().size();
        plant.endSession();
        QTRY_VERIFY_WITH_TIMEOUT(!plant.robot.isConnected(), patience_ms);
        expectStandstill(plant, cut);
    }
    void aReaderThatVanishesInATurnIsNoticedAndTheRobotStopped()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QVERIFY(plant.reach(TurnPhase::Turning, 2));
        plant.reader.vanish();
        QVERIFY(link::noticedWithinFiveSeconds([&] { return !plant.ended.empty(); }));
        QCOMPARE(plant.ended[0].phase, TurnPhase::Failed);
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(plant.robot.behindLastMotion()) >= 5, patience_ms);
        QCOMPARE(plant.robot.wire().back(), protocol::RobotCommand(protocol::DirectDrive{}));
    }
    void aRobotThatVanishesInATurnMayStillBeMovingThoughZeroWasSent()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QVERIFY(plant.reach(TurnPhase::Turning, 2));
        plant.robot.vanish();
        plant.session->stopAll("Operator");
        QVERIFY(link::noticedWithinFiveSeconds([&] { return plant.agv().mayBeMoving; }));
        QVERIFY(plant.logged(EventLevel::Error, "MAY STILL BE MOVING"));
        QCOMPARE(plant.agv().robotLink.state, LinkState::Waiting);
        QVERIFY(plant.agv().robotLink.reason.find("no longer answers") != std::string::npos);
    }
    void aRobotThatSaidItStandsIsNotCalledMovingWhenItIsLost()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QVERIFY(plant.reach(TurnPhase::Turning, 2));
        plant.session->stopAll("Operator");
        QTRY_VERIFY_WITH_TIMEOUT(plant.logged(EventLevel::Detail, "The robot is idle"), patience_ms);
        plant.robot.cut();
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().robotLink.state, LinkState::Waiting, patience_ms);
        QVERIFY(!plant.agv().mayBeMoving);
        QVERIFY(plant.logged(EventLevel::Warning, "The link to the robot was lost"));
    }
    void stopAllReachesARobotWithoutATurn()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        const std::size_t before = plant.robot.wire().size();
        plant.session->stopAll("Operator");
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(before) >= 5, patience_ms);
        QCOMPARE(plant.robot.motionsAfter(before), 0);
    }
    void closingTheReaderByHandEndsTheTurn()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QVERIFY(plant.reach(TurnPhase::Turning, 2));
        plant.session->closeReader(1);
        QCOMPARE(plant.ended.size(), std::size_t{1});
        QVERIFY(plant.ended[0].message.find("it was closed") != std::string::npos);
    }
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::SessionSafetyTest)
#include "test_session_safety.moc"
