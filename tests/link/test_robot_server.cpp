// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include "link/robot_server.h"
#include "link/vanishing_peer.h"

#include <map>
#include <sys/socket.h>

namespace agv::link {
namespace {

AgvConfig agvAt(int number, const char* host, std::uint16_t port = 0)
{
    AgvConfig agv;
    agv.id = {number};
    agv.robotHost = host;
    agv.robotPeerPort = port;
    return agv;
}

/// Open connections by robot, as the guard was told.
class NotedGuard : public ConnectionGuard {
public:
    void guard(int robot, int descriptor) override { descriptors[robot] = descriptor; }
    void release(int robot) override { descriptors.erase(robot); }

    std::map<int, int> descriptors;
};

} // namespace

class RobotServerTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        // A port that the system chose: a fixed one may be in use, or still be kept from the last run.
        m_robotWithPort = boundTo("127.0.0.4");
        m_server =
            std::make_unique<RobotServer>(std::vector{agvAt(1, "127.0.0.2"), agvAt(2, "127.0.0.3"),
                                                      agvAt(3, "127.0.0.4", m_robotWithPort->localPort())});
        const Result<void> listening = m_server->listen({"127.0.0.1", 0});
        QVERIFY(listening.has_value());
    }
    void cleanup() { m_server.reset(); }

    void tellsRobotsApartByTheirAddress()
    {
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        QSignalSpy received(m_server.get(), &RobotServer::robotReceived);
        const auto robot = connectFrom("127.0.0.3");
        QTRY_COMPARE(connected.size(), 1);
        QCOMPARE(connected[0][0].toInt(), 2);
        QVERIFY(connected[0][1].toString().startsWith("127.0.0.3:"));
        QVERIFY(m_server->isConnected(2));
        QVERIFY(!m_server->isConnected(1));
        robot->write("hello");
        QTRY_COMPARE(received.size(), 1);
        QCOMPARE(received[0][0].toInt(), 2);
        QCOMPARE(received[0][1].value<Chunk>().bytes, QByteArray("hello"));
    }
    void refusesAndReportsStrangersOnceInAWhile()
    {
        QSignalSpy refused(m_server.get(), &RobotServer::peerRefused);
        for (int i = 0; i < 3; ++i) {
            const auto stranger = connectFrom("127.0.0.9");
            QTRY_COMPARE(stranger->state(), QAbstractSocket::UnconnectedState);
        }
        QCOMPARE(refused.size(), 1);
        QCOMPARE(refused[0][0].toString(), "127.0.0.9");
    }
    void refusesARobotThatComesFromAnotherPortThanThePlantFileSays()
    {
        QSignalSpy refused(m_server.get(), &RobotServer::peerRefused);
        const auto wrong = connectFrom("127.0.0.4");
        QTRY_COMPARE(refused.size(), 1);
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        connectToServer(*m_robotWithPort);
        QTRY_COMPARE(connected.size(), 1);
        QCOMPARE(connected[0][0].toInt(), 3);
    }
    void aSecondConnectionReplacesTheFirst()
    {
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        QSignalSpy lost(m_server.get(), &RobotServer::robotLost);
        const auto first = connectFrom("127.0.0.2");
        QTRY_COMPARE(connected.size(), 1);
        QVERIFY(!connected[0][2].toBool());
        const auto second = connectFrom("127.0.0.2");
        QTRY_COMPARE(connected.size(), 2);
        QVERIFY(connected[1][2].toBool());
        QTRY_COMPARE(first->state(), QAbstractSocket::UnconnectedState);
        QVERIFY(m_server->send(1, "to the second", Urgency::Ordinary));
        QTRY_COMPARE(second->peek(100), QByteArray("to the second"));
        QCOMPARE(lost.size(), 0);
    }
    void reportsALostRobotOnce()
    {
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        QSignalSpy lost(m_server.get(), &RobotServer::robotLost);
        const auto robot = connectFrom("127.0.0.2");
        QTRY_COMPARE(connected.size(), 1);
        robot->abort();
        QTRY_COMPARE(lost.size(), 1);
        QCOMPARE(lost[0][0].toInt(), 1);
        QVERIFY2(lost[0][1].toString().endsWith("closed the connection: it was switched off or restarted"),
                 qPrintable(lost[0][1].toString()));
        QVERIFY(!m_server->isConnected(1));
        QVERIFY(!m_server->send(1, "x", Urgency::Urgent));
    }
    void noticesARobotThatVanishes_data()
    {
        QTest::addColumn<bool>("drives");
        QTest::newRow("while nothing is sent") << false;
        QTest::newRow("while it is driven") << true;
    }
    void noticesARobotThatVanishes()
    {
        QFETCH(bool, drives);
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        QSignalSpy lost(m_server.get(), &RobotServer::robotLost);
        const auto robot = connectFrom("127.0.0.2");
        QTRY_COMPARE(connected.size(), 1);
        QVERIFY(vanish(*robot));
        QTimer driver;
        connect(&driver, &QTimer::timeout, this, [this] { m_server->send(1, "drive", Urgency::Ordinary); });
        if (drives)
            driver.start(100);
        QVERIFY(noticedWithinFiveSeconds([&] { return lost.size() > 0; }));
        QCOMPARE(lost.size(), 1);
        QVERIFY2(lost[0][1].toString().contains("no longer answers"), qPrintable(lost[0][1].toString()));
        QVERIFY(!m_server->isConnected(1));
    }
    void knowsForHowLongARobotHasConfirmedNothing()
    {
        using namespace std::chrono_literals;
        const auto now = [] { return std::chrono::steady_clock::now(); };
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        const auto robot = connectFrom("127.0.0.2");
        QTRY_COMPARE(connected.size(), 1);
        QCOMPARE(m_server->unconfirmedFor(1, now()), Duration::zero());
        QVERIFY(m_server->send(1, "drive", Urgency::Ordinary));
        QTRY_COMPARE(m_server->unconfirmedFor(1, now()), Duration::zero());
        QVERIFY(vanish(*robot));
        const Time first = now();
        QVERIFY(m_server->send(1, "drive", Urgency::Ordinary));
        QVERIFY(m_server->send(1, "drive", Urgency::Ordinary)); // the oldest counts
        QTRY_VERIFY(m_server->unconfirmedFor(1, now()) >= 250ms);
        QVERIFY(m_server->unconfirmedFor(1, now()) <= now() - first);
        QCOMPARE(m_server->unconfirmedFor(2, now()), Duration::zero()); // not connected
    }
    void aStopGetsThroughToARobotThatDidNotReadForAWhile()
    {
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        const auto robot = connectFrom("127.0.0.2");
        QTRY_COMPARE(connected.size(), 1);
        robot->setReadBufferSize(1);
        const QByteArray drive(255, 'd');
        int sent = 0;
        while (sent < 1'000'000 && m_server->send(1, drive, Urgency::Ordinary))
            ++sent;
        QVERIFY2(sent < 1'000'000, "the backlog has no bound");
        QVERIFY(m_server->send(1, "STOP", Urgency::Urgent));
        QByteArray wire;
        robot->setReadBufferSize(0);
        QTRY_VERIFY_WITH_TIMEOUT((wire += robot->readAll()).contains("STOP"), 10000);
        QVERIFY(wire.endsWith("STOP"));
    }
    // So that the watchdog's frames never land inside one of the console's.
    void aSecondWriterAlwaysComesBetweenTwoMessages()
    {
        NotedGuard& noted = m_noted;
        m_server = std::make_unique<RobotServer>(std::vector{agvAt(1, "127.0.0.2")}, &noted);
        QVERIFY(m_server->listen({"127.0.0.1", 0}));
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        const auto robot = connectFrom("127.0.0.2");
        QTRY_COMPARE(connected.size(), 1);
        robot->setReadBufferSize(1);
        const QByteArray drive(253, 'd');
        for (int sent = 0; sent < 1'000'000 && m_server->send(1, drive, Urgency::Ordinary);)
            ++sent;
        QCOMPARE(::send(noted.descriptors.at(1), "GUARD", 5, MSG_NOSIGNAL), 5);
        QByteArray wire;
        robot->setReadBufferSize(0);
        QTRY_VERIFY_WITH_TIMEOUT((wire += robot->readAll()).contains("GUARD"), 10000);
        QVERIFY(wire.indexOf("GUARD") > 0);
        QCOMPARE(wire.indexOf("GUARD") % drive.size(), 0);
    }
    void theGuardKnowsEveryConnectionAsLongAsItLasts()
    {
        NotedGuard& noted = m_noted;
        m_server =
            std::make_unique<RobotServer>(std::vector{agvAt(1, "127.0.0.2"), agvAt(2, "127.0.0.3")}, &noted);
        QVERIFY(m_server->listen({"127.0.0.1", 0}));
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        const auto first = connectFrom("127.0.0.2");
        const auto other = connectFrom("127.0.0.3");
        QTRY_COMPARE(noted.descriptors.size(), std::size_t{2});
        const int before = noted.descriptors.at(1);
        const auto second = connectFrom("127.0.0.2"); // replaces the first
        QTRY_COMPARE(connected.size(), 3);
        QVERIFY(noted.descriptors.at(1) != before);
        QCOMPARE(noted.descriptors.size(), std::size_t{2});
        second->abort();
        QTRY_VERIFY(!noted.descriptors.contains(1));
        m_server.reset();
        QVERIFY(noted.descriptors.empty());
    }
    void whatWasSentBeforeTheEndStillArrives()
    {
        QSignalSpy connected(m_server.get(), &RobotServer::robotConnected);
        const auto robot = connectFrom("127.0.0.2");
        QTRY_COMPARE(connected.size(), 1);
        robot->write(QByteArray(20'000, 'r')); // unread input at the console
        robot->flush();
        m_server->send(1, "ZERO", Urgency::Urgent);
        m_server.reset();
        QTRY_COMPARE(robot->state(), QAbstractSocket::UnconnectedState);
        QCOMPARE(robot->readAll(), QByteArray("ZERO"));
    }
    void knowsWhoseDatagramItIs()
    {
        QCOMPARE(m_server->robotAt(QHostAddress("127.0.0.3")), std::optional(2));
        QCOMPARE(m_server->robotAt(QHostAddress("::ffff:127.0.0.3")), std::optional(2));
        QCOMPARE(m_server->robotAt(QHostAddress("127.0.0.9")), std::nullopt);
        const RobotServer shared({agvAt(1, "10.0.0.1", 1), agvAt(2, "10.0.0.1", 2)});
        QCOMPARE(shared.robotAt(QHostAddress("10.0.0.1")), std::nullopt);
    }
    void saysWhenItsPortIsInUse()
    {
        RobotServer other({});
        const Result<void> result = other.listen({"127.0.0.1", m_server->port()});
        QVERIFY(!result.has_value());
        QCOMPARE(result.error().code, ErrorCode::InUse);
    }
    void saysWhenItsAddressIsNotOne()
    {
        RobotServer other({});
        QCOMPARE(other.listen({"plant-pc", 1}).error().code, ErrorCode::BadInput);
        QCOMPARE(other.listen({"192.0.2.1", 2001}).error().code, ErrorCode::NotFound);
    }

private:
    static std::unique_ptr<QTcpSocket> boundTo(const char* address)
    {
        auto socket = std::make_unique<QTcpSocket>();
        [&] { QVERIFY(socket->bind(QHostAddress(QString(address)))); }();
        return socket;
    }
    void connectToServer(QTcpSocket& socket) const
    {
        socket.connectToHost("127.0.0.1", m_server->port());
        QVERIFY(socket.waitForConnected(5000));
    }
    std::unique_ptr<QTcpSocket> connectFrom(const char* address) const
    {
        auto socket = boundTo(address);
        connectToServer(*socket);
        return socket;
    }

    NotedGuard m_noted;
    std::unique_ptr<RobotServer> m_server;
    std::unique_ptr<QTcpSocket> m_robotWithPort;
};

} // namespace agv::link

QTEST_GUILESS_MAIN(agv::link::RobotServerTest)
#include "test_robot_server.moc"
