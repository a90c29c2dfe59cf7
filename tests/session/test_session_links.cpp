// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/vanishing_peer.h"
#include "session/scripted_plant.h"

#include <QElapsedTimer>
#include <QTest>
#include <QUdpSocket>

namespace agv::session {
namespace {

protocol::SensorUpdate battery()
{
    return {{ChargingState::Trickle, 15.5, -0.25, 31, 2.5, 3.0, false, true}};
}

} // namespace

class SessionLinksTest : public QObject {
    Q_OBJECT
private slots:
    void showsWhatTheLinksCarry()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.reader.say("!!noise!!\r\n");
        plant.robot.report(battery());
        plant.robot.report(protocol::StateUpdate{RobotState::SegmentWaiting});
        QTRY_COMPARE(plant.agv().readerLink.dropped, std::uint64_t{1});
        QCOMPARE(plant.agv().readerLink.name, std::string("RFID reader 1"));
        QVERIFY(!plant.agv().readerLink.dropDetail.empty());
        QVERIFY(!plant.agv().recentReads.empty());
        QTRY_VERIFY(plant.agv().readerLink.messagesPerSecond > 20.0);
        QVERIFY(plant.agv().readerLink.dataAge_s.value() < 1.0);
        QTRY_COMPARE(plant.agv().battery, battery().battery);
        QTRY_COMPARE(plant.agv().robotState, RobotState::SegmentWaiting);
        QVERIFY(plant.last.listening.find("(TCP)") != std::string::npos);
    }
    void takesTelemetryFromDatagramsToo()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        QUdpSocket robot;
        QVERIFY(robot.bind(QHostAddress("127.0.0.2")));
        const protocol::Bytes bytes = protocol::encodeReportDatagram(battery()).value();
        const QByteArray datagram(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
        robot.writeDatagram(datagram, QHostAddress::LocalHost, plant.telemetryPort);
        QTRY_COMPARE(plant.agv().battery, battery().battery);
        robot.writeDatagram("\1\1", QHostAddress::LocalHost, plant.telemetryPort);
        QTRY_COMPARE(plant.agv().robotLink.dropped, std::uint64_t{1});
        QUdpSocket stranger;
        QVERIFY(stranger.bind(QHostAddress("127.0.0.9")));
        stranger.writeDatagram(datagram, QHostAddress::LocalHost, plant.telemetryPort);
        robot.writeDatagram(datagram, QHostAddress::LocalHost, plant.telemetryPort);
        QTRY_COMPARE(plant.agv().robotLink.received, std::uint64_t{2});
        QVERIFY(plant.logged(EventLevel::Warning, "127.0.0.9 sent telemetry"));
        QTRY_COMPARE(plant.last.refusedPeers, std::vector<std::string>{"127.0.0.9"});
    }
    void refusesStrangersAndShowsThem()
    {
        ScriptedPlant plant;
        ScriptedRobot stranger("127.0.0.9");
        stranger.connectTo(plant.port);
        QTRY_VERIFY(!plant.last.refusedPeers.empty());
        QCOMPARE(plant.last.refusedPeers[0], std::string("127.0.0.9"));
        QVERIFY(plant.logged(EventLevel::Warning, "127.0.0.9 tried to connect"));
        QCOMPARE(stranger.wire().size(), std::size_t{0});
    }
    void comesBackByItselfWhenTheReaderDoes()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.reader.cut();
        QTRY_COMPARE(plant.agv().readerLink.state, LinkState::Waiting);
        QVERIFY(!plant.agv().readerLink.reason.empty());
        QVERIFY(plant.agv().readerLink.retryIn_s.has_value());
        plant.reader.listen();
        QTRY_COMPARE(plant.agv().readerLink.state, LinkState::Up);
    }
    void noticesAMuteReaderWithinFiveSecondsAndDoesNotCallItUpAgainWithoutData()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.reader.setMute(true);
        QVERIFY(link::noticedWithinFiveSeconds(
            [&] { return plant.agv().readerLink.state == LinkState::Silent; }));
        QTRY_COMPARE_WITH_TIMEOUT(plant.reader.connectionsEver(), 2, 30000);
        QTRY_COMPARE(plant.agv().readerLink.state, LinkState::Silent);
        QVERIFY(plant.agv().readerLink.reason.find("still nothing") != std::string::npos);
        plant.reader.setMute(false);
        QTRY_COMPARE(plant.agv().readerLink.state, LinkState::Up);
    }
    void noticesAReaderThatVanishesAndGivesUpConnectingWhenNothingAnswers()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.reader.vanish();
        QVERIFY(link::noticedWithinFiveSeconds(
            [&] { return plant.agv().readerLink.state == LinkState::Waiting; }));
        QTRY_COMPARE(plant.agv().readerLink.state, LinkState::Opening);
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().readerLink.state, LinkState::Waiting, 30000);
        QVERIFY(plant.agv().readerLink.reason.starts_with("No answer within 3 s"));
    }
    void anUnknownHostWaitsForTheOperator()
    {
        ScriptedPlant plant;
        plant.session->setReaderEndpoint(1, "no such host.invalid", 8883);
        plant.session->openReader(1);
        QTRY_VERIFY_WITH_TIMEOUT(
            !plant.last.agvs.empty() && plant.agv().readerLink.state == LinkState::Failed, 30000);
        QVERIFY(!plant.agv().readerLink.retryIn_s.has_value());
        QVERIFY(plant.logged(EventLevel::Error, "no such host.invalid"));
        plant.session->setReaderEndpoint(1, "127.0.0.1", plant.reader.port());
        QTRY_COMPARE(plant.agv().readerLink.state, LinkState::Up);
    }
    void saysATroubleOnceHoweverOftenItTries()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.reader.cut();
        QTRY_VERIFY_WITH_TIMEOUT(plant.agv().readerLink.retryIn_s.value_or(0.0) > 1.5, 30000);
        const auto refusals = [&] {
            return std::ranges::count_if(plant.events, [](const EventEntry& event) {
                return event.text.find("refuses the connection") != std::string::npos;
            });
        };
        QCOMPARE(refusals(), 1);
        plant.session->openReader(1);
        QTRY_COMPARE(refusals(), 2);
    }
    void noiseIsCountedButIsNoLine()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.reader.setMute(true);
        QTimer noise;
        connect(&noise, &QTimer::timeout, this, [&] { plant.reader.say("%&!\r\n"); });
        noise.start(50);
        QTRY_VERIFY(plant.agv().readerLink.dataAge_s.value() > 2.5);
        QCOMPARE(plant.agv().readerLink.state, LinkState::Up);
        QVERIFY(plant.agv().readerLink.dropped > 10);
        QCOMPARE(plant.agv().readerLink.messagesPerSecond, 0.0);
    }
    void aRobotThatNeverSaysAnythingIsCalledSilent()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().robotLink.state, LinkState::Silent, 30000);
        plant.robot.report(battery());
        QTRY_COMPARE(plant.agv().robotLink.state, LinkState::Up);
    }
    void opensClosesAndMovesTheReaderOnRequest()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        plant.session->openReader(1);
        QCOMPARE(plant.reader.connectionsEver(), 1);
        plant.session->closeReader(1);
        QTRY_COMPARE(plant.reader.clients(), 0);
        QTRY_COMPARE(plant.agv().readerLink.state, LinkState::Down);
        ScriptedReader other;
        plant.session->setReaderEndpoint(1, "127.0.0.1", other.port());
        QTRY_COMPARE(plant.agv().readerLink.address, "127.0.0.1:" + std::to_string(other.port()));
        QCOMPARE(plant.agv().readerLink.state, LinkState::Down);
        plant.session->openReader(1);
        QTRY_COMPARE(other.clients(), 1);
        plant.session->setReaderEndpoint(1, "127.0.0.1", plant.reader.port());
        QTRY_COMPARE(plant.reader.clients(), 1);
        QTRY_COMPARE(other.clients(), 0);
    }
    void aRobotThatConnectsTwiceIsNoted()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        ScriptedRobot again("127.0.0.2");
        again.connectTo(plant.port);
        QTRY_VERIFY(plant.logged(EventLevel::Warning, "connected a second time"));
        QTRY_VERIFY(again.zerosAfter(0) >= 5);
    }
    void saysWhyItCannotListenAndDoesSoAsSoonAsItCan()
    {
        ScriptedPlant first;
        PlantLayout layout = ScriptedPlant::layout(1);
        layout.robotListen.port = first.port;
        layout.telemetryPort = first.telemetryPort;
        Session second(layout, {});
        QString reason;
        PlantSnapshot last;
        int failures = 0;
        QList<quint16> ports;
        connect(&second, &Session::listenFailed, this, [&] { ++failures; });
        connect(&second, &Session::listening, this, [&](quint16 tcp, quint16 udp) { ports << tcp << udp; });
        connect(&second, &Session::listenFailed, this, [&](const QString& text) { reason = text; });
        connect(&second, &Session::snapshotReady, this, [&](const PlantSnapshot& s) { last = s; });
        second.start();
        QVERIFY(reason.contains("is in use"));
        QVERIFY(last.listening.starts_with("Not listening"));
        QCOMPARE(last.agvs[0].robotLink.state, LinkState::Failed);
        QVERIFY(last.agvs[0].robotLink.reason.find("is in use") != std::string::npos);
        first.endSession();
        QTRY_COMPARE(ports, (QList<quint16>{layout.robotListen.port, layout.telemetryPort}));
        QCOMPARE(failures, 1);
        QTRY_COMPARE(last.agvs[0].robotLink.state, LinkState::Waiting);
        QVERIFY(last.listening.find("(TCP)") != std::string::npos);
    }
    void opensTheTelemetryPortLateWithoutDisturbingTheRobots()
    {
        QUdpSocket occupant;
        QVERIFY(occupant.bind(QHostAddress::LocalHost));
        PlantLayout layout = ScriptedPlant::layout(1);
        layout.telemetryPort = occupant.localPort();
        Session session(layout, {});
        int starts = 0;
        QStringList errors;
        PlantSnapshot last;
        connect(&session, &Session::listening, this, [&] { ++starts; });
        connect(&session, &Session::snapshotReady, this, [&](const PlantSnapshot& s) { last = s; });
        connect(&session, &Session::eventLogged, this, [&](const EventEntry& event) {
            if (event.level == EventLevel::Error)
                errors << QString::fromStdString(event.text);
        });
        session.start();
        QCOMPARE(starts, 1);
        QVERIFY(last.listening.ends_with("no telemetry"));
        QCOMPARE(errors.size(), 1);
        QVERIFY(errors[0].startsWith("UDP port "));
        occupant.close();
        QTRY_VERIFY(last.listening.ends_with("(UDP)"));
        QCOMPARE(starts, 1);
        QCOMPARE(errors.size(), 1);
    }
    void sendsThirtySnapshotsASecondAtMost()
    {
        ScriptedPlant plant;
        QVERIFY(plant.bringUp());
        int snapshots = 0;
        connect(plant.session.get(), &Session::snapshotReady, this,
                [&](const PlantSnapshot&) { ++snapshots; });
        QElapsedTimer clock;
        clock.start();
        QTRY_VERIFY(snapshots >= 20);
        QVERIFY(clock.elapsed() >= 20 * 33 - 40);
    }
    void keepsEveryByteOfTheReaderForRecordings()
    {
        ScriptedPlant plant;
        QByteArray all;
        connect(plant.session.get(), &Session::readerBytes, this,
                [&](int robot, const QByteArray& bytes, Time) { all += robot == 1 ? bytes : QByteArray(); });
        QVERIFY(plant.bringUp());
        plant.reader.say("#mark#");
        QTRY_VERIFY(all.contains("#mark#"));
        QVERIFY(all.startsWith("SCAN:+UID="));
    }
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::SessionLinksTest)
#include "test_session_links.moc"
