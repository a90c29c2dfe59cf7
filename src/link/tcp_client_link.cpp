// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/tcp_client_link.h"

#include "link/failure_text.h"
#include "link/socket_options.h"

#include <QNetworkProxy>
#include <QTcpSocket>

#include <utility>

namespace agv::link {

TcpClientLink::TcpClientLink(QObject* parent) : QObject(parent) {}

TcpClientLink::~TcpClientLink() { close(); }

void TcpClientLink::open(const Endpoint& peer)
{
    close();
    m_peer = peer;
    m_wasConnected = false;
    m_socket = new QTcpSocket(this);
    m_socket->setProxy(QNetworkProxy::NoProxy);
    connect(m_socket, &QTcpSocket::connected, this, &TcpClientLink::onConnected);
    connect(m_socket, &QTcpSocket::readyRead, this, &TcpClientLink::onReadyRead);
    connect(m_socket, &QTcpSocket::errorOccurred, this, &TcpClientLink::onError);
    m_socket->connectToHost(QString::fromStdString(peer.host), peer.port);
}

void TcpClientLink::close()
{
    QTcpSocket* socket = std::exchange(m_socket, nullptr);
    if (!socket)
        return;
    // Nothing of an old attempt may reach the next one.
    socket->disconnect(this);
    socket->abort();
    socket->deleteLater();
}

bool TcpClientLink::write(const QByteArray& bytes)
{
    if (!isConnected() || m_socket->bytesToWrite() + bytes.size() > maxBacklog)
        return false;
    m_socket->write(bytes);
    return true;
}

bool TcpClientLink::isConnected() const
{
    return m_socket && m_socket->state() == QAbstractSocket::ConnectedState;
}

void TcpClientLink::onConnected()
{
    m_wasConnected = true;
    detectLossQuickly(*m_socket);
    emit connected();
}

void TcpClientLink::onReadyRead()
{
    const Time now = std::chrono::steady_clock::now();
    emit received({m_socket->readAll(), now});
}

void TcpClientLink::onError()
{
    const QTcpSocket* const failing = m_socket;
    const QAbstractSocket::SocketError error = m_socket->error();
    const QString reason = connectionFailureText(error, m_wasConnected, m_peer, m_socket->errorString());
    // The last bytes before a close are as good as any.
    if (m_socket->bytesAvailable() > 0)
        onReadyRead();
    // Whoever took them may have closed the link, or opened it anew: then this attempt is over already.
    if (m_socket != failing)
        return;
    close();
    emit failed(isTransient(error), reason);
}

} // namespace agv::link
