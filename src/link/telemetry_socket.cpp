// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/telemetry_socket.h"

#include "link/failure_text.h"

#include <QNetworkDatagram>
#include <QNetworkProxy>
#include <QUdpSocket>

namespace agv::link {
namespace {

/// Datagrams read in one turn of the event loop: a flood of them must not hold up a stop.
constexpr int mostAtOnce = 64;

} // namespace

TelemetrySocket::TelemetrySocket(QObject* parent) : QObject(parent), m_socket(new QUdpSocket(this))
{
    m_socket->setProxy(QNetworkProxy::NoProxy);
    connect(m_socket, &QUdpSocket::readyRead, this, &TelemetrySocket::readAll);
}

Result<void> TelemetrySocket::listen(const Endpoint& local)
{
    m_socket->close();
    // Not shared: of two consoles on one port only one would hear the robots.
    if (m_socket->bind(QHostAddress(QString::fromStdString(local.host)), local.port,
                       QAbstractSocket::DontShareAddress)) {
        return {};
    }
    return std::unexpected(listenFailure(m_socket->error(), "UDP", local, m_socket->errorString()));
}

quint16 TelemetrySocket::port() const { return m_socket->localPort(); }

void TelemetrySocket::readAll()
{
    for (int i = 0; i < mostAtOnce && m_socket->hasPendingDatagrams(); ++i) {
        const Time now = std::chrono::steady_clock::now();
        const QNetworkDatagram datagram = m_socket->receiveDatagram();
        if (datagram.isValid())
            emit received(datagram.senderAddress(), {datagram.data(), now});
    }
}

} // namespace agv::link
