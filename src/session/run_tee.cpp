// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/run_tee.h"

#include "session/agv_line.h"
#include "session/robot_link.h"
#include "session/standing_pose.h"
#include "session/uwb_line.h"
#include "session/wall_clock.h"

#include <algorithm>
#include <utility>

namespace agv::session {
namespace {

constexpr Duration poseEvery = std::chrono::milliseconds(100);

bool isSame(const recording::PoseRow& one, const recording::PoseRow& other)
{
    return one.pose == other.pose && one.covariance == other.covariance && one.health == other.health;
}

} // namespace

RunTee::RunTee(RunRecorder& recorder, QObject* parent) : QObject(parent), m_recorder(recorder)
{
    // A pose that does not change is wanted once in each run.
    connect(&recorder, &RunRecorder::began, this, [this] { m_poses.clear(); });
}

void RunTee::watch(link::RobotServer& server, link::TelemetrySocket& telemetry)
{
    connect(&server, &link::RobotServer::robotReceived, this, [this](int robot, const link::Chunk& chunk) {
        m_recorder.chunk("robot " + std::to_string(robot), chunk);
    });
    connect(&telemetry, &link::TelemetrySocket::received, this,
            [this, &server](const QHostAddress& sender, const link::Chunk& datagram) {
                if (const std::optional<int> robot = server.robotAt(sender))
                    m_recorder.chunk("telemetry " + std::to_string(*robot), datagram);
            });
}

void RunTee::watch(int robot, AgvLine& line)
{
    const RobotId agv{robot};
    const std::string number = std::to_string(robot);
    connect(&line, &AgvLine::bytesReceived, this,
            [this, link = "reader " + number](const link::Chunk& chunk) { m_recorder.chunk(link, chunk); });
    connect(&line, &AgvLine::tagRead, this,
            [this, agv](const TagRead& read) { m_recorder.row(recording::TagReadRow{agv, read}); });
    connect(&line, &AgvLine::turnPhaseChanged, this, [this, agv](TurnPhase phase, int stop, Time time) {
        m_recorder.row(recording::TurnStepRow{time, agv, phase, stop});
    });
    connect(&line, &AgvLine::turnRefused, this, &RunTee::endTurn);
    connect(&line, &AgvLine::turnEnded, this,
            [this, robot](const TurnSnapshot& turn) { takeTurn(robot, turn); });
    RobotLink& link = line.robot();
    connect(&link, &RobotLink::bytesSent, this,
            [this, name = "robot " + number + " sent"](const link::Chunk& chunk) {
                m_recorder.chunk(name, chunk);
            });
    connect(&link, &RobotLink::speedsChanged, this, [this, agv](const WheelSpeeds& speeds) {
        m_recorder.row(recording::WheelCommandRow{monotonicNow(), agv, speeds});
    });
    connect(&link, &RobotLink::stateReported, this, [this, agv](RobotState state) {
        m_recorder.row(recording::RobotStateRow{monotonicNow(), agv, state});
    });
    connect(&link, &RobotLink::batteryReported, this, [this, agv](const BatteryStatus& battery) {
        m_recorder.row(recording::BatteryRow{monotonicNow(), agv, battery});
    });
}

void RunTee::watch(UwbLine& line)
{
    connect(&line, &UwbLine::bytesReceived, this,
            [this](const link::Chunk& chunk) { m_recorder.chunk("uwb", chunk); });
    connect(&line.link(), &UwbLink::bytesSent, this,
            [this](const link::Chunk& chunk) { m_recorder.chunk("uwb sent", chunk); });
    connect(&line.link(), &UwbLink::tagMeasured, this, &RunTee::takeRanges);
}

void RunTee::takeRanges(const protocol::RangeSet& ranges, const UwbTagTrack& track, Time arrival)
{
    if (!m_recorder.isListening())
        return;
    for (const RangeMeasurement& range : ranges) {
        recording::RangeRow row{arrival, range, {}, false};
        const auto shown = std::ranges::find(track.shown(), range.anchor, &UwbRangeSnapshot::anchor);
        if (shown != track.shown().end()) {
            row.residual_m = shown->residual_m;
            row.rejected = shown->rejected;
        }
        m_recorder.row(std::move(row));
    }
    if (const std::optional<Point2> position = track.position())
        m_recorder.row(recording::TagPositionRow{arrival, track.measured_s(), track.tag().id, *position,
                                                 track.covariance()});
}

void RunTee::takeTurn(int robot, const TurnSnapshot& turn)
{
    recording::TurnResultRow row{monotonicNow(), RobotId{robot}, turn.phase, {}, {}, turn.message};
    if (turn.result && row.note.empty())
        row.note = turn.result->status;
    if (turn.result && turn.result->valid) {
        row.pose = turn.result->pose;
        row.covariance = covarianceOfPose(*turn.result);
    }
    m_recorder.row(std::move(row));
    endTurn();
}

void RunTee::beginTurn()
{
    if (!m_recorder.options().everyTurn || m_recorder.isRunning())
        return;
    m_isOfTurn = true;
    m_recorder.start("turn", {});
}

void RunTee::endTurn()
{
    if (std::exchange(m_isOfTurn, false))
        m_recorder.stop();
}

void RunTee::snapshot(const PlantSnapshot& snapshot)
{
    if (!m_recorder.isListening())
        return;
    for (const AgvSnapshot& agv : snapshot.agvs) {
        if (!agv.pose)
            continue;
        recording::PoseRow row{snapshot.time, agv.id, *agv.pose, agv.covariance, agv.poseHealth};
        const auto last = m_poses.find(agv.id.number);
        if (last != m_poses.end() && (row.time - last->second.time < poseEvery || isSame(row, last->second)))
            continue;
        m_poses[agv.id.number] = row;
        m_recorder.row(row);
    }
}

void RunTee::event(const EventEntry& entry) { m_recorder.row(recording::EventRow{monotonicNow(), entry}); }

void RunTee::action(const char* name, std::optional<int> robot, const std::string& detail)
{
    m_recorder.row(recording::OperatorActionRow{
        monotonicNow(), name, robot ? std::optional(RobotId{*robot}) : std::nullopt, detail});
}

} // namespace agv::session
