// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QSignalSpy>
#include <QTest>

#include "simserver/plant_clients.h"
#include "simserver/plant_server.h"

#include <memory>

using namespace agv;
using namespace agv::simserver;

namespace {

PlantLayout twoRobots()
{
    PlantLayout plant;
    plant.name = "test";
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    plant.floorTags = tagGrid(31, 41, 0.1, {0.0, 0.0}, TagUid{0xE00401503A5B0001});
    for (int i = 1; i <= 2; ++i) {
        AgvConfig agv;
        agv.id = {i};
        agv.robotHost = "127.0.0." + std::to_string(i + 1);
        agv.reader = {agv.robotHost, 8883};
        plant.agvs.push_back(agv);
    }
    return plant;
}

} // namespace

class TestSimserver : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void readyMessageNamesEveryReaderAndRobot();
    void readerLinesReassembleFromPieces();
    void readerTakesTwoClientsAndClosesTheThird();
    void readerPlaceIsFreeAgainAfterAClientLeft();
    void robotConnectsFromItsOwnAddress();
    void robotSendsTelemetryFromItsOwnAddress();
    void robotExecutesWhatTheConsoleSends();
    void robotKeepsItsSpeedWhenTheConsoleGoesAway();
    void robotComesBackAfterACut();
    void robotFollowsTheConsoleToAnotherPort();
    void halfOpenReaderKeepsTheSocketWithoutData();
    void halfOpenReaderAcceptsConnectionsWithoutAnswering();
    void halfOpenRobotKeepsTheSocketWithoutData();
    void restoreEndsAHalfOpenConnection();
    void stalledReaderIsSilentForAWhile();
    void cutReaderRefusesConnectionsWhileAway();
    void stalledRobotObeysLate();
    void bumpIsReportedAsAnEvent();
    void aRobotIsPlacedNeitherOnAnotherOneNorBeyondTheEdge();
    void portInUseIsReported();
    void consoleMustBeANumericAddress();
    void commandsForRobotsThatAreNotThereFail();

private:
    QJsonObject run(const char* line)
    {
        const auto command = simulation::parseTrainerCommand(line);
        if (!command)
            return {{"error", QString::fromStdString(command.error().detail)}};
        const auto answer = m_server->execute(*command);
        return answer ? *answer : QJsonObject{{"error", QString::fromStdString(answer.error().detail)}};
    }
    QJsonObject reader(int number) const
    {
        return m_server->readyMessage()["readers"].toArray()[number - 1].toObject();
    }
    simulation::RobotTruth truth(int number) const
    {
        return m_server->plant().truth(RobotId{number}).value();
    }

    std::unique_ptr<FakeConsole> m_console;
    std::unique_ptr<PlantServer> m_server;
};

void TestSimserver::init()
{
    m_console = std::make_unique<FakeConsole>();
    ServerOptions options;
    options.seed = 7;
    options.console = m_console->endpoint();
    options.telemetryPort = m_console->udp.localPort();
    auto plant = simulation::Plant::create(twoRobots(), simulation::idealSettings(7));
    QVERIFY(plant);
    m_server = std::make_unique<PlantServer>(std::move(*plant), options);
    QVERIFY(m_server->start());
    run("place 1 1500 2000 0");
    run("place 2 500 500 0");
}

void TestSimserver::cleanup()
{
    m_server.reset();
    m_console.reset();
}

void TestSimserver::readyMessageNamesEveryReaderAndRobot()
{
    const QJsonObject ready = m_server->readyMessage();
    QCOMPARE(ready["ready"].toBool(), true);
    QCOMPARE(ready["seed"].toInt(), 7);
    QCOMPARE(ready["readers"].toArray().size(), 2);
    QCOMPARE(reader(2)["host"].toString(), QStringLiteral("127.0.0.3"));
    QVERIFY(reader(2)["port"].toInt() > 0);
    QCOMPARE(ready["robots"].toArray()[0].toObject()["host"].toString(), QStringLiteral("127.0.0.2"));
    const QJsonObject first = ready["truth"].toArray()[0].toObject();
    QCOMPARE(first["x_mm"].toDouble(), 1500.0);
    QCOMPARE(first["y_mm"].toDouble(), 2000.0);
    QCOMPARE(first["heading_deg"].toDouble(), 0.0);
}

void TestSimserver::readerLinesReassembleFromPieces()
{
    ReaderClient client(reader(1));
    QTRY_VERIFY_WITH_TIMEOUT(client.reads() >= 40, 10000);
    // What was in the bridge's serial buffer before we came may begin or end in the middle of a line.
    QVERIFY(client.stream.counts().droppedTotal() <= 2);
    QVERIFY(std::ranges::any_of(client.pieces, [](qsizetype size) { return size < 36; }));
}

void TestSimserver::readerTakesTwoClientsAndClosesTheThird()
{
    ReaderClient first(reader(1));
    ReaderClient second(reader(1));
    QTRY_VERIFY(first.reads() > 0 && second.reads() > 0);
    ReaderClient third(reader(1));
    QSignalSpy closed(&third.socket, &QTcpSocket::disconnected);
    QTRY_COMPARE(closed.size(), 1);
    QCOMPARE(third.reads(), 0U);
    const quint64 before = first.reads();
    QTRY_VERIFY(first.reads() > before + 5);
}

void TestSimserver::readerPlaceIsFreeAgainAfterAClientLeft()
{
    ReaderClient first(reader(1));
    ReaderClient second(reader(1));
    QTRY_VERIFY(first.reads() > 0 && second.reads() > 0);
    QSignalSpy events(m_server.get(), &PlantServer::event);
    first.socket.disconnectFromHost();
    QTRY_VERIFY(!events.isEmpty());
    ReaderClient third(reader(1));
    QTRY_VERIFY(third.reads() > 0);
}

void TestSimserver::robotConnectsFromItsOwnAddress()
{
    QTRY_VERIFY(m_console->robot(1) && m_console->robot(2));
    protocol::ReportStream stream;
    int states = 0;
    const auto count = [&](const protocol::RobotReport& report) {
        states += std::holds_alternative<protocol::StateUpdate>(report) ? 1 : 0;
    };
    QTcpSocket* robot = m_console->robot(1);
    connect(robot, &QTcpSocket::readyRead, robot, [&] {
        const QByteArray bytes = robot->readAll();
        stream.feed(
            {reinterpret_cast<const std::uint8_t*>(bytes.data()), static_cast<std::size_t>(bytes.size())},
            count);
    });
    QTRY_VERIFY(states >= 3);
    QCOMPARE(stream.counts().droppedTotal(), 0U);
}

void TestSimserver::robotSendsTelemetryFromItsOwnAddress()
{
    QTRY_VERIFY(m_console->udp.hasPendingDatagrams());
    QByteArray datagram(1024, '\0');
    QHostAddress from;
    datagram.resize(m_console->udp.readDatagram(datagram.data(), datagram.size(), &from));
    QVERIFY(from == QHostAddress("127.0.0.2") || from == QHostAddress("127.0.0.3"));
    const auto report = protocol::decodeReportDatagram(
        {reinterpret_cast<const std::uint8_t*>(datagram.data()), static_cast<std::size_t>(datagram.size())});
    QVERIFY(report);
    QVERIFY(std::holds_alternative<protocol::SensorUpdate>(*report));
}

void TestSimserver::robotExecutesWhatTheConsoleSends()
{
    QTRY_VERIFY(m_console->robot(1));
    m_console->send(1, protocol::DirectDrive{{0.2, 0.2}});
    QTRY_VERIFY(truth(1).pose.position.x > 1.6);
    m_console->send(1, protocol::DirectDrive{});
    QTRY_COMPARE(truth(1).wheels, WheelSpeeds{});
    QCOMPARE(truth(2).pose.position, (Point2{0.5, 0.5}));
}

void TestSimserver::robotKeepsItsSpeedWhenTheConsoleGoesAway()
{
    QTRY_VERIFY(m_console->robot(1));
    m_console->send(1, protocol::DirectDrive{{0.1, 0.1}});
    QTRY_COMPARE(truth(1).commanded, (WheelSpeeds{0.1, 0.1}));
    QSignalSpy events(m_server.get(), &PlantServer::event);
    m_console.reset();
    QTRY_VERIFY(events.size() >= 2);
    const double before = truth(1).pose.position.x;
    QTRY_VERIFY(truth(1).pose.position.x > before + 0.05);
    QCOMPARE(truth(1).commanded, (WheelSpeeds{0.1, 0.1}));
}

void TestSimserver::robotComesBackAfterACut()
{
    QTRY_VERIFY(m_console->robot(1));
    QTcpSocket* old = m_console->robot(1);
    QCOMPARE(run("cut robot 1")["ok"].toBool(), true);
    QTRY_COMPARE(old->state(), QAbstractSocket::UnconnectedState);
    QTRY_VERIFY(m_console->robot(1));
}

void TestSimserver::robotFollowsTheConsoleToAnotherPort()
{
    QTRY_VERIFY(m_console->robot(1));
    const FakeConsole other;
    const QString line =
        QStringLiteral("console 127.0.0.1 %1 %2").arg(other.endpoint().port).arg(other.udp.localPort());
    QCOMPARE(run(line.toLatin1().constData())["ok"].toBool(), true);
    QTRY_VERIFY(other.robot(1) && other.robot(2));
    QTRY_VERIFY(!m_console->robot(1));
    QTRY_VERIFY(other.udp.hasPendingDatagrams());
}

void TestSimserver::halfOpenReaderKeepsTheSocketWithoutData()
{
    ReaderClient client(reader(1));
    ReaderClient other(reader(2));
    QTRY_VERIFY(client.reads() > 3 && other.reads() > 0);
    run("halfopen reader 1");
    const quint64 before = client.reads();
    const quint64 otherBefore = other.reads();
    QTRY_VERIFY(other.reads() > otherBefore + 20); // about a second
    QVERIFY(client.reads() <= before + 1);
    QCOMPARE(client.socket.state(), QAbstractSocket::ConnectedState);
}

void TestSimserver::halfOpenReaderAcceptsConnectionsWithoutAnswering()
{
    run("halfopen reader 1");
    ReaderClient client(reader(1));
    ReaderClient other(reader(2));
    QTRY_COMPARE(client.socket.state(), QAbstractSocket::ConnectedState);
    QTRY_VERIFY(other.reads() > 20);
    QCOMPARE(client.reads(), 0U);
    QCOMPARE(client.socket.state(), QAbstractSocket::ConnectedState);
    QSignalSpy closed(&client.socket, &QTcpSocket::disconnected);
    run("restore");
    QTRY_COMPARE(closed.size(), 1);
}

void TestSimserver::halfOpenRobotKeepsTheSocketWithoutData()
{
    QTRY_VERIFY(m_console->robot(1) && m_console->robot(2));
    run("halfopen robot 1");
    QTcpSocket* dead = m_console->robot(1);
    QTcpSocket* alive = m_console->robot(2);
    dead->readAll();
    alive->readAll();
    m_console->send(1, protocol::DirectDrive{{0.2, 0.2}});
    QTRY_VERIFY(alive->bytesAvailable() >= 9); // three states: more than a second
    QCOMPARE(dead->bytesAvailable(), 0);
    QCOMPARE(dead->state(), QAbstractSocket::ConnectedState);
    QCOMPARE(truth(1).commanded, WheelSpeeds{});
}

void TestSimserver::restoreEndsAHalfOpenConnection()
{
    QTRY_VERIFY(m_console->robot(1));
    QTcpSocket* old = m_console->robot(1);
    ReaderClient client(reader(1));
    QTRY_VERIFY(client.reads() > 0);
    run("halfopen robot 1");
    run("halfopen reader 1");
    run("restore");
    QTRY_COMPARE(old->state(), QAbstractSocket::UnconnectedState);
    QTRY_COMPARE(client.socket.state(), QAbstractSocket::UnconnectedState);
    QTRY_VERIFY(m_console->robot(1));
    ReaderClient again(reader(1));
    QTRY_VERIFY(again.reads() > 0);
}

void TestSimserver::stalledReaderIsSilentForAWhile()
{
    ReaderClient client(reader(1));
    ReaderClient other(reader(2));
    QTRY_VERIFY(client.reads() > 3 && other.reads() > 0);
    run("stall reader 1 2");
    const quint64 before = client.reads();
    const quint64 otherBefore = other.reads();
    QTRY_VERIFY(other.reads() > otherBefore + 10);
    QVERIFY(client.reads() <= before + 2);
    QTRY_VERIFY(client.reads() > before + 10);
    QCOMPARE(client.socket.state(), QAbstractSocket::ConnectedState);
}

void TestSimserver::cutReaderRefusesConnectionsWhileAway()
{
    ReaderClient client(reader(1));
    QTRY_VERIFY(client.reads() > 0);
    const QJsonObject address = reader(1);
    run("cut reader 1 2");
    QTRY_COMPARE(client.socket.state(), QAbstractSocket::UnconnectedState);
    ReaderClient refused(address);
    QTRY_COMPARE(refused.socket.error(), QAbstractSocket::ConnectionRefusedError);
    QTRY_VERIFY(([&] {
        ReaderClient again(address);
        return QTest::qWaitFor([&] { return again.reads() > 0; }, 300);
    })());
}

void TestSimserver::stalledRobotObeysLate()
{
    QTRY_VERIFY(m_console->robot(1) && m_console->robot(2));
    run("stall robot 1 2");
    m_console->send(1, protocol::DirectDrive{{0.2, 0.2}});
    m_console->send(2, protocol::DirectDrive{{0.2, 0.2}});
    QTRY_COMPARE(truth(2).commanded, (WheelSpeeds{0.2, 0.2}));
    QCOMPARE(truth(1).commanded, WheelSpeeds{});
    QTRY_COMPARE(truth(1).commanded, (WheelSpeeds{0.2, 0.2}));
}

void TestSimserver::bumpIsReportedAsAnEvent()
{
    QTRY_VERIFY(m_console->robot(1));
    run("place 1 2800 2000 0");
    QSignalSpy events(m_server.get(), &PlantServer::event);
    m_console->send(1, protocol::DirectDrive{{0.3, 0.3}});
    QTRY_VERIFY(!events.isEmpty());
    const QJsonObject event = events[0][0].toJsonObject();
    QCOMPARE(event["event"].toString(), QStringLiteral("bump"));
    QCOMPARE(event["robot"].toInt(), 1);
}

void TestSimserver::aRobotIsPlacedNeitherOnAnotherOneNorBeyondTheEdge()
{
    const auto before = truth(1);
    QVERIFY(run("place 1 600 600 0")["error"].toString().contains("robot 1 would stand on AGV 2"));
    for (const char* line : {"place 1 -500 500 0", "place 1 100 2000 0", "place 1 1500 99000 0"})
        QVERIFY2(run(line)["error"].toString().contains("beyond the edge of the plant"), line);
    QCOMPARE(truth(1).pose.position, before.pose.position);
    QVERIFY(run("place 2 500 500 90")["ok"].toBool()); // itself is not in the way
    QVERIFY(run("place 1 1000 500 0")["ok"].toBool());
}

void TestSimserver::portInUseIsReported()
{
    PlantLayout layout = twoRobots();
    layout.agvs[0].reader.port = static_cast<std::uint16_t>(reader(1)["port"].toInt());
    ServerOptions options;
    options.fixedReaderPorts = true;
    PlantServer second(simulation::Plant::create(layout, simulation::idealSettings()).value(), options);
    const auto started = second.start();
    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::InUse);
    QVERIFY(started.error().detail.find("127.0.0.2:") != std::string::npos);
}

void TestSimserver::consoleMustBeANumericAddress()
{
    const QJsonObject answer = run("console nowhere.invalid 1 1");
    QVERIFY(answer["error"].toString().contains("nowhere.invalid"));
    QTRY_VERIFY(m_console->robot(1)); // nothing else happened
}

void TestSimserver::commandsForRobotsThatAreNotThereFail()
{
    for (const char* line : {"cut reader 9", "halfopen robot 9", "battery 9 50", "place 9 0 0 0"})
        QVERIFY(run(line)["error"].toString().contains("no robot 9"));
    QVERIFY(run("deadtag 1")["error"].toString().contains("0000000000000001"));
    QCOMPARE(run("deadtag random 3")["tags"].toArray().size(), 3);
    QVERIFY(run("help")["help"].toArray().size() > 10);
    QCOMPARE(run("truth")["truth"].toArray().size(), 2);
    QSignalSpy quit(m_server.get(), &PlantServer::quitRequested);
    run("quit");
    QCOMPARE(quit.size(), 1);
}

QTEST_GUILESS_MAIN(TestSimserver)
#include "test_simserver.moc"
