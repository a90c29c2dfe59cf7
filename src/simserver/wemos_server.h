// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>
#include <QObject>
#include <QPointer>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

#include "core/random.h"
#include "core/result.h"
#include "core/units.h"

#include <string>
#include <vector>

namespace agv::simserver {

/// The WeMos D1 mini of one AGV on a real socket: a TCP server that passes the reader's characters on to at
/// most two clients (seed, appendices M to P). A third client is closed at once. What clients send is
/// ignored. Characters go out one by one, in lumps, or a little late, so lines arrive cut anywhere. While
/// nobody listens, or during a stall, the 256 byte serial buffer of its program fills up and then loses what
/// comes.
class WemosServer : public QObject {
    Q_OBJECT
public:
    explicit WemosServer(SplitMix64 random, QObject* parent = nullptr);
    ~WemosServer() override;

    /// Port 0 picks a free one. InUse, Permission or Network: cannot listen there; the text names the
    /// address.
    Result<void> listen(const QHostAddress& address, quint16 port);
    quint16 port() const { return m_port; }
    int clientCount() const { return static_cast<int>(m_clients.size()); }

    /// Characters of the reader; call it regularly, also with none, for what was held back.
    void forward(const std::string& characters);

    /// Closes all clients; refuses connections for `away`.
    void cut(Duration away);
    void stall(Duration duration);
    /// Power loss: connections stay open, but nothing is sent any more and new ones get no answer.
    void loseSilently();
    /// Power is back after loseSilently(): the old connections are reset. Ends a cut or stall, too.
    void restore();

signals:
    void clientConnected(const QString& peer);
    void clientRefused(const QString& peer);
    void clientLost(const QString& peer);

private:
    void accept();
    void dropClients();
    void comeBack();
    void send(std::string_view characters);

    SplitMix64 m_random;
    QTcpServer m_server;
    QHostAddress m_address;
    quint16 m_port = 0;
    std::vector<QTcpSocket*> m_clients;             ///< owned by m_server
    std::vector<QPointer<QTcpSocket>> m_unanswered; ///< connected after the power loss
    std::string m_serialBuffer;
    QTimer m_stallTimer;
    QTimer m_awayTimer;
    bool m_dead = false;
};

} // namespace agv::simserver
