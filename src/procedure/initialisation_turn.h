// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/robot_status.h"
#include "core/snapshot.h"
#include "core/turn.h"
#include "procedure/dwell_rule.h"
#include "procedure/turn_action.h"
#include "procedure/turn_parameters.h"
#include "procedure/turn_plan.h"
#include "procedure/zero_burst.h"

#include <cstdint>
#include <optional>
#include <string>

namespace agv::procedure {

/// The initialisation turn (seed, 7.2) as a pure state machine: no clock, timer or socket. After every call
/// ask deadline() and call onTimer() then; carry the returned actions out in order.
///
/// | state    | event                               | next     | actions                          |
/// |----------|-------------------------------------|----------|----------------------------------|
/// | Idle     | start                               | Settling | zero                             |
/// | Settling | settled at the stop                 | Reading  |                                  |
/// | Settling | settled, more steps to drive        | Turning  | drive                            |
/// | Reading  | dwell over, stops left              | Turning  | preview (from the 3rd stop), drive |
/// | Reading  | dwell over, last stop or retake     | Solving  | zero, solve                      |
/// | Turning  | time over (timed)                   | Settling | zero                             |
/// | Turning  | segmentDone (measured)              | Settling |                                  |
/// | Turning  | segmentDone overdue (measured)      | Failed   | interrupt, zero                  |
/// | Solving  | solved                              | Finished |                                  |
/// | Solving  | no answer in time                   | Failed   | zero                             |
/// | Finished | retake, robot at the stop           | Settling | zero                             |
/// | Finished | retake, robot elsewhere             | Turning  | drive                            |
/// | active   | abort                               | Aborted  | interrupt (measured), zero       |
/// | active   | robot or reader lost, robot in Error or docking, half a turn without a read | Failed | same |
/// | Turning  | robot reports that it drove and is idle | Failed | same                         |
/// | not active | abort                             | same     | zero                             |
///
/// "zero" is said five times, 50 ms apart (ZeroBurst); the object must live and its deadlines be served until
/// deadline() is empty. After the last drive of a turn no speed other than zero is ever emitted.
class InitialisationTurn {
public:
    /// @pre validate(parameters). `firstSegment`: number of the first segment of a measured turn; a robot
    /// takes it as a fatal error when a number that is done comes again, so start where the last turn
    /// stopped.
    explicit InitialisationTurn(TurnParameters parameters, std::uint32_t firstSegment = 0);

    TurnActions start(Time now);
    /// Drives to stop `stop` (0-based) and reads it again, the others stay; ignored unless Finished. A timed
    /// turn goes back the way it came, because only so the error of its steps cancels; a measured turn takes
    /// the shorter way.
    TurnActions retake(int stop, Time now);
    TurnActions abort(Time now, std::string reason);
    TurnActions onTimer(Time now);
    TurnActions onTagRead(const TagRead& read);
    TurnActions onSegmentDone(std::uint32_t number, Time now);
    TurnActions onRobotState(RobotState state, Time now);
    TurnActions onRobotLost(Time now, std::string reason);
    TurnActions onReaderLost(Time now, std::string reason);
    /// The solver's answer to SolveResult has come.
    TurnActions solved(Time now);

    std::optional<Time> deadline() const;
    TurnPhase phase() const { return m_phase; }
    Time phaseSince() const { return m_phaseBegin; }
    int currentStop() const { return m_stop + 1; } ///< 1-based: being approached or read
    bool isActive() const;                         ///< neither Idle nor Finished, Aborted, Failed
    const TurnRecord& record() const { return m_record; }
    /// Where the robot stands, in steps of the turn after stop 0: the last stop, except after a retake.
    int standingAt() const { return m_standing; }
    std::uint32_t nextSegment() const { return m_nextSegment; }
    /// Phase, stop, progress, time left, table; preview and result are the caller's.
    TurnSnapshot snapshot(Time now) const;

private:
    void enterSettling(Time now);
    void enterReading(Time now);
    void leaveStop(Time now, TurnActions& actions);
    void keepStop();
    void driveStep(Time now, TurnActions& actions);
    void endStep(Time now);
    void warnIfLate(Time now, TurnActions& actions) const;
    void onPhaseEnd(Time now, TurnActions& actions);
    void sendZero(Time now, TurnActions& actions);
    TurnActions stop(TurnPhase end, std::string reason, EventLevel level, Time now);
    std::optional<Time> silenceDeadline() const;

    TurnParameters m_parameters;
    TurnPlan m_plan;
    DwellRule m_dwell;
    ZeroBurst m_zeros;
    TurnRecord m_record;
    TurnPhase m_phase = TurnPhase::Idle;
    Time m_phaseBegin;
    std::optional<Time> m_phaseEnd; ///< empty while Reading: the dwell rule knows
    int m_stop = 0;                 ///< 0-based stop that is being approached or read
    int m_standing = 0;
    int m_stepsToGo = 0; ///< signed, positive in the turn's own direction
    bool m_retaking = false;
    TurnStop m_current;           ///< reads of m_stop so far
    std::optional<Time> m_leftAt; ///< end of the last dwell: a read of before that comes late belongs to it
    Time m_lastRead;              ///< or the start
    std::uint32_t m_nextSegment;
    std::uint32_t m_awaitedSegment = 0;
    bool m_sawItDrive = false; ///< in this step: a late report of the stop before it is not a new stop
    std::string m_message;
};

} // namespace agv::procedure
