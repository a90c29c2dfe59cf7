// SPDX-License-Identifier: GPL-3.0-or-later
#include "simserver/wemos_server.h"

#include <QTcpSocket>

#include <algorithm>
#include <chrono>
#include <utility>

namespace agv::simserver {
namespace {

constexpr std::size_t clientLimit = 2;           // MAX_SRV_CLIENTS, seed, appendix M
constexpr std::size_t serialBufferSize = 256;    // SoftwareSerial RFID(14, 12, false, 256), ibid.
constexpr qint64 readerBacklogLimit = 64 * 1024; // a client that does not read is dropped

QString peerOf(const QTcpSocket& socket)
{
    return socket.peerAddress().toString() + ':' + QString::number(socket.peerPort());
}

ErrorCode codeOf(QAbstractSocket::SocketError error)
{
    if (error == QAbstractSocket::AddressInUseError)
        return ErrorCode::InUse;
    return error == QAbstractSocket::SocketAccessError ? ErrorCode::Permission : ErrorCode::Network;
}

} // namespace

WemosServer::WemosServer(SplitMix64 random, QObject* parent) : QObject(parent), m_random(random)
{
    m_stallTimer.setSingleShot(true);
    m_awayTimer.setSingleShot(true);
    connect(&m_server, &QTcpServer::newConnection, this, &WemosServer::accept);
    connect(&m_awayTimer, &QTimer::timeout, this, &WemosServer::comeBack);
}

WemosServer::~WemosServer()
{
    // The server closes its sockets after the list of them is gone.
    for (QTcpSocket* client : m_clients)
        client->disconnect(this);
}

Result<void> WemosServer::listen(const QHostAddress& address, quint16 port)
{
    if (!m_server.listen(address, port))
        return failure(codeOf(m_server.serverError()),
                       "cannot serve a reader on " + address.toString().toStdString() + ":" +
                           std::to_string(port) + ": " + m_server.errorString().toStdString());
    m_address = address;
    m_port = m_server.serverPort();
    return {};
}

void WemosServer::accept()
{
    while (QTcpSocket* client = m_server.nextPendingConnection()) {
        const QString peer = peerOf(*client);
        if (m_dead) { // the system has answered, the WeMos never will
            connect(client, &QTcpSocket::disconnected, client, &QObject::deleteLater);
            m_unanswered.push_back(client);
            continue;
        }
        if (m_clients.size() >= clientLimit) {
            connect(client, &QTcpSocket::disconnected, client, &QObject::deleteLater);
            client->disconnectFromHost();
            emit clientRefused(peer);
            continue;
        }
        client->setSocketOption(QAbstractSocket::LowDelayOption, 1); // server.setNoDelay(true)
        m_clients.push_back(client);
        connect(client, &QTcpSocket::readyRead, client, [client] { client->readAll(); });
        connect(client, &QTcpSocket::disconnected, this, [this, client, peer] {
            std::erase(m_clients, client);
            client->deleteLater();
            emit clientLost(peer);
        });
        emit clientConnected(peer);
    }
}

void WemosServer::forward(const std::string& characters)
{
    if (m_dead)
        return;
    if (m_clients.empty() || m_stallTimer.isActive()) {
        const std::size_t room = serialBufferSize - std::min(serialBufferSize, m_serialBuffer.size());
        m_serialBuffer.append(characters, 0, room);
        return;
    }
    m_serialBuffer += characters;
    if (m_serialBuffer.empty())
        return;
    // Now and then the last few characters come with the next call, as they do when the loop is busy.
    std::size_t ready = m_serialBuffer.size();
    if (!characters.empty() && m_random.uniform() < 0.2)
        ready -= std::min<std::size_t>(ready, 1 + m_random.next() % 12);
    const std::string now = m_serialBuffer.substr(0, ready);
    m_serialBuffer.erase(0, ready);
    const bool oneByOne = m_random.uniform() < 0.3;
    for (std::size_t at = 0; at < now.size();) {
        const std::size_t length = oneByOne ? 1 : 1 + m_random.next() % now.size();
        send(std::string_view(now).substr(at, length));
        at += length;
    }
}

void WemosServer::send(std::string_view characters)
{
    const std::vector<QTcpSocket*> clients = m_clients; // writing may find one of them gone
    for (QTcpSocket* client : clients) {
        if (client->bytesToWrite() > readerBacklogLimit) {
            client->abort();
            continue;
        }
        client->write(characters.data(), static_cast<qint64>(characters.size()));
        client->flush();
    }
}

void WemosServer::dropClients()
{
    const std::vector<QTcpSocket*> clients = m_clients;
    for (QTcpSocket* client : clients)
        client->abort();
}

void WemosServer::cut(Duration away)
{
    dropClients();
    m_serialBuffer.clear();
    if (away > Duration::zero()) {
        m_server.close();
        m_awayTimer.start(std::chrono::ceil<std::chrono::milliseconds>(away));
    }
}

void WemosServer::comeBack()
{
    m_awayTimer.stop();
    if (!m_server.isListening() && m_port != 0)
        m_server.listen(m_address, m_port);
}

void WemosServer::stall(Duration duration)
{
    m_stallTimer.start(std::chrono::ceil<std::chrono::milliseconds>(duration));
}

void WemosServer::loseSilently()
{
    m_dead = true;
    m_serialBuffer.clear();
}

void WemosServer::restore()
{
    m_stallTimer.stop();
    if (m_dead) {
        m_dead = false;
        dropClients();
        for (const QPointer<QTcpSocket>& client : std::exchange(m_unanswered, {}))
            if (client)
                client->abort();
    }
    comeBack();
}

} // namespace agv::simserver
