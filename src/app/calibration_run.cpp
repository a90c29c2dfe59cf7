// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/calibration_run.h"

#include <charconv>
#include <string_view>
#include <utility>

namespace agv::app {
namespace {

constexpr std::chrono::seconds truthTimeout(5);
constexpr std::chrono::seconds stateTimeout(2);

const AgvSnapshot* find(const PlantSnapshot& snapshot, RobotId id)
{
    for (const AgvSnapshot& agv : snapshot.agvs) {
        if (agv.id == id)
            return &agv;
    }
    return nullptr;
}

std::string linkTrouble(const AgvSnapshot& agv)
{
    std::string trouble;
    for (const LinkSnapshot* link : {&agv.robotLink, &agv.readerLink}) {
        const bool connected = link->state == LinkState::Up || link->state == LinkState::Silent;
        if (!connected)
            trouble += (trouble.empty() ? "" : ". ") + link->name +
                       " is not connected: " + (link->reason.empty() ? "no answer yet" : link->reason);
    }
    return trouble;
}

} // namespace

TurnParameters parametersFor(const AgvConfig& agv, const CalibrateArguments& arguments)
{
    TurnParameters parameters = arguments.turn;
    if (!arguments.speedGiven)
        parameters.wheelSpeed_m_s = agv.turnSpeed_m_s;
    if (!arguments.turnTimeGiven)
        parameters.turnTime_s = agv.turnTime_s * agv.turnSpeed_m_s / parameters.wheelSpeed_m_s;
    return parameters;
}

CalibrationRun::CalibrationRun(session::Session& session, SimulatedPlant* simulated,
                               std::vector<AgvConfig> agvs, const CalibrateArguments& arguments,
                               ProgressLine& progress)
    : m_session(session),
      m_simulated(simulated),
      m_agvs(std::move(agvs)),
      m_arguments(arguments),
      m_progress(progress)
{
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &CalibrationRun::onTimeout);
    connect(&session, &session::Session::snapshotReady, this, &CalibrationRun::onSnapshot);
    connect(&session, &session::Session::readerBytes, this, &CalibrationRun::onBytes);
    connect(&session, &session::Session::turnPhaseChanged, this, &CalibrationRun::onPhase);
    connect(&session, &session::Session::turnEnded, this,
            [this](int robot, const TurnSnapshot& turn) { onTurnEnded(robot, turn); });
    connect(&session, &session::Session::turnRefused, this, [this](int robot, const QString& reason) {
        if (m_step != Step::Turn || robot != m_current.robot)
            return;
        m_current.problem = "The turn was not started: " + reason.toStdString();
        conclude();
    });
    if (simulated)
        connect(simulated, &SimulatedPlant::truthKnown, this, [this] {
            if (m_step == Step::Truth)
                conclude();
        });
}

void CalibrationRun::start()
{
    m_index = 0;
    next();
}

void CalibrationRun::next()
{
    if (m_index == m_agvs.size()) {
        m_step = Step::Done;
        m_timer.stop();
        emit finished();
        return;
    }
    m_current = {};
    m_current.robot = agv().id.number;
    m_current.label = "AGV " + std::to_string(m_current.robot);
    m_captureLines.clear();
    m_capture.reset();
    m_parameters = parametersFor(agv(), m_arguments);
    m_current.turnTime_s = m_parameters.turnTime_s;
    m_step = Step::Links;
    m_linkTrouble = "no answer yet";
    m_linkedSince.reset();
    m_timer.start(linkTimeout);
    QMetaObject::invokeMethod(&m_session, [&s = m_session, robot = m_current.robot] { s.openReader(robot); });
}

void CalibrationRun::onSnapshot(const PlantSnapshot& snapshot)
{
    const AgvSnapshot* now = m_step == Step::Done ? nullptr : find(snapshot, agv().id);
    if (!now)
        return;
    if (m_step == Step::Turn) {
        m_progress.show(m_current.label, now->turn);
        return;
    }
    if (m_step != Step::Links)
        return;
    m_linkTrouble = linkTrouble(*now);
    if (!m_linkTrouble.empty()) {
        m_linkedSince.reset();
        return;
    }
    // A docked robot must be known before it is turned; one that does not report its state is not waited for.
    if (!m_linkedSince)
        m_linkedSince = snapshot.time;
    if (now->robotState || snapshot.time - *m_linkedSince >= stateTimeout)
        beginTurn();
}

void CalibrationRun::beginTurn()
{
    m_step = Step::Turn;
    const std::chrono::duration<double> longest(
        (m_parameters.turnTime_s + m_parameters.settle_s + m_parameters.maxDwell_s) *
            (m_parameters.stopsPerTurn + 1) * 3.0 +
        60.0);
    m_timer.start(std::chrono::duration_cast<std::chrono::milliseconds>(longest));
    QMetaObject::invokeMethod(
        &m_session, [&s = m_session, robot = m_current.robot, p = m_parameters] { s.startTurn(robot, p); });
}

void CalibrationRun::takeCaptureLine(std::string_view text)
{
    double at_ms = std::chrono::duration<double, std::milli>(m_markTime - m_captureBegin).count();
    if (text.starts_with('@'))
        std::from_chars(text.data() + 1, text.data() + text.size(), at_ms);
    m_captureLines.emplace(at_ms, std::string(text));
}

std::string CalibrationRun::captureText() const
{
    std::string text;
    for (const auto& [time, line] : m_captureLines)
        text += line;
    return text;
}

void CalibrationRun::onBytes(int robot, const QByteArray& bytes, Time time)
{
    if (m_capture && robot == m_current.robot)
        m_capture->bytes({bytes.constData(), static_cast<std::size_t>(bytes.size())}, time);
}

void CalibrationRun::onPhase(int robot, TurnPhase phase, int stop, Time time)
{
    if (m_step != Step::Turn || robot != m_current.robot)
        return;
    if (!m_capture) {
        m_captureBegin = m_markTime = time;
        m_capture.emplace([this](std::string_view text) { takeCaptureLine(text); }, time);
        m_capture->turn(m_parameters, time);
    }
    m_markTime = time;
    switch (phase) {
    case TurnPhase::Reading:
        m_capture->stop(stop, time);
        break;
    case TurnPhase::Turning:
        m_capture->moving(time);
        break;
    case TurnPhase::Solving:
        // What ends later was not heard by the solver either.
        m_capture->end(time);
        m_current.capture = captureText();
        break;
    case TurnPhase::Aborted:
    case TurnPhase::Failed:
        if (m_current.capture.empty()) {
            m_capture->aborted(time);
            m_current.capture = captureText();
        }
        break;
    case TurnPhase::Idle:
    case TurnPhase::Settling:
    case TurnPhase::Finished:
        break;
    }
}

void CalibrationRun::onTurnEnded(int robot, const TurnSnapshot& turn)
{
    if (m_step != Step::Turn || robot != m_current.robot)
        return;
    m_current.turn = turn;
    if (turn.phase != TurnPhase::Finished)
        m_current.problem = turn.message;
    m_step = Step::Truth;
    if (!m_simulated)
        return conclude();
    m_timer.start(truthTimeout);
    m_simulated->requestTruth();
}

void CalibrationRun::onTimeout()
{
    switch (m_step) {
    case Step::Links:
        m_current.problem = m_linkTrouble;
        break;
    case Step::Turn:
        m_current.problem = "the turn did not come to an end";
        QMetaObject::invokeMethod(&m_session, [&s = m_session] { s.stopAll("The turn took too long"); });
        break;
    case Step::Truth:
    case Step::Done:
        break;
    }
    conclude();
}

void CalibrationRun::giveUp(const std::string& problem)
{
    if (m_step == Step::Done)
        return;
    m_current.problem = problem;
    m_index = m_agvs.size() - 1;
    conclude();
}

void CalibrationRun::conclude()
{
    m_timer.stop();
    m_progress.finish();
    if (m_simulated)
        m_current.truth = m_simulated->truth(m_current.robot);
    QMetaObject::invokeMethod(&m_session,
                              [&s = m_session, robot = m_current.robot] { s.closeReader(robot); });
    m_step = Step::Done;
    m_outcomes.push_back(std::exchange(m_current, {}));
    emit outcomeKnown(m_outcomes.back());
    ++m_index;
    next();
}

} // namespace agv::app
