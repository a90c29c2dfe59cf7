// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "link/failure_text.h"

namespace agv::link {

class FailureTextTest : public QObject {
    Q_OBJECT
private slots:
    void everyConnectionFailureNamesThePeerAndWhatToDo_data()
    {
        QTest::addColumn<QAbstractSocket::SocketError>("error");
        QTest::addColumn<bool>("transient");
        QTest::newRow("refused") << QAbstractSocket::ConnectionRefusedError << true;
        QTest::newRow("closed") << QAbstractSocket::RemoteHostClosedError << true;
        QTest::newRow("unknown host") << QAbstractSocket::HostNotFoundError << false;
        QTest::newRow("time-out") << QAbstractSocket::SocketTimeoutError << true;
        QTest::newRow("network") << QAbstractSocket::NetworkError << true;
        QTest::newRow("access") << QAbstractSocket::SocketAccessError << false;
        QTest::newRow("other") << QAbstractSocket::UnknownSocketError << true;
    }
    void everyConnectionFailureNamesThePeerAndWhatToDo()
    {
        QFETCH(QAbstractSocket::SocketError, error);
        QFETCH(bool, transient);
        const QString text = connectionFailureText(error, true, {"wemos.plant", 8883}, "odd thing");
        QVERIFY2(text.contains("wemos.plant"), qPrintable(text));
        QVERIFY2(text.contains(':'), qPrintable(text));
        QCOMPARE(isTransient(error), transient);
    }
    void aRobotThatClosesTheConnectionIsNoWemosThatServesOthers()
    {
        const Endpoint robot{"192.168.1.2", 4711};
        QCOMPARE(robotLossText(QAbstractSocket::RemoteHostClosedError, robot, {}),
                 "192.168.1.2:4711 closed the connection: it was switched off or restarted");
        QCOMPARE(robotLossText(QAbstractSocket::SocketTimeoutError, robot, {}),
                 connectionFailureText(QAbstractSocket::SocketTimeoutError, true, robot, {}));
    }
    void aListenFailureSaysWhereAndWhatToDo()
    {
        const Error error = listenFailure(QAbstractSocket::AddressInUseError, "TCP", {"127.0.0.1", 2001}, {});
        QCOMPARE(error.code, ErrorCode::InUse);
        QCOMPARE(
            QString::fromStdString(error.detail),
            "TCP port 2001 on 127.0.0.1 is in use: another console or program holds it; end that program or "
            "change the port in the plant file");
        QCOMPARE(listenFailure(QAbstractSocket::SocketAccessError, "UDP", {"::1", 20}, {}).code,
                 ErrorCode::Permission);
        QCOMPARE(
            listenFailure(QAbstractSocket::SocketAddressNotAvailableError, "UDP", {"1.2.3.4", 2}, {}).code,
            ErrorCode::NotFound);
        QVERIFY(listenFailure(QAbstractSocket::UnknownSocketError, "UDP", {"1.2.3.4", 2}, "odd thing")
                    .detail.ends_with("odd thing"));
    }
};

} // namespace agv::link

QTEST_GUILESS_MAIN(agv::link::FailureTextTest)
#include "test_failure_text.moc"
