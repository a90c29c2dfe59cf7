// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/robot_connection.h"

#include "link/failure_text.h"
#include "link/socket_options.h"

#include <QHostAddress>
#include <QTcpSocket>

#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <utility>

namespace agv::link {
namespace {

constexpr qint64 handedOver = 256; ///< bytes the robot has not taken yet; some 36 drive commands
constexpr int systemBuffer = 4096; ///< far more than that and the longest message
constexpr std::chrono::milliseconds retryInterval(10);

Endpoint peerOf(const QTcpSocket& socket)
{
    return {socket.peerAddress().toString().toStdString(), socket.peerPort()};
}

} // namespace

RobotConnection::RobotConnection(QTcpSocket* socket, QObject* parent)
    : QObject(parent),
      m_socket(socket),
      m_peer(QString::fromStdString(toText(peerOf(*socket))))
{
    m_socket->setParent(this);
    detectLossQuickly(*m_socket);
    m_socket->setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, systemBuffer);
    connect(m_socket, &QTcpSocket::readyRead, this, &RobotConnection::onReadyRead);
    m_again.setSingleShot(true);
    m_again.setInterval(retryInterval);
    connect(&m_again, &QTimer::timeout, this, &RobotConnection::pump);
    connect(m_socket, &QTcpSocket::errorOccurred, this, &RobotConnection::onError);
}

RobotConnection::~RobotConnection() { finish(); }

bool RobotConnection::send(const QByteArray& message, Urgency urgency)
{
    if (!m_socket)
        return false;
    if (urgency == Urgency::Urgent)
        m_output.pushUrgent(message);
    else if (!m_output.push(message))
        return false;
    pump();
    return m_socket != nullptr;
}

void RobotConnection::pump()
{
    forgetConfirmed();
    while (m_socket && m_output.size() > 0 && underway() < handedOver) {
        const QByteArray message = *m_output.pop();
        m_socket->write(message);
        m_written += message.size();
        m_unconfirmed.push_back({m_written, std::chrono::steady_clock::now()});
        // Not a turn of the event loop later: a stop is on its way when send() returns.
        if (m_socket)
            m_socket->flush();
    }
    if (m_socket && m_output.size() > 0)
        m_again.start();
}

qint64 RobotConnection::underway() const
{
    if (!m_socket)
        return 0;
    int inSystem = 0;
    ::ioctl(descriptor(), SIOCOUTQ, &inSystem);
    return m_socket->bytesToWrite() + inSystem;
}

void RobotConnection::forgetConfirmed()
{
    const qint64 confirmed = m_written - underway();
    while (!m_unconfirmed.empty() && m_unconfirmed.front().end <= confirmed)
        m_unconfirmed.pop_front();
}

Duration RobotConnection::unconfirmedFor(Time now)
{
    if (!m_socket)
        return Duration::zero();
    forgetConfirmed();
    return m_unconfirmed.empty() ? Duration::zero() : now - m_unconfirmed.front().time;
}

int RobotConnection::descriptor() const
{
    return m_socket ? static_cast<int>(m_socket->socketDescriptor()) : -1;
}

void RobotConnection::finish()
{
    QTcpSocket* socket = std::exchange(m_socket, nullptr);
    if (!socket)
        return;
    socket->disconnect(this);
    while (const std::optional<QByteArray> message = m_output.pop())
        socket->write(*message);
    socket->flush();
    // Unread input would turn the close into a reset, which throws away what was just written.
    ::shutdown(static_cast<int>(socket->socketDescriptor()), SHUT_WR);
    socket->readAll();
    socket->abort();
    socket->deleteLater();
}

void RobotConnection::onReadyRead()
{
    const Time now = std::chrono::steady_clock::now();
    emit received({m_socket->readAll(), now});
}

void RobotConnection::onError()
{
    if (m_socket->bytesAvailable() > 0)
        onReadyRead();
    QTcpSocket* socket = std::exchange(m_socket, nullptr);
    if (!socket)
        return;
    const QString reason = robotLossText(socket->error(), peerOf(*socket), socket->errorString());
    socket->disconnect(this);
    socket->abort();
    socket->deleteLater();
    emit ended(reason);
}

} // namespace agv::link
