// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/turn_runner.h"

#include "session/robot_link.h"
#include "session/standing_pose.h"
#include "session/wall_clock.h"

#include <algorithm>
#include <utility>

namespace agv::session {
namespace {

template<typename... Visitors>
struct Overloaded : Visitors... {
    using Visitors::operator()...;
};
template<typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

} // namespace

TurnRunner::TurnRunner(RobotLink& robot, SolveFunction solve, SolveMethod method, QObject* parent)
    : QObject(parent),
      m_robot(robot),
      m_method(method),
      m_worker(new SolveWorker(std::move(solve), this)),
      m_timer(new QTimer(this))
{
    m_timer->setSingleShot(true);
    m_timer->setTimerType(Qt::PreciseTimer);
    connect(m_timer, &QTimer::timeout, this, [this] {
        if (m_turn)
            perform(m_turn->onTimer(monotonicNow()));
    });
}

void TurnRunner::start(const TurnParameters& parameters)
{
    cancelSolvers();
    m_preview.reset();
    m_result.reset();
    m_reportedPhase = TurnPhase::Idle;
    m_reportedStop = 0;
    m_turn.emplace(parameters, m_robot.nextSegment());
    perform(m_turn->start(monotonicNow()));
}

void TurnRunner::retake(int stop)
{
    if (!canRetake())
        return;
    m_result.reset();
    perform(m_turn->retake(stop, monotonicNow()));
}

void TurnRunner::abort(const std::string& reason)
{
    if (m_turn)
        perform(m_turn->abort(monotonicNow(), reason));
}

void TurnRunner::onTagRead(const TagRead& read)
{
    if (m_turn)
        perform(m_turn->onTagRead(read));
}

void TurnRunner::onSegmentDone(std::uint32_t number)
{
    if (m_turn)
        perform(m_turn->onSegmentDone(number, monotonicNow()));
}

void TurnRunner::onRobotState(RobotState state)
{
    if (m_turn)
        perform(m_turn->onRobotState(state, monotonicNow()));
}

void TurnRunner::onRobotLost(const std::string& reason)
{
    if (m_turn)
        perform(m_turn->onRobotLost(monotonicNow(), reason));
}

void TurnRunner::onReaderLost(const std::string& reason)
{
    if (m_turn)
        perform(m_turn->onReaderLost(monotonicNow(), reason));
}

TurnSnapshot TurnRunner::snapshot(Time now) const
{
    if (!m_turn)
        return {};
    TurnSnapshot snapshot = m_turn->snapshot(now);
    snapshot.preview = m_preview;
    snapshot.result = m_result;
    return snapshot;
}

void TurnRunner::perform(const procedure::TurnActions& actions)
{
    for (const procedure::TurnAction& action : actions) {
        std::visit(
            Overloaded{
                [this](const procedure::DriveWheels& a) { drive(protocol::DirectDrive{a.speeds}); },
                [this](const procedure::DriveSegments& a) {
                    drive(protocol::AddSegments{a.firstNumber, a.segments});
                },
                [this](const procedure::InterruptRobot&) { drive(protocol::Interrupt{}); },
                [this](const procedure::SolvePreview&) { solvePreview(); },
                [this](const procedure::SolveResult&) { solveResult(); },
                [this](const procedure::Report& a) { emit message(a.level, QString::fromStdString(a.text)); },
            },
            action);
    }
    afterEvent();
}

void TurnRunner::drive(const protocol::RobotCommand& command)
{
    // A command that cannot be sent ends the turn, from the event loop: not in the middle of its own actions.
    if (m_robot.send(command) || std::exchange(m_robotUnreachable, true))
        return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_robotUnreachable = false;
            onRobotLost("a command could not be sent");
        },
        Qt::QueuedConnection);
}

void TurnRunner::solvePreview()
{
    // One that runs is not cancelled for the next: on a slow computer none would ever be shown.
    if (std::exchange(m_previewRuns, true)) {
        m_previewIsOld = true;
        return;
    }
    m_previewIsOld = false;
    TurnRecord record = m_turn->record();
    const int steps = static_cast<int>(record.stops.size()) - 1;
    m_worker->request(
        std::move(record), SolveMethod::Fast,
        [this, steps](const std::shared_ptr<const TurnEstimate>& estimate) { takePreview(estimate, steps); });
}

void TurnRunner::takePreview(const std::shared_ptr<const TurnEstimate>& estimate, int steps)
{
    m_previewRuns = false;
    if (estimate->valid)
        m_preview = std::make_shared<const TurnEstimate>(standingAt(*estimate, steps));
    if (m_previewIsOld)
        solvePreview();
}

void TurnRunner::cancelSolvers()
{
    m_worker->cancel();
    m_previewRuns = false;
}

void TurnRunner::solveResult()
{
    cancelSolvers();
    m_worker->request(m_turn->record(), m_method,
                      [this](const std::shared_ptr<const TurnEstimate>& estimate) { takeResult(estimate); });
}

void TurnRunner::takeResult(const std::shared_ptr<const TurnEstimate>& estimate)
{
    if (!m_turn || m_turn->phase() != TurnPhase::Solving)
        return;
    m_result = std::make_shared<const TurnEstimate>(standingAt(*estimate, m_turn->standingAt()));
    perform(m_turn->solved(monotonicNow()));
}

void TurnRunner::afterEvent()
{
    armTimer();
    const Time now = monotonicNow();
    const TurnPhase phase = m_turn->phase();
    const int stop = m_turn->currentStop();
    if (phase == m_reportedPhase && stop == m_reportedStop)
        return;
    m_reportedPhase = phase;
    m_reportedStop = stop;
    emit phaseChanged(phase, stop, m_turn->phaseSince());
    if (phase == TurnPhase::Finished || phase == TurnPhase::Aborted || phase == TurnPhase::Failed) {
        cancelSolvers();
        emit ended(snapshot(now), std::make_shared<const TurnRecord>(m_turn->record()));
    }
}

void TurnRunner::armTimer()
{
    const std::optional<Time> deadline = m_turn->deadline();
    if (!deadline) {
        m_timer->stop();
        return;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(*deadline - monotonicNow());
    m_timer->start(std::max(left, std::chrono::milliseconds(0)));
}

} // namespace agv::session
