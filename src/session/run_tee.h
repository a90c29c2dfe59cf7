// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/snapshot.h"
#include "link/robot_server.h"
#include "link/telemetry_socket.h"
#include "protocol/trek_ranges.h"
#include "session/run_recorder.h"
#include "session/uwb_tag_track.h"

#include <map>
#include <optional>
#include <string>

namespace agv::session {

class AgvLine;
class UwbLine;

/// Leads everything that passes along the line into the recorder too: bytes before they are framed, rows
/// when they are made. Lives in the session thread.
class RunTee : public QObject {
    Q_OBJECT
public:
    RunTee(RunRecorder& recorder, QObject* parent);

    // Called before anybody else listens to them, so that the bytes come before what is made of them.
    void watch(link::RobotServer& server, link::TelemetrySocket& telemetry);
    void watch(int robot, AgvLine& line);
    void watch(UwbLine& line);

    /// The poses, ten a second at most and only those that changed.
    void snapshot(const PlantSnapshot& snapshot);
    void event(const EventEntry& entry);
    /// A turn is about to start: where every turn is to be recorded, its run begins.
    void beginTurn();
    void action(const char* name, std::optional<int> robot = {}, const std::string& detail = {});

private:
    void takeRanges(const protocol::RangeSet& ranges, const UwbTagTrack& track, Time arrival);
    void endTurn();
    void takeTurn(int robot, const TurnSnapshot& turn);

    RunRecorder& m_recorder;
    std::map<int, recording::PoseRow> m_poses; ///< recorded last, by AGV
    bool m_isOfTurn = false;                   ///< the run was begun by a turn, and ends with it
};

} // namespace agv::session
