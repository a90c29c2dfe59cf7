// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>
#include <QObject>

#include "core/plant_layout.h"
#include "core/result.h"
#include "link/chunk.h"

class QUdpSocket;

namespace agv::link {

/// Receives the robots' telemetry datagrams. Lives in the session thread; sends nothing.
class TelemetrySocket : public QObject {
    Q_OBJECT
public:
    explicit TelemetrySocket(QObject* parent = nullptr);

    /// Port 0 takes a free one.
    Result<void> listen(const Endpoint& local);
    quint16 port() const; ///< 0 while not listening

signals:
    void received(const QHostAddress& sender, const agv::link::Chunk& datagram);

private:
    void readAll();

    QUdpSocket* m_socket;
};

} // namespace agv::link
