// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/robot_server.h"

#include "link/failure_text.h"

#include <QNetworkProxy>
#include <QTcpServer>
#include <QTcpSocket>

#include <utility>

namespace agv::link {
namespace {

bool sameAddress(const QHostAddress& a, const QHostAddress& b)
{
    return a.isEqual(b, QHostAddress::ConvertV4MappedToIPv4);
}

} // namespace

RobotServer::RobotServer(const std::vector<AgvConfig>& agvs, ConnectionGuard* guard, QObject* parent)
    : QObject(parent),
      m_server(new QTcpServer(this)),
      m_guard(guard)
{
    for (const AgvConfig& agv : agvs) {
        const QHostAddress address(QString::fromStdString(agv.robotHost));
        if (!address.isNull())
            m_peers.push_back({agv.id.number, address, agv.robotPeerPort});
    }
    m_server->setProxy(QNetworkProxy::NoProxy);
    connect(m_server, &QTcpServer::newConnection, this, &RobotServer::acceptPending);
}

RobotServer::~RobotServer()
{
    for (const auto& [robot, connection] : m_connections) {
        connection->finish();
        if (m_guard)
            m_guard->release(robot);
    }
}

Result<void> RobotServer::listen(const Endpoint& local)
{
    const QHostAddress address(QString::fromStdString(local.host));
    if (address.isNull()) {
        return failure(ErrorCode::BadInput, "\"" + local.host +
                                                "\" is not an address: the listen address of the plant file "
                                                "must be one of this computer, such as 127.0.0.1");
    }
    m_server->close();
    if (m_server->listen(address, local.port))
        return {};
    return std::unexpected(listenFailure(m_server->serverError(), "TCP", local, m_server->errorString()));
}

quint16 RobotServer::port() const { return m_server->serverPort(); }

bool RobotServer::send(int robot, const QByteArray& message, Urgency urgency)
{
    const auto found = m_connections.find(robot);
    return found != m_connections.end() && found->second->send(message, urgency);
}

Duration RobotServer::unconfirmedFor(int robot, Time now) const
{
    const auto found = m_connections.find(robot);
    return found != m_connections.end() ? found->second->unconfirmedFor(now) : Duration::zero();
}

std::optional<int> RobotServer::robotAt(const QHostAddress& address) const
{
    std::optional<int> robot;
    for (const Peer& peer : m_peers) {
        if (!sameAddress(peer.address, address))
            continue;
        if (robot)
            return std::nullopt;
        robot = peer.robot;
    }
    return robot;
}

std::optional<int> RobotServer::robotOf(const QHostAddress& address, quint16 port) const
{
    for (const Peer& peer : m_peers) {
        if (sameAddress(peer.address, address) && (peer.port == 0 || peer.port == port))
            return peer.robot;
    }
    return std::nullopt;
}

void RobotServer::acceptPending()
{
    while (QTcpSocket* socket = m_server->nextPendingConnection()) {
        if (const std::optional<int> robot = robotOf(socket->peerAddress(), socket->peerPort()))
            adopt(*robot, socket);
        else
            refuse(socket);
    }
}

void RobotServer::adopt(int robot, QTcpSocket* socket)
{
    const auto old = m_connections.find(robot);
    const bool replaced = old != m_connections.end();
    if (replaced) {
        RobotConnection* connection = old->second;
        connection->disconnect(this);
        connection->finish();
        connection->deleteLater();
        m_connections.erase(old);
    }
    auto* connection = new RobotConnection(socket, this);
    m_connections.emplace(robot, connection);
    if (m_guard)
        m_guard->guard(robot, connection->descriptor());
    connect(connection, &RobotConnection::received, this,
            [this, robot](const Chunk& chunk) { emit robotReceived(robot, chunk); });
    connect(connection, &RobotConnection::ended, this, [this, robot, connection](const QString& reason) {
        m_connections.erase(robot);
        if (m_guard)
            m_guard->release(robot);
        connection->deleteLater();
        emit robotLost(robot, reason);
    });
    emit robotConnected(robot, connection->peer(), replaced);
}

void RobotServer::refuse(QTcpSocket* socket)
{
    const QString address = socket->peerAddress().toString();
    socket->abort();
    socket->deleteLater();
    if (m_strangers.isNews(address, std::chrono::steady_clock::now()))
        emit peerRefused(address);
}

} // namespace agv::link
