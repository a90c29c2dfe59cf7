// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/agv_line.h"

#include "procedure/turn_parameters.h"
#include "session/jog_runner.h"
#include "session/reader_link.h"
#include "session/robot_link.h"
#include "session/standing_pose.h"
#include "session/turn_runner.h"
#include "session/wall_clock.h"

#include <utility>

namespace agv::session {

AgvLine::AgvLine(const AgvConfig& config, const PlantLayout& plant, link::RobotServer& server,
                 SolveFunction solve, SolveMethod method, EventLog& events, QObject* parent)
    : QObject(parent),
      m_config(config),
      m_label("AGV " + std::to_string(config.id.number)),
      m_events(events),
      m_reader(new ReaderLink(config.id.number, config.reader, this)),
      m_robot(new RobotLink(config.id.number, server, this)),
      m_turn(new TurnRunner(*m_robot, std::move(solve), method, this)),
      m_jog(new JogRunner(
          *m_robot, config.maxSpeed_m_s, [this] { return m_turn->isActive(); }, this)),
      m_turnTime_s(config.turnTime_s),
      m_turnSpeed_m_s(config.turnSpeed_m_s),
      m_tracker(plant, config)
{
    wireReader();
    wireRobot();
    wireTurn();
    connect(m_jog, &JogRunner::message, this,
            [this](EventLevel level, const QString& text) { log(level, text.toStdString()); });
    connect(m_jog, &JogRunner::changed, this, &AgvLine::changed);
}

void AgvLine::wireReader()
{
    connect(m_reader, &ReaderLink::tagRead, this, [this](const TagRead& read) {
        m_turn->onTagRead(read);
        m_tracker.read(read);
        emit tagRead(read);
        emit changed();
    });
    connect(m_reader, &ReaderLink::bytesReceived, this, &AgvLine::bytesReceived);
    connect(m_reader, &ReaderLink::stateChanged, this, &AgvLine::logReader);
    connect(m_reader, &ReaderLink::lost, this,
            [this](const QString& reason) { m_turn->onReaderLost(reason.toStdString()); });
}

void AgvLine::wireRobot()
{
    connect(m_robot, &RobotLink::segmentDone, this,
            [this](quint32 number) { m_turn->onSegmentDone(number); });
    connect(m_robot, &RobotLink::stateReported, this, &AgvLine::onRobotState);
    connect(m_robot, &RobotLink::speedsChanged, this,
            [this](const WheelSpeeds& speeds) { m_tracker.wheels(speeds, monotonicNow()); });
    connect(m_robot, &RobotLink::message, this,
            [this](EventLevel level, const QString& text) { log(level, text.toStdString()); });
}

void AgvLine::onRobotState(RobotState state)
{
    m_turn->onRobotState(state);
    m_jog->onRobotState();
    const bool drivesByItself = state == RobotState::StationDocking ||
                                state == RobotState::StationUndocking || state == RobotState::DemoDocking;
    if (drivesByItself)
        m_tracker.doubt("It drove by itself to dock or undock: calibrate it again");
    emit changed();
}

void AgvLine::wireTurn()
{
    connect(m_turn, &TurnRunner::message, this,
            [this](EventLevel level, const QString& text) { log(level, text.toStdString()); });
    connect(m_turn, &TurnRunner::phaseChanged, this, [this](TurnPhase phase, int stop, Time time) {
        emit turnPhaseChanged(phase, stop, time);
        emit changed();
    });
    connect(m_turn, &TurnRunner::ended, this,
            [this](const TurnSnapshot& turn, const std::shared_ptr<const TurnRecord>& record) {
                takePose(turn);
                emit turnEnded(turn, record);
                emit changed();
            });
}

void AgvLine::openReader()
{
    m_readerTroubles.clear();
    m_reader->open();
}

void AgvLine::closeReader() { m_reader->close(); }

void AgvLine::setReaderEndpoint(const Endpoint& reader)
{
    m_reader->setEndpoint(reader);
    emit changed();
}

std::string AgvLine::whyNoTurn() const
{
    if (m_turn->isActive())
        return "a turn is running";
    if (!m_robot->isConnected())
        return "the robot is not connected";
    if (!m_reader->isConnected())
        return "the RFID reader is not connected";
    if (m_jog->isDriving())
        return "it is driven by hand: let go first";
    if (m_robot->state() == RobotState::StationDocked)
        return "the robot is docked: undock it first";
    if (m_robot->state() == RobotState::Error)
        return "the robot is in error: look at the robot, then switch it off and on";
    return {};
}

void AgvLine::startTurn(const TurnParameters& parameters)
{
    std::string reason = whyNoTurn();
    if (const Result<void> valid = procedure::validate(parameters); reason.empty() && !valid)
        reason = valid.error().detail;
    if (!reason.empty()) {
        log(EventLevel::Warning, "The initialisation turn was not started: " + reason);
        emit turnRefused(QString::fromStdString(reason));
        return;
    }
    if (parameters.kind == TurnKind::Timed)
        m_turnTime_s = parameters.turnTime_s;
    m_turnSpeed_m_s = parameters.wheelSpeed_m_s;
    log(EventLevel::Info, "Initialisation turn started");
    m_turn->start(parameters);
}

void AgvLine::abortTurn(const std::string& reason) { m_turn->abort(reason); }

void AgvLine::retakeStop(int stop)
{
    std::string reason = whyNoTurn();
    if (reason.empty() && !m_turn->canRetake())
        reason = "there is no finished turn";
    if (!reason.empty()) {
        log(EventLevel::Warning, "Stop " + std::to_string(stop + 1) + " is not read again: " + reason);
        return;
    }
    m_turn->retake(stop);
}

void AgvLine::setTurnTime(double seconds)
{
    TurnParameters parameters;
    parameters.turnTime_s = seconds;
    if (const Result<void> valid = procedure::validate(parameters); !valid) {
        log(EventLevel::Warning, "The sleeptime was not changed: " + valid.error().detail);
        return;
    }
    m_turnTime_s = seconds;
    emit changed();
}

void AgvLine::setTurnSpeed(double metresPerSecond)
{
    TurnParameters parameters;
    parameters.wheelSpeed_m_s = metresPerSecond;
    if (const Result<void> valid = procedure::validate(parameters); !valid) {
        log(EventLevel::Warning, "The wheel speed was not changed: " + valid.error().detail);
        return;
    }
    m_turnSpeed_m_s = metresPerSecond;
    emit changed();
}

void AgvLine::stopAll(const std::string& reason)
{
    m_jog->latch();
    m_turn->abort(reason);
    m_robot->stop();
    emit changed();
}

void AgvLine::stopByHand()
{
    m_turn->abort("Stop was pressed");
    if (m_jog->isDriving())
        m_jog->obstruct(JogReason::StoppedHere);
    else
        m_robot->stop();
    log(EventLevel::Warning, "It was told to stop");
    emit changed();
}

void AgvLine::stopNow(const std::string& reason)
{
    m_jog->latch();
    m_turn->abort(reason);
    m_robot->stopNow();
}

void AgvLine::onRobotConnected(const QString& peer, bool replaced)
{
    if (replaced) {
        log(EventLevel::Warning, "The robot connected a second time from " + peer.toStdString() +
                                     "; its older connection was closed");
        m_turn->onRobotLost("the robot connected anew, it may have restarted");
        m_jog->obstruct(JogReason::LinkLost);
    } else {
        log(EventLevel::Info, "The robot connected from " + peer.toStdString());
    }
    m_robot->onConnected(peer);
    emit changed();
}

void AgvLine::onRobotLost(const QString& reason)
{
    const bool turnSaysIt = m_turn->isActive(); // it ends with this reason
    m_robot->onLost(reason);
    m_jog->obstruct(JogReason::LinkLost);
    if (m_robot->mayBeMoving())
        m_tracker.doubt("The link to the robot was lost while it drove: calibrate it again");
    m_turn->onRobotLost(reason.toStdString());
    if (m_robot->mayBeMoving())
        log(EventLevel::Error, "THE ROBOT MAY STILL BE MOVING: its link was lost while it drove. Use its own "
                               "switch. (" +
                                   reason.toStdString() + ")");
    else if (!turnSaysIt)
        log(EventLevel::Warning, "The link to the robot was lost: " + reason.toStdString());
    emit changed();
}

void AgvLine::takePose(const TurnSnapshot& turn)
{
    if (turn.phase != TurnPhase::Finished || !turn.result || !turn.result->valid)
        return;
    m_tracker.start(turn.result->pose, covarianceOfPose(*turn.result), monotonicNow());
}

/// A turn that runs moves the AGV anyhow, and ends with a new pose.
void AgvLine::logHealth(const TrackedPose& tracked)
{
    if (m_turn->isActive() || tracked.health == m_loggedHealth)
        return;
    m_loggedHealth = tracked.health;
    if (tracked.health == PoseHealth::Doubted)
        log(EventLevel::Warning, "Its pose is doubted. " + tracked.note);
}

void AgvLine::logReader(LinkState state, const QString& reason)
{
    const std::string source = "RFID reader " + std::to_string(m_config.id.number);
    const Time now = monotonicNow();
    switch (state) {
    case LinkState::Up:
        m_readerTroubles.clear();
        m_events.add(EventLevel::Info, source, "Connected", now);
        break;
    case LinkState::Down:
        m_readerTroubles.clear();
        m_events.add(EventLevel::Info, source, "Closed", now);
        break;
    case LinkState::Failed:
        m_events.add(EventLevel::Error, source, reason.toStdString(), now);
        break;
    case LinkState::Silent:
    case LinkState::Waiting:
        if (m_readerTroubles.insert(reason.toStdString()).second)
            m_events.add(EventLevel::Warning, source, reason.toStdString(), now);
        break;
    case LinkState::Opening:
        break;
    }
    emit changed();
}

void AgvLine::log(EventLevel level, const std::string& text)
{
    m_events.add(level, m_label, text, monotonicNow());
}

AgvSnapshot AgvLine::snapshot(Time now)
{
    AgvSnapshot snapshot;
    snapshot.id = m_config.id;
    snapshot.name = m_config.name.empty() ? m_label : m_config.name;
    snapshot.readerLink = m_reader->snapshot(now);
    snapshot.robotLink = m_robot->snapshot(now);
    snapshot.battery = m_robot->battery();
    snapshot.robotState = m_robot->state();
    snapshot.commanded = m_robot->commanded();
    snapshot.mayBeMoving = m_robot->mayBeMoving();
    snapshot.jog = m_jog->snapshot(now);
    snapshot.turnTime_s = m_turnTime_s;
    snapshot.turnSpeed_m_s = m_turnSpeed_m_s;
    const TrackedPose tracked = m_tracker.pose(now);
    if (tracked.health != PoseHealth::None)
        snapshot.pose = tracked.pose;
    snapshot.covariance = tracked.covariance;
    snapshot.poseHealth = tracked.health;
    snapshot.poseNote = tracked.note;
    logHealth(tracked);
    snapshot.recentReads = m_reader->recentReads(now);
    snapshot.turn = m_turn->snapshot(now);
    return snapshot;
}

} // namespace agv::session
