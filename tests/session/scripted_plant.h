// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

#include "core/plant_layout.h"
#include "protocol/robot_frame.h"
#include "protocol/robot_stream.h"
#include "session/session.h"

#include <memory>
#include <vector>

namespace agv::session {

/// How long a test waits for what must come: no requirement, long enough for a busy machine and sanitizers.
inline constexpr int patience_ms = 30'000;

/// A WeMos bridge with a reader that reports two tags in turn, on a real port.
class ScriptedReader : public QObject {
    Q_OBJECT
public:
    ScriptedReader();
    quint16 port() const { return m_port; }
    /// Cuts every connection; new ones are refused until listen().
    void cut();
    void listen();
    /// Connections stay open, but nothing more is said.
    void setMute(bool mute) { m_mute = mute; }
    /// Gone without a word, with all its connections; new ones are not even refused.
    void vanish();
    void say(const QByteArray& bytes);
    int clients() const { return static_cast<int>(m_clients.size()); }
    int connectionsEver() const { return m_connectionsEver; }

private:
    quint16 m_port = 0;
    QTimer m_timer;
    std::vector<QTcpSocket*> m_clients;
    int m_connectionsEver = 0;
    bool m_mute = false;
    bool m_firstTag = true;
    QTcpServer m_server; ///< last, so gone first: its sockets leave m_clients as they end
};

/// A robot that reads the wire, and reports the end of its segments and that it stands after direct driving.
class ScriptedRobot : public QObject {
    Q_OBJECT
public:
    explicit ScriptedRobot(const char* address) : m_address(QString::fromLatin1(address)) {}

    void connectTo(quint16 port);
    void cut();
    /// Gone without a word: whatever is sent to it is lost, and nobody says so.
    void vanish();
    void report(const protocol::RobotReport& report);
    bool isConnected() const { return m_socket && m_socket->state() == QAbstractSocket::ConnectedState; }
    bool answersSegments = true;

    /// Everything the console ever said, over all connections.
    const std::vector<protocol::RobotCommand>& wire() const { return m_wire; }
    const std::vector<Time>& times() const { return m_times; } ///< when each arrived
    int motionsAfter(std::size_t index) const; ///< commands from `index` on that start a motion
    int zerosAfter(std::size_t index) const;   ///< zero wheel speeds from `index` on
    std::size_t behindLastMotion() const;      ///< index of the wire
    int segmentsDone() const { return m_segmentsDone; }

private:
    void take(const protocol::RobotCommand& command);

    QString m_address;
    protocol::CommandStream m_stream;
    bool m_drives = false;
    std::vector<protocol::RobotCommand> m_wire;
    std::vector<Time> m_times;
    int m_segmentsDone = 0;               ///< ends of driven segments that were reported
    std::unique_ptr<QTcpSocket> m_socket; ///< last, so gone before what it fills
};

/// A session with one AGV, its reader and its robot, all in this thread.
class ScriptedPlant {
public:
    explicit ScriptedPlant(SolveMethod method = SolveMethod::Fast, RecordingOptions recording = {});
    ~ScriptedPlant();

    /// Everything connected and reads flowing; false after a time-out.
    bool bringUp();
    /// Writes what is known to the log of the test, for one that failed.
    void describe() const;
    /// Ends the session as the program does.
    void endSession() { session.reset(); }
    /// Waits until the turn is in `phase` at `stop` (1-based) and returns before anything else happens.
    bool reach(TurnPhase phase, int stop);
    const AgvSnapshot& agv() const { return last.agvs.front(); }
    bool logged(EventLevel level, const char* part) const;

    static PlantLayout layout(quint16 readerPort);
    /// A whole turn in about four seconds. A stop ends when both tags were read and no other came for a
    /// quarter of a second, so that a busy computer makes the turn longer and not its stops empty.
    static TurnParameters quickTurn(TurnKind kind = TurnKind::Timed);

    ScriptedReader reader;
    ScriptedRobot robot{"127.0.0.2"};
    std::unique_ptr<Session> session;
    quint16 port = 0;
    quint16 telemetryPort = 0;
    PlantSnapshot last;
    TurnPhase phase = TurnPhase::Idle;
    int stop = 0;
    std::vector<EventEntry> events;
    std::vector<TurnSnapshot> ended;
    std::shared_ptr<const TurnRecord> record;
};

} // namespace agv::session
