// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "core/snapshot.h"
#include "procedure/initialisation_turn.h"
#include "protocol/robot_messages.h"
#include "session/solve_worker.h"

#include <memory>
#include <optional>

namespace agv::session {

class RobotLink;

/// Carries an initialisation turn out: gives it the time, sends its commands, runs its solvers. Lives in the
/// session thread. A finished turn stays, for its result and for retakes, until the next one starts.
class TurnRunner : public QObject {
    Q_OBJECT
public:
    TurnRunner(RobotLink& robot, SolveFunction solve, SolveMethod method, QObject* parent);

    /// @pre !isActive() and validate(parameters)
    void start(const TurnParameters& parameters);
    void retake(int stop);
    void abort(const std::string& reason);
    void onTagRead(const TagRead& read);
    void onSegmentDone(std::uint32_t number);
    void onRobotState(RobotState state);
    void onRobotLost(const std::string& reason);
    void onReaderLost(const std::string& reason);

    bool isActive() const { return m_turn && m_turn->isActive(); }
    bool canRetake() const { return m_turn && m_turn->phase() == TurnPhase::Finished; }
    TurnSnapshot snapshot(Time now) const;

signals:
    void phaseChanged(agv::TurnPhase phase, int stop, agv::Time time); ///< stop: 1-based
    void message(agv::EventLevel level, const QString& text);
    /// Finished, Aborted or Failed; `turn.result` is set when it was solved.
    void ended(const agv::TurnSnapshot& turn, std::shared_ptr<const agv::TurnRecord> record);

private:
    void perform(const procedure::TurnActions& actions);
    void drive(const protocol::RobotCommand& command);
    void solvePreview();
    void takePreview(const std::shared_ptr<const TurnEstimate>& estimate, int steps);
    void cancelSolvers();
    void solveResult();
    void takeResult(const std::shared_ptr<const TurnEstimate>& estimate);
    void afterEvent();
    void armTimer();

    RobotLink& m_robot;
    SolveMethod m_method;
    SolveWorker* m_worker;
    QTimer* m_timer;
    std::optional<procedure::InitialisationTurn> m_turn;
    TurnPhase m_reportedPhase = TurnPhase::Idle;
    int m_reportedStop = 0;
    bool m_robotUnreachable = false;
    bool m_previewRuns = false;
    bool m_previewIsOld = false; ///< stops were read since it began
    std::shared_ptr<const TurnEstimate> m_preview;
    std::shared_ptr<const TurnEstimate> m_result;
};

} // namespace agv::session
