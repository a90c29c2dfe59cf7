// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>
#include <QUdpSocket>

#include "link/telemetry_socket.h"

namespace agv::link {

class TelemetrySocketTest : public QObject {
    Q_OBJECT
private slots:
    void deliversDatagramsWithTheirSender()
    {
        TelemetrySocket telemetry;
        const Result<void> listening = telemetry.listen({"127.0.0.1", 0});
        QVERIFY(listening.has_value());
        QSignalSpy received(&telemetry, &TelemetrySocket::received);
        QUdpSocket robot;
        QVERIFY(robot.bind(QHostAddress("127.0.0.5")));
        robot.writeDatagram("\2\5\1", 3, QHostAddress::LocalHost, telemetry.port());
        robot.writeDatagram("", 0, QHostAddress::LocalHost, telemetry.port());
        QTRY_COMPARE(received.size(), 2);
        QCOMPARE(received[0][0].value<QHostAddress>(), QHostAddress("127.0.0.5"));
        QCOMPARE(received[0][1].value<Chunk>().bytes, QByteArray("\2\5\1", 3));
        QVERIFY(received[1][1].value<Chunk>().bytes.isEmpty());
    }
    void saysWhenItsPortIsInUse()
    {
        TelemetrySocket first;
        QVERIFY(first.listen({"127.0.0.1", 0}).has_value());
        TelemetrySocket second;
        const Result<void> result = second.listen({"127.0.0.1", first.port()});
        QVERIFY(!result.has_value());
        QCOMPARE(result.error().code, ErrorCode::InUse);
        QVERIFY(result.error().detail.starts_with("UDP port "));
    }
};

} // namespace agv::link

QTEST_GUILESS_MAIN(agv::link::TelemetrySocketTest)
#include "test_telemetry_socket.moc"
