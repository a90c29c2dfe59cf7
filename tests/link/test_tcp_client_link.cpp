// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include "link/socket_options.h"
#include "link/tcp_client_link.h"
#include "link/vanishing_peer.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace agv::link {
namespace {

int option(const QTcpSocket& socket, int level, int name)
{
    int value = -1;
    socklen_t size = sizeof value;
    ::getsockopt(static_cast<int>(socket.socketDescriptor()), level, name, &value, &size);
    return value;
}

} // namespace

class TcpClientLinkTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_server = std::make_unique<QTcpServer>();
        QVERIFY(m_server->listen(QHostAddress::LocalHost));
        m_link = std::make_unique<TcpClientLink>();
        m_received.clear();
        connect(m_link.get(), &TcpClientLink::received, this,
                [this](const Chunk& chunk) { m_received.push_back(chunk); });
    }
    void cleanup()
    {
        m_link.reset();
        m_server.reset();
    }

    void deliversBytesWithTheTimeOfTheirArrival()
    {
        const Time before = std::chrono::steady_clock::now();
        QTcpSocket* peer = connectLink();
        peer->write("SCAN:");
        peer->flush();
        QTRY_COMPARE(allBytes(), QByteArray("SCAN:"));
        QVERIFY(m_received.front().time >= before);
        QVERIFY(m_received.front().time <= std::chrono::steady_clock::now());
    }
    void reportsOneFailureWhenThePeerClosesAndDeliversTheLastBytesFirst()
    {
        QTcpSocket* peer = connectLink();
        QSignalSpy failed(m_link.get(), &TcpClientLink::failed);
        peer->write("last words");
        peer->disconnectFromHost();
        QTRY_COMPARE(failed.size(), 1);
        QCOMPARE(allBytes(), QByteArray("last words"));
        QVERIFY(failed[0][0].toBool());
        QVERIFY(failed[0][1].toString().contains("closed the connection"));
        QVERIFY(!m_link->isConnected());
        QVERIFY(!failed.wait(50));
    }
    void reportsOneFailureWhenThePeerResets()
    {
        QTcpSocket* peer = connectLink();
        QSignalSpy failed(m_link.get(), &TcpClientLink::failed);
        const linger hard{1, 0};
        ::setsockopt(int(peer->socketDescriptor()), SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
        peer->abort();
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toBool());
    }
    void reportsARefusedPortAsTransient()
    {
        const quint16 port = m_server->serverPort();
        m_server->close();
        QSignalSpy failed(m_link.get(), &TcpClientLink::failed);
        m_link->open({"127.0.0.1", port});
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toBool());
        QVERIFY(failed[0][1].toString().contains("refuses the connection"));
    }
    void reportsAnUnknownHostAsPersistent()
    {
        QSignalSpy failed(m_link.get(), &TcpClientLink::failed);
        m_link->open({"no such host.invalid", 8883});
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, 30000);
        QVERIFY(!failed[0][0].toBool());
        QVERIFY(failed[0][1].toString().contains("no such host.invalid"));
    }
    void canBeOpenedAgainFromInsideItsOwnFailure()
    {
        QTcpSocket* peer = connectLink();
        QSignalSpy connected(m_link.get(), &TcpClientLink::connected);
        connect(m_link.get(), &TcpClientLink::failed, this,
                [this] { m_link->open({"127.0.0.1", m_server->serverPort()}); });
        peer->abort();
        QTRY_COMPARE(connected.size(), 1);
        QVERIFY(m_link->isConnected());
    }
    void closingIsSilent()
    {
        QTcpSocket* peer = connectLink();
        QSignalSpy failed(m_link.get(), &TcpClientLink::failed);
        QSignalSpy gone(peer, &QTcpSocket::disconnected);
        m_link->close();
        QTRY_COMPARE(gone.size(), 1);
        QCOMPARE(failed.size(), 0);
        m_link->close();
    }
    void closingWhileTheLastBytesAreTakenIsSilentToo()
    {
        QTcpSocket* peer = connectLink();
        QSignalSpy failed(m_link.get(), &TcpClientLink::failed);
        QSignalSpy connected(m_link.get(), &TcpClientLink::connected);
        bool reopens = false;
        connect(m_link.get(), &TcpClientLink::received, this, [&](const Chunk& chunk) {
            m_link->close();
            if (reopens && chunk.bytes == "last words")
                m_link->open({"127.0.0.1", m_server->serverPort()});
        });
        peer->write("last words");
        peer->disconnectFromHost();
        QTRY_VERIFY(!m_link->isConnected());
        peer = connectLink();
        reopens = true;
        peer->write("last words");
        peer->disconnectFromHost();
        QTRY_COMPARE(connected.size(), 2);
        QVERIFY(m_link->isConnected());
        QCOMPARE(failed.size(), 0);
    }
    void noticesAPeerThatVanishes_data()
    {
        QTest::addColumn<bool>("writes");
        QTest::newRow("while nothing is sent") << false;
        QTest::newRow("while writing") << true;
    }
    void noticesAPeerThatVanishes()
    {
        QFETCH(bool, writes);
        const QTcpSocket* peer = connectLink();
        QSignalSpy failed(m_link.get(), &TcpClientLink::failed);
        QTimer writer;
        connect(&writer, &QTimer::timeout, this, [this] { m_link->write("hello"); });
        QVERIFY(vanish(*peer));
        if (writes)
            writer.start(200);
        QVERIFY(noticedWithinFiveSeconds([&] { return failed.size() > 0; }));
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toBool());
        QVERIFY2(failed[0][1].toString().contains("no longer answers"), qPrintable(failed[0][1].toString()));
    }
    void asksTheSystemToNoticeALostPeer()
    {
        connectLink();
        const auto* socket = m_link->findChild<QTcpSocket*>();
        QCOMPARE(option(*socket, SOL_SOCKET, SO_KEEPALIVE), 1);
        QCOMPARE(option(*socket, IPPROTO_TCP, TCP_KEEPIDLE), keepAliveIdle_s);
        QCOMPARE(option(*socket, IPPROTO_TCP, TCP_KEEPINTVL), keepAliveInterval_s);
        QCOMPARE(option(*socket, IPPROTO_TCP, TCP_KEEPCNT), keepAliveProbes);
        QCOMPARE(option(*socket, IPPROTO_TCP, TCP_USER_TIMEOUT), userTimeout_ms);
    }
    void refusesToPileUpOutput()
    {
        QVERIFY(!m_link->write("x"));
        connectLink();
        const QByteArray block(1024, 'x');
        int taken = 0;
        while (m_link->write(block))
            ++taken;
        QVERIFY(taken * block.size() <= TcpClientLink::maxBacklog);
        QVERIFY(taken > 0);
    }

private:
    QTcpSocket* connectLink()
    {
        QSignalSpy connected(m_link.get(), &TcpClientLink::connected);
        m_link->open({"127.0.0.1", m_server->serverPort()});
        [&] { QTRY_COMPARE(connected.size(), 1); }();
        [&] { QTRY_VERIFY(m_server->hasPendingConnections()); }();
        return m_server->nextPendingConnection();
    }
    QByteArray allBytes() const
    {
        QByteArray all;
        for (const Chunk& chunk : m_received)
            all += chunk.bytes;
        return all;
    }

    std::unique_ptr<QTcpServer> m_server;
    std::unique_ptr<TcpClientLink> m_link;
    std::vector<Chunk> m_received;
};

} // namespace agv::link

QTEST_GUILESS_MAIN(agv::link::TcpClientLinkTest)
#include "test_tcp_client_link.moc"
