// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/robot_link.h"

#include "session/wall_clock.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace agv::session {
namespace {

constexpr Duration silentAfter = std::chrono::seconds(5);
/// A robot that vanished before it got a command is lost within this time after it (link/socket_options.h).
constexpr Duration lossKnownAfter = std::chrono::seconds(5);

std::span<const std::uint8_t> bytesOf(const QByteArray& bytes)
{
    return {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())};
}

/// Commands that stop the robot; they overtake others and go out first.
bool stops(const protocol::RobotCommand& command)
{
    const auto* drive = std::get_if<protocol::DirectDrive>(&command);
    return std::holds_alternative<protocol::Interrupt>(command) || (drive && drive->speeds == WheelSpeeds{});
}

bool isDriving(RobotState state)
{
    return state != RobotState::Idle && state != RobotState::StationDocked && state != RobotState::Error;
}

bool isDocking(RobotState state)
{
    return state == RobotState::StationDocking || state == RobotState::StationUndocking ||
           state == RobotState::DemoDocking;
}

const char* nameOf(RobotState state)
{
    switch (state) {
    case RobotState::Idle:
        return "idle";
    case RobotState::SegmentDriving:
        return "driving a segment";
    case RobotState::SegmentWaiting:
        return "waiting for a segment";
    case RobotState::DirectDriving:
        return "driving";
    case RobotState::StationDocking:
        return "docking";
    case RobotState::StationDocked:
        return "docked";
    case RobotState::StationUndocking:
        return "undocking";
    case RobotState::DemoDocking:
        return "docking to charge";
    case RobotState::Error:
        return "in error: look at the robot, then switch it off and on";
    }
    return "in an unknown state";
}

/// Driving and its end follow from the console's own commands and would crowd the log, two lines a stop; what
/// the robot does by itself is news.
EventLevel weightOf(std::optional<RobotState> before, RobotState now)
{
    switch (now) {
    case RobotState::StationDocking:
    case RobotState::StationDocked:
    case RobotState::StationUndocking:
    case RobotState::DemoDocking:
        return EventLevel::Info;
    case RobotState::Error:
        return EventLevel::Error;
    default:
        return before && weightOf(std::nullopt, *before) > EventLevel::Detail ? EventLevel::Info
                                                                              : EventLevel::Detail;
    }
}

} // namespace

RobotLink::RobotLink(int robot, link::RobotServer& server, QObject* parent)
    : QObject(parent),
      m_robot(robot),
      m_server(server),
      m_burstTimer(new QTimer(this))
{
    m_burstTimer->setSingleShot(true);
    m_burstTimer->setTimerType(Qt::PreciseTimer);
    connect(m_burstTimer, &QTimer::timeout, this, &RobotLink::serveBurst);
}

void RobotLink::onConnected(const QString& peer)
{
    m_connected = true;
    m_peer = peer.toStdString();
    m_lossReason.clear();
    m_connectedAt = monotonicNow();
    m_lastData.reset();
    m_state.reset();
    m_toldToDock = false;
    m_stream.reset();
    stop();
}

void RobotLink::onReceived(const link::Chunk& chunk)
{
    m_stream.feed(bytesOf(chunk.bytes),
                  [this, &chunk](const protocol::RobotReport& report) { take(report, chunk.time); });
}

void RobotLink::onDatagram(const link::Chunk& datagram)
{
    const auto report = protocol::decodeReportDatagram(bytesOf(datagram.bytes));
    if (!report) {
        m_datagrams.drop(report.error());
        return;
    }
    ++m_datagrams.good;
    take(*report, datagram.time);
}

void RobotLink::onLost(const QString& reason)
{
    m_connected = false;
    m_lossReason = reason.toStdString();
    m_mayBeMoving = m_commanded != WheelSpeeds{} || drivesItself() ||
                    (m_unconfirmedStop && monotonicNow() - *m_unconfirmedStop < lossKnownAfter);
    m_burst.cancel();
    armBurst();
}

bool RobotLink::send(const protocol::RobotCommand& command)
{
    const Result<protocol::Bytes> bytes = protocol::encodeCommand(command);
    if (!bytes) {
        emit message(EventLevel::Error, QString::fromStdString(bytes.error().detail));
        return false;
    }
    const QByteArray frame(reinterpret_cast<const char*>(bytes->data()),
                           static_cast<qsizetype>(bytes->size()));
    if (!m_server.send(m_robot, frame, stops(command) ? link::Urgency::Urgent : link::Urgency::Ordinary))
        return false;
    emit bytesSent({frame, monotonicNow()});
    if (const auto* drive = std::get_if<protocol::DirectDrive>(&command)) {
        noteSpeeds(drive->speeds);
        if (m_commanded != WheelSpeeds{})
            m_burst.cancel();
    } else if (const auto* segments = std::get_if<protocol::AddSegments>(&command)) {
        noteSpeeds(segments->segments.front().speeds);
        noteSegment(segments->firstNumber + static_cast<std::uint32_t>(segments->segments.size()) - 1);
        m_burst.cancel();
    } else if (std::holds_alternative<protocol::Interrupt>(command)) {
        noteSpeeds({});
        m_toldToDock = false;
    } else {
        m_toldToDock = true;
        m_burst.cancel(); // its zeros would stop the docking
        armBurst();
    }
    return true;
}

bool RobotLink::drivesItself() const { return m_toldToDock || (m_state && isDocking(*m_state)); }

void RobotLink::noteSpeeds(const WheelSpeeds& speeds)
{
    if (speeds != WheelSpeeds{})
        m_unconfirmedStop.reset();
    else if (m_commanded != WheelSpeeds{})
        m_unconfirmedStop = monotonicNow();
    if (std::exchange(m_commanded, speeds) != speeds)
        emit speedsChanged(speeds);
}

void RobotLink::stop()
{
    if (drivesItself())
        send(protocol::Interrupt{});
    if (send(protocol::DirectDrive{}))
        m_mayBeMoving = false;
    m_burst.begin(monotonicNow());
    armBurst();
}

void RobotLink::stopNow()
{
    send(protocol::Interrupt{});
    for (int i = 0; i < procedure::ZeroBurst::repeats; ++i)
        send(protocol::DirectDrive{});
}

void RobotLink::serveBurst()
{
    if (m_burst.onTimer(monotonicNow()))
        send(protocol::DirectDrive{});
    armBurst();
}

void RobotLink::armBurst()
{
    const std::optional<Time> next = m_burst.deadline();
    if (!next) {
        m_burstTimer->stop();
        return;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(*next - monotonicNow());
    m_burstTimer->start(std::max(left, std::chrono::milliseconds(0)));
}

void RobotLink::noteSegment(std::uint32_t number) { m_nextSegment = std::max(m_nextSegment, number + 1); }

void RobotLink::take(const protocol::RobotReport& report, Time now)
{
    m_lastData = now;
    m_rate.add(now);
    if (const auto* sensors = std::get_if<protocol::SensorUpdate>(&report)) {
        m_battery = sensors->battery;
        emit batteryReported(sensors->battery);
    } else if (const auto* update = std::get_if<protocol::StateUpdate>(&report)) {
        const std::optional<RobotState> before = std::exchange(m_state, update->state);
        if (!isDriving(update->state))
            m_unconfirmedStop.reset();
        if (before && *before != update->state && !isDocking(update->state))
            m_toldToDock = false;
        if (before != update->state) {
            emit message(weightOf(before, update->state),
                         QStringLiteral("The robot is %1").arg(QLatin1String(nameOf(update->state))));
        }
        emit stateReported(update->state);
    } else if (const auto* done = std::get_if<protocol::SegmentDone>(&report)) {
        noteSegment(done->number);
        noteSpeeds({});
        m_unconfirmedStop.reset();
        emit segmentDone(done->number);
    } else if (const auto* progress = std::get_if<protocol::SegmentUpdate>(&report)) {
        noteSegment(progress->number);
    } else if (const auto* assertion = std::get_if<protocol::AssertReport>(&report)) {
        emit message(EventLevel::Error, QStringLiteral("The robot's program failed at %1, line %2")
                                            .arg(QString::fromStdString(assertion->file))
                                            .arg(assertion->line));
    } else if (const auto* debug = std::get_if<protocol::DebugReport>(&report)) {
        emit message(EventLevel::Info,
                     QStringLiteral("%1 (%2)").arg(QString::fromStdString(debug->text)).arg(debug->value));
    }
}

LinkSnapshot RobotLink::snapshot(Time now)
{
    LinkSnapshot snapshot;
    snapshot.name = "Robot " + std::to_string(m_robot);
    snapshot.address = m_peer;
    if (m_connected) {
        const bool silent = now - std::max(m_connectedAt, m_lastData.value_or(m_connectedAt)) > silentAfter;
        snapshot.state = silent ? LinkState::Silent : LinkState::Up;
        if (silent)
            snapshot.reason = "Connected, but nothing heard for 5 s";
    } else if (!m_serverTrouble.empty()) {
        snapshot.state = LinkState::Failed;
        snapshot.reason = m_serverTrouble;
    } else {
        snapshot.state = LinkState::Waiting;
        snapshot.reason =
            m_lossReason.empty() ? "Waiting for the robot to connect: switch it on" : m_lossReason;
    }
    snapshot.messagesPerSecond = m_rate.perSecond(now);
    if (m_lastData)
        snapshot.dataAge_s = std::max(0.0, secondsFrom(now - *m_lastData));
    protocol::FrameCounts counts = m_stream.counts();
    counts.good += m_datagrams.good;
    for (std::size_t i = 0; i < counts.dropped.size(); ++i)
        counts.dropped[i] += m_datagrams.dropped[i];
    snapshot.received = counts.good;
    snapshot.dropped = counts.droppedTotal();
    snapshot.dropDetail = dropDetail(counts);
    return snapshot;
}

} // namespace agv::session
