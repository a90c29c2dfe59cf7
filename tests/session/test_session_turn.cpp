// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scripted_plant.h"

#include <QTest>

namespace agv::session {

class SessionTurnTest : public QObject {
    Q_OBJECT
private slots:
    void turnsThroughAllStopsOverRealSockets_data()
    {
        QTest::addColumn<bool>("timed");
        QTest::newRow("timed") << true;
        QTest::newRow("measured") << false;
    }
    void turnsThroughAllStopsOverRealSockets()
    {
        QFETCH(bool, timed);
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        const std::size_t before = plant.robot.wire().size();
        plant.session->startTurn(1, ScriptedPlant::quickTurn(timed ? TurnKind::Timed : TurnKind::Measured));
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, 20000);
        QCOMPARE(plant.ended[0].phase, TurnPhase::Finished);
        QVERIFY(plant.ended[0].result);
        QVERIFY(plant.ended[0].preview);
        QCOMPARE(plant.record->stops.size(), std::size_t{9});
        for (const TurnStop& stop : plant.record->stops)
            QVERIFY(!stop.reads.empty());
        QCOMPARE(plant.robot.motionsAfter(before), 8);
        QTRY_COMPARE_WITH_TIMEOUT(plant.robot.wire().back(), protocol::RobotCommand(protocol::DirectDrive{}),
                                  patience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().turn.phase, TurnPhase::Finished, patience_ms);
        QCOMPARE(plant.agv().commanded, WheelSpeeds{});
    }
    void segmentNumbersNeverComeTwice()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.robot.report(protocol::SegmentDone{41, 0});
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().robotLink.received, std::uint64_t{1}, patience_ms);
        for (std::size_t turn = 1; turn <= 2; ++turn) {
            plant.session->startTurn(1, ScriptedPlant::quickTurn(TurnKind::Measured));
            QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), turn, 20000);
        }
        std::uint32_t expected = 42;
        for (const protocol::RobotCommand& command : plant.robot.wire()) {
            if (const auto* segments = std::get_if<protocol::AddSegments>(&command)) {
                QCOMPARE(segments->firstNumber, expected);
                expected += 2;
            }
        }
        QCOMPARE(expected, 42U + 32U);
    }
    void readsOneStopAgainAndSolvesAgain()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, 20000);
        const auto before = plant.record;
        plant.session->retakeStop(1, 6);
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{2}, 20000);
        QCOMPARE(plant.ended[1].phase, TurnPhase::Finished);
        QVERIFY(plant.ended[1].result);
        QVERIFY(plant.record->stops[6].reads != before->stops[6].reads);
        QVERIFY(plant.record->stops[5].reads == before->stops[5].reads);
    }
    void aTurnIsRefusedWithAReason()
    {
        ScriptedPlant plant;
        QString refusal;
        connect(plant.session.get(), &Session::turnRefused, this,
                [&](int robot, const QString& reason) { refusal = QString::number(robot) + ": " + reason; });
        plant.session->startTurn(1, {});
        QVERIFY(plant.logged(EventLevel::Warning, "the robot is not connected"));
        QCOMPARE(refusal, "1: the robot is not connected");
        plant.robot.connectTo(plant.port);
        QTRY_VERIFY_WITH_TIMEOUT(plant.robot.zerosAfter(0) > 0, patience_ms);
        plant.session->startTurn(1, {});
        QVERIFY(plant.logged(EventLevel::Warning, "the RFID reader is not connected"));
        QVERIFY(plant.bringUp());
        TurnParameters bad;
        bad.turnTime_s = 99.0;
        plant.session->startTurn(1, bad);
        QVERIFY(plant.logged(EventLevel::Warning, "Sleeptime is 99000 ms"));
        plant.session->retakeStop(1, 2);
        QVERIFY(plant.logged(EventLevel::Warning, "there is no finished turn"));
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QVERIFY(plant.logged(EventLevel::Warning, "a turn is running"));
        plant.session->startTurn(7, {});
        QVERIFY(plant.logged(EventLevel::Warning, "There is no AGV 7"));
        QVERIFY(plant.ended.empty());
    }
    void aDockedRobotIsNotTurned()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.robot.report(protocol::StateUpdate{RobotState::StationDocked});
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().robotState, RobotState::StationDocked, patience_ms);
        const std::size_t before = plant.robot.wire().size();
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QVERIFY(plant.logged(EventLevel::Warning, "undock it first"));
        QCOMPARE(plant.robot.motionsAfter(before), 0);
    }
    void theSleeptimeIsCheckedKeptAndShown()
    {
        ScriptedPlant plant;
        plant.session->setTurnTime(1, 1.2);
        QTRY_VERIFY_WITH_TIMEOUT(!plant.last.agvs.empty() && plant.agv().turnTime_s == 1.2, patience_ms);
        plant.session->setTurnTime(1, -1.0);
        QVERIFY(plant.logged(EventLevel::Warning, "The sleeptime was not changed"));
    }
    void theWheelSpeedIsCheckedKeptAndShown()
    {
        ScriptedPlant plant;
        plant.session->setTurnSpeed(1, 0.05);
        QTRY_VERIFY_WITH_TIMEOUT(!plant.last.agvs.empty() && plant.agv().turnSpeed_m_s == 0.05, patience_ms);
        plant.session->setTurnSpeed(1, 0.3);
        QVERIFY(plant.logged(EventLevel::Warning, "The wheel speed was not changed"));
        QCOMPARE(plant.agv().turnSpeed_m_s, 0.05);
    }
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::SessionTurnTest)
#include "test_session_turn.moc"
