// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "core/plant_layout.h"
#include "link/chunk.h"

#include <memory>

class QTcpSocket;

namespace agv::link {

/// A TCP client connection, one attempt at a time. It reports, it does not decide: when to try again is the
/// business of procedure::LinkLife. Lives in the session thread; never blocks. Every attempt ends with
/// close() or with exactly one failed(); the socket is closed by then.
class TcpClientLink : public QObject {
    Q_OBJECT
public:
    /// Bytes that may wait for a peer that does not read.
    static constexpr qint64 maxBacklog = 4096;

    explicit TcpClientLink(QObject* parent = nullptr);
    ~TcpClientLink() override;

    /// Ends a running attempt silently and begins a new one.
    void open(const Endpoint& peer);
    /// Silent: no signal follows.
    void close();
    /// False, and nothing is sent, when there is no connection or the backlog would pass maxBacklog.
    bool write(const QByteArray& bytes);
    bool isConnected() const;

signals:
    void connected();
    void received(const agv::link::Chunk& chunk);
    /// `transient`: another try may help by itself. `reason`: plain English, what and what to do.
    void failed(bool transient, const QString& reason);

private:
    void onConnected();
    void onReadyRead();
    void onError();

    Endpoint m_peer;
    QTcpSocket* m_socket = nullptr; ///< owned (QObject child); a new one for each attempt
    bool m_wasConnected = false;
};

} // namespace agv::link
