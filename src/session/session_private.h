// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/session.h"

#include <QTimer>

#include "link/robot_server.h"
#include "link/stranger_watch.h"
#include "link/telemetry_socket.h"
#include "session/agv_line.h"
#include "session/event_log.h"
#include "session/run_recorder.h"
#include "session/run_tee.h"
#include "session/uwb_line.h"
#include "session/wall_clock.h"

#include <map>
#include <string>
#include <vector>

namespace agv::session {

class AlarmDesk;
class JogDesk;

/// Inside of Session: the links of the plant and how they are wired (session.cpp); what is asked of the
/// session is carried out in session_requests.cpp.
class Session::Private {
public:
    Private(Session& owner, PlantLayout layout, SessionOptions sessionOptions);

    void addLine(const AgvConfig& config);
    void wireServer();
    void addUwb();
    void listen();
    void listenFailed(const std::string& trouble);
    void refuse(const QString& address, const char* what);
    void publish();
    AgvLine* line(int robot);
    void logEvent(const EventEntry& entry);
    void log(EventLevel level, const std::string& text)
    {
        events.add(level, "Console", text, monotonicNow());
    }

    Session& q;
    PlantLayout plant;
    SessionOptions options;
    EventLog events;
    RunRecorder* recorder; ///< owned (QObject child of the session), as all below
    RunTee* tee;
    link::RobotServer* server;
    link::TelemetrySocket* telemetry;
    AlarmDesk* alarms;
    QTimer* frameTimer;
    QTimer* listenTimer;
    link::StrangerWatch telemetryStrangers;
    UwbLine* uwb = nullptr;   ///< null without anchors
    bool isUwbWanted = false; ///< open, or to be opened with the first anchors
    JogDesk* jogDesk;
    std::map<int, AgvLine*> lines;
    std::vector<std::string> refusedPeers;
    std::string listening = "Not listening yet";
    bool changed = true;
    Time published;
};

} // namespace agv::session
