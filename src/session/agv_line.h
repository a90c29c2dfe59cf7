// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "link/robot_server.h"
#include "session/event_log.h"
#include "session/solve_worker.h"

#include <set>
#include <string>

namespace agv::session {

class ReaderLink;
class RobotLink;
class TurnRunner;

/// Everything of one AGV: reader, robot, turn and pose, wired to each other. Lives in the session thread.
class AgvLine : public QObject {
    Q_OBJECT
public:
    AgvLine(const AgvConfig& config, link::RobotServer& server, SolveFunction solve, SolveMethod method,
            EventLog& events, QObject* parent);

    void openReader();
    void closeReader();
    void setReaderEndpoint(const Endpoint& reader);

    void startTurn(const TurnParameters& parameters);
    void abortTurn(const std::string& reason);
    void retakeStop(int stop);
    void setTurnTime(double seconds);
    void setTurnSpeed(double metresPerSecond);
    /// Zero speed, whatever runs; never refused.
    void stop(const std::string& reason);
    /// The same at once, for the end of the program.
    void stopNow(const std::string& reason);

    void onRobotConnected(const QString& peer, bool replaced);
    void onRobotLost(const QString& reason);
    RobotLink& robot() { return *m_robot; }

    AgvSnapshot snapshot(Time now);

signals:
    void changed();
    void bytesReceived(const agv::link::Chunk& chunk);
    void turnPhaseChanged(agv::TurnPhase phase, int stop, agv::Time time);
    void turnRefused(const QString& reason);
    void turnEnded(const agv::TurnSnapshot& turn, std::shared_ptr<const agv::TurnRecord> record);

private:
    void wireReader();
    void wireRobot();
    void wireTurn();
    std::string whyNoTurn() const;
    void takePose(const TurnSnapshot& turn);
    /// Each trouble once until data comes again: the tries of a link that is down repeat it for hours.
    void logReader(LinkState state, const QString& reason);
    void log(EventLevel level, const std::string& text);

    AgvConfig m_config;
    std::string m_label; ///< "AGV 1"
    EventLog& m_events;
    ReaderLink* m_reader;
    RobotLink* m_robot;
    TurnRunner* m_turn;
    std::set<std::string> m_readerTroubles; ///< logged since the link was last well
    double m_turnTime_s;
    double m_turnSpeed_m_s;
    std::optional<Pose2> m_pose;
    PoseCovariance m_covariance{};
};

} // namespace agv::session
