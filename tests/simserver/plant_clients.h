// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QTcpServer>
#include <QTcpSocket>
#include <QUdpSocket>

#include "core/plant_layout.h"
#include "protocol/reader_stream.h"
#include "protocol/robot_frame.h"

#include <string>
#include <vector>

namespace agv::simserver {

/// The console's end of the robot link: listens, collects what the robots send.
class FakeConsole : public QObject {
public:
    FakeConsole()
    {
        m_server.listen(QHostAddress::LocalHost, 0);
        udp.bind(QHostAddress::LocalHost, 0);
        connect(&m_server, &QTcpServer::newConnection, this, [this] {
            while (QTcpSocket* peer = m_server.nextPendingConnection())
                peers.push_back(peer);
        });
    }
    Endpoint endpoint() const { return {"127.0.0.1", m_server.serverPort()}; }
    /// The live connection of the robot at 127.0.0.(1 + number), or null.
    QTcpSocket* robot(int number) const
    {
        const QHostAddress wanted(QStringLiteral("127.0.0.%1").arg(number + 1));
        for (QTcpSocket* peer : peers)
            if (peer->state() == QAbstractSocket::ConnectedState && peer->peerAddress() == wanted)
                return peer;
        return nullptr;
    }
    void send(int number, const protocol::RobotCommand& command) const
    {
        const protocol::Bytes bytes = protocol::encodeCommand(command).value();
        robot(number)->write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
    }

    QUdpSocket udp;
    std::vector<QTcpSocket*> peers;

private:
    QTcpServer m_server;
};

/// A reader's client that decodes what arrives and remembers the sizes of the pieces.
class ReaderClient : public QObject {
public:
    ReaderClient(const QJsonObject& reader)
    {
        connect(&socket, &QTcpSocket::readyRead, this, [this] {
            const QByteArray bytes = socket.readAll();
            pieces.push_back(bytes.size());
            stream.feed({bytes.data(), static_cast<std::size_t>(bytes.size())},
                        [](const protocol::ReaderReport&) {});
        });
        socket.connectToHost(reader["host"].toString(), static_cast<quint16>(reader["port"].toInt()));
    }
    quint64 reads() const { return stream.counts().complete; }

    QTcpSocket socket;
    protocol::ReaderStream stream;
    std::vector<qsizetype> pieces;
};

} // namespace agv::simserver
