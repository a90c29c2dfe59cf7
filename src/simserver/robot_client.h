// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QHostAddress>
#include <QObject>
#include <QTcpSocket>
#include <QTimer>
#include <QUdpSocket>

#include "core/plant_layout.h"
#include "core/result.h"
#include "core/units.h"

#include <cstdint>
#include <vector>

namespace agv::simserver {

/// The Wi-Fi bridge of one robot: a TCP client that connects from the robot's own address to the console and
/// seeks it again every second when lost, and UDP telemetry from the same address.
class RobotClient : public QObject {
    Q_OBJECT
public:
    using Bytes = std::vector<std::uint8_t>;

    /// Connects from `address`; source port 0 lets the system choose one.
    RobotClient(QHostAddress address, quint16 sourcePort, QObject* parent = nullptr);
    ~RobotClient() override;

    /// Connects there from now on, leaving any console it is connected to. NotFound: not a numeric address.
    Result<void> setConsole(const Endpoint& console, quint16 telemetryPort);
    bool isConnected() const { return m_socket.state() == QAbstractSocket::ConnectedState; }

    /// Frames for the console; lost when it is not connected.
    void send(const Bytes& frames);
    void sendTelemetry(const std::vector<Bytes>& datagrams);

    /// Loses the connection and seeks no new one for `away` (at least a second).
    void cut(Duration away);
    /// Nothing goes through, either way, for so long; then everything does.
    void stall(Duration duration);
    /// The bridge has died: its socket stays open, nothing is read or sent any more.
    void loseSilently();
    /// The bridge is back after loseSilently(): the old connection is reset. Ends a cut or stall, too.
    void restore();

signals:
    void connected();
    void lost(const QString& reason);
    void received(const QByteArray& bytes);

private:
    void seek();
    void onLost();
    void onReadyRead();
    void endStall();

    QHostAddress m_address;
    quint16 m_sourcePort;
    QHostAddress m_console;
    quint16 m_consolePort = 0;
    quint16 m_telemetryPort = 0;
    QTcpSocket m_socket;
    QUdpSocket m_telemetry;
    QTimer m_seekTimer;
    QTimer m_stallTimer;
    QByteArray m_held; ///< frames of a stall
    bool m_dead = false;
    bool m_wasConnected = false;
};

} // namespace agv::simserver
