// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include "link/chunk.h"
#include "link/output_queue.h"

#include <deque>

class QTcpSocket;

namespace agv::link {

enum class Urgency { Ordinary, Urgent };

/// One accepted connection of a robot. Ends by itself on the first error, with one ended().
/// A message is handed to the system only when the robot has taken nearly all of the ones before: what the
/// system holds can no longer be overtaken by a stop, and as there is always room for a whole message, the
/// stream never ends inside one, even when this process is killed.
class RobotConnection : public QObject {
    Q_OBJECT
public:
    /// Takes the connected socket over.
    RobotConnection(QTcpSocket* socket, QObject* parent);
    ~RobotConnection() override;

    /// False when the backlog is full and the message is not urgent, or the connection has ended.
    bool send(const QByteArray& message, Urgency urgency);
    /// Hands what waits to the system and closes in order, so that it still reaches the robot.
    void finish();
    /// How long the oldest of the messages handed to the system has waited for the robot's system to confirm
    /// it; zero when none waits. The robot link has no acknowledgements of its own; this is TCP's.
    Duration unconfirmedFor(Time now);
    QString peer() const { return m_peer; }
    int descriptor() const; ///< -1 once ended

signals:
    void received(const agv::link::Chunk& chunk);
    void ended(const QString& reason);

private:
    struct Handed {
        qint64 end = 0; ///< of all bytes ever handed over
        Time time;
    };
    void pump();
    void forgetConfirmed();
    qint64 underway() const;
    void onReadyRead();
    void onError();

    QTcpSocket* m_socket; ///< owned (QObject child); null once ended
    QString m_peer;
    OutputQueue m_output;
    qint64 m_written = 0;
    std::deque<Handed> m_unconfirmed;
    QTimer m_again; ///< tries again while messages wait: the system does not say when the robot took some
};

} // namespace agv::link
