// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>
#include <QObject>
#include <QString>

#include "core/plant_layout.h"
#include "core/result.h"
#include "link/chunk.h"
#include "link/connection_guard.h"
#include "link/robot_connection.h"
#include "link/stranger_watch.h"

#include <map>
#include <optional>
#include <vector>

class QTcpServer;
class QTcpSocket;

namespace agv::link {

/// The console is the server of the robot link: robots connect to it and are told apart by their address
/// (and source port, when the plant file gives one). Peers that are not in the plant file are refused. Lives
/// in the session thread; never blocks.
class RobotServer : public QObject {
    Q_OBJECT
public:
    /// `guard` may be null; it outlives this object.
    explicit RobotServer(const std::vector<AgvConfig>& agvs, ConnectionGuard* guard = nullptr,
                         QObject* parent = nullptr);
    ~RobotServer() override;

    /// Host must be an address of this computer; port 0 takes a free one.
    Result<void> listen(const Endpoint& local);
    quint16 port() const; ///< 0 while not listening

    /// False when the robot is not connected or its backlog is full.
    bool send(int robot, const QByteArray& message, Urgency urgency);
    /// See RobotConnection; zero when the robot is not connected.
    Duration unconfirmedFor(int robot, Time now) const;
    bool isConnected(int robot) const { return m_connections.contains(robot); }
    /// Which robot a datagram from `address` belongs to; empty when none or more than one lives there.
    std::optional<int> robotAt(const QHostAddress& address) const;

signals:
    /// `replaced`: an older connection of the same robot was closed for this one.
    void robotConnected(int robot, const QString& peer, bool replaced);
    void robotReceived(int robot, const agv::link::Chunk& chunk);
    void robotLost(int robot, const QString& reason);
    void peerRefused(const QString& address);

private:
    struct Peer {
        int robot = 0;
        QHostAddress address;
        quint16 port = 0;
    };
    void acceptPending();
    void adopt(int robot, QTcpSocket* socket);
    void refuse(QTcpSocket* socket);
    std::optional<int> robotOf(const QHostAddress& address, quint16 port) const;

    QTcpServer* m_server;
    ConnectionGuard* m_guard;
    std::vector<Peer> m_peers;
    std::map<int, RobotConnection*> m_connections; ///< owned (QObject children)
    StrangerWatch m_strangers;
};

} // namespace agv::link
