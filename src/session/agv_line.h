// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "estimation/fusion/vehicle_tracker.h"
#include "link/robot_server.h"
#include "session/event_log.h"
#include "session/solve_worker.h"

#include <set>
#include <string>

namespace agv::session {

class JogRunner;
class ReaderLink;
class RobotLink;
class TurnRunner;

/// Everything of one AGV: reader, robot, turn and pose, wired to each other. Lives in the session thread.
class AgvLine : public QObject {
    Q_OBJECT
public:
    /// `plant`: its floor tags and RSSI table.
    AgvLine(const AgvConfig& config, const PlantLayout& plant, link::RobotServer& server, SolveFunction solve,
            SolveMethod method, EventLog& events, QObject* parent);

    void openReader();
    void closeReader();
    void setReaderEndpoint(const Endpoint& reader);

    void startTurn(const TurnParameters& parameters);
    void abortTurn(const std::string& reason);
    void retakeStop(int stop);
    void setTurnTime(double seconds);
    void setTurnSpeed(double metresPerSecond);
    /// Zero speed, whatever runs; never refused. Driving by hand is locked until its latch is released.
    void stopAll(const std::string& reason);
    /// The same for this AGV alone, without the latch.
    void stopByHand();
    /// The same at once, for the end of the program.
    void stopNow(const std::string& reason);

    /// Ranges of a UWB tag that the AGV carries; see VehicleTracker.
    void onRanges(estimation::AnchorRanges ranges, Point2 mount, double height_m, Time time)
    {
        m_tracker.ranges(ranges, mount, height_m, time);
    }

    void onRobotConnected(const QString& peer, bool replaced);
    void onRobotLost(const QString& reason);
    RobotLink& robot() { return *m_robot; }
    JogRunner& jog() { return *m_jog; }

    AgvSnapshot snapshot(Time now);

signals:
    void changed();
    void bytesReceived(const agv::link::Chunk& chunk);
    void tagRead(const agv::TagRead& read);
    void turnPhaseChanged(agv::TurnPhase phase, int stop, agv::Time time);
    void turnRefused(const QString& reason);
    void turnEnded(const agv::TurnSnapshot& turn, std::shared_ptr<const agv::TurnRecord> record);

private:
    void wireReader();
    void wireRobot();
    void wireTurn();
    std::string whyNoTurn() const;
    void takePose(const TurnSnapshot& turn);
    void onRobotState(RobotState state);
    void logHealth(const TrackedPose& tracked);
    /// Each trouble once until data comes again: the tries of a link that is down repeat it for hours.
    void logReader(LinkState state, const QString& reason);
    void log(EventLevel level, const std::string& text);

    AgvConfig m_config;
    std::string m_label; ///< "AGV 1"
    EventLog& m_events;
    ReaderLink* m_reader;
    RobotLink* m_robot;
    TurnRunner* m_turn;
    JogRunner* m_jog;
    std::set<std::string> m_readerTroubles; ///< logged since the link was last well
    double m_turnTime_s;
    double m_turnSpeed_m_s;
    estimation::VehicleTracker m_tracker;
    PoseHealth m_loggedHealth = PoseHealth::None;
};

} // namespace agv::session
