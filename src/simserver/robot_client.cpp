// SPDX-License-Identifier: GPL-3.0-or-later
#include "simserver/robot_client.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace agv::simserver {
namespace {

using namespace std::chrono_literals;

constexpr auto seekPeriod = 1000ms;
constexpr qsizetype holdLimit = 64 * 1024;

} // namespace

RobotClient::RobotClient(QHostAddress address, quint16 sourcePort, QObject* parent)
    : QObject(parent),
      m_address(std::move(address)),
      m_sourcePort(sourcePort)
{
    m_seekTimer.setSingleShot(true);
    m_stallTimer.setSingleShot(true);
    m_telemetry.bind(m_address, 0);
    connect(&m_seekTimer, &QTimer::timeout, this, &RobotClient::seek);
    connect(&m_stallTimer, &QTimer::timeout, this, &RobotClient::endStall);
    connect(&m_socket, &QTcpSocket::readyRead, this, &RobotClient::onReadyRead);
    connect(&m_socket, &QTcpSocket::connected, this, [this] {
        m_socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
        m_wasConnected = true;
        emit connected();
    });
    connect(&m_socket, &QTcpSocket::disconnected, this, &RobotClient::onLost);
    connect(&m_socket, &QTcpSocket::errorOccurred, this, &RobotClient::onLost);
}

RobotClient::~RobotClient() { m_socket.disconnect(this); }

Result<void> RobotClient::setConsole(const Endpoint& console, quint16 telemetryPort)
{
    const QString host = QString::fromStdString(console.host);
    QHostAddress address(host == QStringLiteral("localhost") ? QStringLiteral("127.0.0.1") : host);
    if (address.isNull())
        return failure(ErrorCode::NotFound,
                       "'" + console.host + "' is not a numeric address such as 127.0.0.1");
    m_console = address;
    m_consolePort = console.port;
    m_telemetryPort = telemetryPort;
    m_socket.abort();
    m_seekTimer.stop();
    seek();
    return {};
}

void RobotClient::seek()
{
    if (m_console.isNull() || m_dead || m_socket.state() != QAbstractSocket::UnconnectedState)
        return;
    // The robot's own address is how the console knows it; a fixed source port may still be in TIME_WAIT.
    if (!m_socket.bind(m_address, m_sourcePort, QAbstractSocket::ReuseAddressHint)) {
        m_seekTimer.start(seekPeriod);
        return;
    }
    m_socket.connectToHost(m_console, m_consolePort);
}

void RobotClient::onLost()
{
    if (std::exchange(m_wasConnected, false))
        emit lost(m_socket.errorString());
    m_held.clear();
    if (!m_dead && !m_seekTimer.isActive())
        m_seekTimer.start(seekPeriod);
}

void RobotClient::onReadyRead()
{
    if (m_dead) {
        m_socket.readAll();
        return;
    }
    if (!m_stallTimer.isActive())
        emit received(m_socket.readAll());
}

void RobotClient::endStall()
{
    if (!isConnected())
        return;
    m_socket.write(std::exchange(m_held, {}));
    onReadyRead();
}

void RobotClient::send(const Bytes& frames)
{
    if (frames.empty() || m_dead || !isConnected())
        return;
    const auto* data = reinterpret_cast<const char*>(frames.data());
    const auto size = static_cast<qsizetype>(frames.size());
    if (m_stallTimer.isActive()) {
        if (m_held.size() + size <= holdLimit)
            m_held.append(data, size);
        return;
    }
    if (m_socket.bytesToWrite() < holdLimit) {
        m_socket.write(data, size);
        m_socket.flush();
    }
}

void RobotClient::sendTelemetry(const std::vector<Bytes>& datagrams)
{
    if (m_dead || m_stallTimer.isActive() || m_console.isNull() || m_telemetryPort == 0)
        return;
    for (const Bytes& datagram : datagrams)
        m_telemetry.writeDatagram(reinterpret_cast<const char*>(datagram.data()),
                                  static_cast<qint64>(datagram.size()), m_console, m_telemetryPort);
}

void RobotClient::cut(Duration away)
{
    m_seekTimer.start(std::chrono::ceil<std::chrono::milliseconds>(std::max<Duration>(away, seekPeriod)));
    m_socket.abort();
}

void RobotClient::stall(Duration duration)
{
    m_stallTimer.start(std::chrono::ceil<std::chrono::milliseconds>(duration));
}

void RobotClient::loseSilently()
{
    m_dead = true;
    m_seekTimer.stop();
}

void RobotClient::restore()
{
    if (m_stallTimer.isActive()) {
        m_stallTimer.stop();
        endStall();
    }
    if (std::exchange(m_dead, false))
        m_socket.abort();
    if (m_socket.state() == QAbstractSocket::UnconnectedState) {
        m_seekTimer.stop();
        seek();
    }
}

} // namespace agv::simserver
