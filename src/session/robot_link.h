// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/snapshot.h"
#include "link/robot_server.h"
#include "procedure/zero_burst.h"
#include "protocol/robot_frame.h"
#include "protocol/robot_stream.h"
#include "session/rate_meter.h"

#include <optional>

namespace agv::session {

/// One robot as seen through the robot link: what it was told, what it reports, whether it may be moving.
/// Lives in the session thread. A robot that connects is first told to stand still: nobody knows what it did
/// while it was not heard.
class RobotLink : public QObject {
    Q_OBJECT
public:
    RobotLink(int robot, link::RobotServer& server, QObject* parent);

    void onConnected(const QString& peer);
    void onReceived(const link::Chunk& chunk);
    void onDatagram(const link::Chunk& datagram);
    void onLost(const QString& reason);
    /// Why robots cannot connect at all; empty: they can.
    void setServerTrouble(const std::string& reason) { m_serverTrouble = reason; }

    /// False when the robot is not connected, does not read, or the command cannot be encoded.
    bool send(const protocol::RobotCommand& command);
    /// Zero speed, several times; before that an interrupt, should the robot drive by itself.
    void stop();
    /// Interrupt and zero speeds at once, for the end of the program.
    void stopNow();

    bool isConnected() const { return m_connected; }
    /// How long a command has waited for the robot's system to confirm it; zero: none waits.
    Duration unconfirmedFor(Time now) const { return m_server.unconfirmedFor(m_robot, now); }
    /// It docks or undocks, by its own word or because it was just told to.
    bool drivesItself() const;
    std::optional<RobotState> state() const { return m_state; }
    /// A number no segment of this robot has had yet.
    std::uint32_t nextSegment() const { return m_nextSegment; }

    LinkSnapshot snapshot(Time now);
    std::optional<BatteryStatus> battery() const { return m_battery; }
    WheelSpeeds commanded() const { return m_commanded; }
    /// The link was lost, and nobody knows whether the robot heard the last command to stop, or there was
    /// none.
    bool mayBeMoving() const { return m_mayBeMoving; }

signals:
    void segmentDone(quint32 number);
    void stateReported(agv::RobotState state);
    /// The wheels were told other speeds, or reached the end of a segment.
    void speedsChanged(const agv::WheelSpeeds& speeds);
    void message(agv::EventLevel level, const QString& text);
    void batteryReported(const agv::BatteryStatus& battery);
    /// Every byte that was sent, for recordings.
    void bytesSent(const agv::link::Chunk& chunk);

private:
    void take(const protocol::RobotReport& report, Time now);
    void noteSegment(std::uint32_t number);
    /// A command for these speeds is on its way.
    void noteSpeeds(const WheelSpeeds& speeds);
    void serveBurst();
    void armBurst();

    int m_robot;
    link::RobotServer& m_server;
    QTimer* m_burstTimer;
    procedure::ZeroBurst m_burst;
    bool m_connected = false;
    std::string m_peer;
    std::string m_lossReason;
    std::string m_serverTrouble;
    protocol::ReportStream m_stream;
    protocol::FrameCounts m_datagrams;
    RateMeter m_rate;
    Time m_connectedAt;
    std::optional<Time> m_lastData;
    std::optional<BatteryStatus> m_battery;
    std::optional<RobotState> m_state;
    WheelSpeeds m_commanded;
    std::optional<Time> m_unconfirmedStop; ///< when a motion was told to end; until the robot says it stands
    bool m_mayBeMoving = false;
    bool m_toldToDock = false; ///< or to undock; until it stands again
    std::uint32_t m_nextSegment = 0;
};

} // namespace agv::session
