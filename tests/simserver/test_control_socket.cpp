// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QJsonDocument>
#include <QLocalServer>
#include <QLocalSocket>
#include <QTemporaryDir>
#include <QTest>

#include "simserver/control_socket.h"

#include <memory>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace agv::simserver {

/// Commands through a real local socket.
class ControlSocketTest : public QObject {
    Q_OBJECT
private:
    static QJsonObject ask(QLocalSocket& client, const QByteArray& command)
    {
        client.write(command);
        if (!QTest::qWaitFor([&] { return client.canReadLine(); }))
            return {};
        return QJsonDocument::fromJson(client.readLine()).object();
    }
    QString path() const { return m_folder->filePath("plant"); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<PlantServer> m_server;

private slots:
    void init()
    {
        PlantLayout layout;
        layout.width_m = layout.height_m = 3.0;
        layout.floorTags = tagGrid(31, 31, 0.1, {0.0, 0.0}, TagUid{0xE00401503A5B0001});
        layout.agvs.push_back({.id = {1}, .name = "AGV 1", .robotHost = "127.0.0.2"});
        auto plant = simulation::Plant::create(layout, simulation::idealSettings());
        QVERIFY(plant);
        m_server = std::make_unique<PlantServer>(std::move(*plant), ServerOptions{});
        m_folder = std::make_unique<QTemporaryDir>();
    }
    void severalClientsSteerThePlantAtTheSameTime()
    {
        ControlSocket control(*m_server);
        QVERIFY(control.listen(path()));
        QLocalSocket first;
        QLocalSocket second;
        first.connectToServer(path());
        second.connectToServer(path());
        QVERIFY(ask(first, "battery 1 50\n")["ok"].toBool());
        QCOMPARE(m_server->plant().truth(RobotId{1})->charge, 0.5);
        QVERIFY(ask(second, "battery 1 5000\n")["error"].toString().contains("'5000'"));
        first.abort();
        QVERIFY(ask(second, "truth\n").contains("truth"));
    }
    void onlyThisUserMayConnect()
    {
        ControlSocket control(*m_server);
        QVERIFY(control.listen(path()));
        struct stat status{};
        QCOMPARE(::stat(QFile::encodeName(path()).constData(), &status), 0);
        QCOMPARE(status.st_mode & 077U, 0U);
    }
    void aSocketThatAKilledProgramLeftIsReplaced()
    {
        const int left = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        qstrncpy(address.sun_path, QFile::encodeName(path()).constData(), sizeof address.sun_path);
        QCOMPARE(::bind(left, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
        ::close(left);
        QVERIFY(QFile::exists(path()));
        ControlSocket control(*m_server);
        QVERIFY(control.listen(path()));
        QLocalSocket client;
        client.connectToServer(path());
        QVERIFY(ask(client, "truth\n").contains("truth"));
    }
    void aSocketInUseAndAFileOfAnotherKindStay()
    {
        QLocalServer occupant;
        QVERIFY(occupant.listen(path()));
        ControlSocket control(*m_server);
        const Result<void> refused = control.listen(path());
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::InUse);
        QVERIFY(refused.error().detail.find(path().toStdString()) != std::string::npos);
        QVERIFY(occupant.isListening());

        QFile file(m_folder->filePath("notes"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("keep");
        file.close();
        QVERIFY(!ControlSocket(*m_server).listen(file.fileName()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), "keep");
    }
    void aPlaceThatDoesNotExistIsSaid()
    {
        const Result<void> refused = ControlSocket(*m_server).listen(m_folder->filePath("no/such/plant"));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Io);
    }
};

} // namespace agv::simserver

QTEST_GUILESS_MAIN(agv::simserver::ControlSocketTest)
#include "test_control_socket.moc"
