// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/jog_runner.h"

#include "session/jog_text.h"
#include "session/robot_link.h"
#include "session/wall_clock.h"

#include <algorithm>
#include <utility>

namespace agv::session {

using procedure::JogAction;

JogRunner::JogRunner(RobotLink& robot, double limit_m_s, std::function<bool()> isTurning, QObject* parent)
    : QObject(parent),
      m_robot(robot),
      m_limit_m_s(std::min({limit_m_s, mostJogSpeed_m_s, protocol::maxWheelSpeed_m_s})),
      m_isTurning(std::move(isTurning)),
      m_timer(new QTimer(this))
{
    m_timer->setSingleShot(true);
    m_timer->setTimerType(Qt::PreciseTimer);
    connect(m_timer, &QTimer::timeout, this, &JogRunner::onTimer);
}

JogReason JogRunner::obstacle(Time now) const
{
    if (!m_robot.isConnected())
        return JogReason::NotConnected;
    if (m_isTurning())
        return JogReason::TurnRuns;
    if (m_robot.state() == RobotState::Error)
        return JogReason::RobotError;
    if (m_robot.drivesItself())
        return JogReason::DrivesItself;
    if (m_robot.state() == RobotState::StationDocked)
        return JogReason::Docked;
    if (m_robot.unconfirmedFor(now) >= m_deadMan.longestSilence())
        return JogReason::LinkOld;
    return JogReason::None;
}

JogCommand JogRunner::limited(const JogCommand& command) const
{
    JogCommand slow = command;
    slow.speeds = slowedTo(command.speeds, m_limit_m_s);
    return slow;
}

void JogRunner::press(const JogCommand& command)
{
    const Time now = monotonicNow();
    const bool drove = isDriving();
    perform(m_deadMan.press(limited(command), obstacle(now), now));
    reportPress(drove);
}

void JogRunner::hold(const JogCommand& command) { perform(m_deadMan.hold(limited(command), monotonicNow())); }

void JogRunner::release(const JogCommand& command, JogReason why)
{
    perform(m_deadMan.release(command, why));
    emit changed();
}

void JogRunner::obstruct(JogReason why) { perform(m_deadMan.obstruct(why)); }

void JogRunner::latch()
{
    m_deadMan.stopAll();
    m_note.clear();
    armTimer();
    emit changed();
}

void JogRunner::releaseLatch()
{
    m_deadMan.releaseLatch();
    m_note.clear();
    emit changed();
}

void JogRunner::onRobotState()
{
    if (!isDriving())
        return;
    const JogReason why = obstacle(monotonicNow());
    if (why != JogReason::None)
        obstruct(why);
}

void JogRunner::onTimer()
{
    const Time now = monotonicNow();
    // A robot that hears nothing is told zero, should it hear again, and no more commands pile up for it.
    if (isDriving() && m_robot.unconfirmedFor(now) >= m_deadMan.longestSilence())
        return obstruct(JogReason::LinkOld);
    perform(m_deadMan.onTimer(now));
}

void JogRunner::perform(JogAction action)
{
    if (action == JogAction::Drive && !m_robot.send(protocol::DirectDrive{m_deadMan.speeds()}))
        action = m_deadMan.obstruct(JogReason::LinkLost);
    if (action == JogAction::Stop) {
        m_robot.stop();
        reportEnd();
    }
    armTimer();
}

void JogRunner::reportPress(bool drove)
{
    const JogReason why = m_deadMan.reason();
    if (isDriving() && why == JogReason::None) {
        m_note.clear();
        if (!drove)
            emit message(EventLevel::Detail, m_deadMan.source() == JogSource::Keys
                                                 ? QStringLiteral("Driven by hand, with the keys")
                                                 : QStringLiteral("Driven by hand, with the pad"));
    } else if (!drove || isDriving()) {
        m_note = "It does not drive: " + sentenceOf(why);
        emit message(EventLevel::Info, QString::fromStdString(m_note));
    }
    emit changed();
}

void JogRunner::reportEnd()
{
    const JogReason why = m_deadMan.reason();
    m_note = isOrdinary(why) ? std::string() : "Stopped: " + sentenceOf(why);
    emit message(isOrdinary(why) ? EventLevel::Detail : EventLevel::Warning,
                 QStringLiteral("Driving by hand ended: %1").arg(QString::fromStdString(sentenceOf(why))));
    emit changed();
}

void JogRunner::order(DockOrder order)
{
    JogReason why = m_deadMan.state() == JogState::Latched ? JogReason::StopAll : obstacle(monotonicNow());
    if (why == JogReason::None && isDriving())
        why = JogReason::HandHolds;
    if (why == JogReason::Docked && order == DockOrder::Undock)
        why = JogReason::None;
    const protocol::RobotCommand commands[] = {protocol::Dock{}, protocol::Undock{}, protocol::DockDemo{}};
    if (why == JogReason::None && !m_robot.send(commands[static_cast<std::size_t>(order)]))
        why = JogReason::LinkLost;
    if (why == JogReason::None) {
        m_note.clear();
        emit message(EventLevel::Info,
                     QStringLiteral("It was told to %1").arg(QString::fromStdString(nameOf(order))));
    } else {
        m_note = "It does not " + nameOf(order) + ": " + sentenceOf(why);
        emit message(EventLevel::Warning, QString::fromStdString(m_note));
    }
    emit changed();
}

void JogRunner::armTimer()
{
    const std::optional<Time> deadline = m_deadMan.deadline();
    if (!deadline) {
        m_timer->stop();
        return;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(*deadline - monotonicNow());
    m_timer->start(std::max(left, std::chrono::milliseconds(0)));
}

JogSnapshot JogRunner::snapshot(Time now) const
{
    JogSnapshot snapshot;
    snapshot.state = m_deadMan.state();
    snapshot.note = m_note;
    const JogReason why = snapshot.state == JogState::Latched ? JogReason::StopAll : obstacle(now);
    snapshot.obstacle = sentenceOf(why);
    return snapshot;
}

} // namespace agv::session
