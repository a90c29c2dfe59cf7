// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/robot_status.h"
#include "core/turn.h"

namespace agv::procedure {

/// Angles, times and limits that follow from the parameters of a turn.
class TurnPlan {
public:
    /// @pre validate(parameters)
    explicit TurnPlan(const TurnParameters& parameters);

    int stopCount() const { return m_stopCount; }    ///< readings, the closing one included
    double stepAngle() const { return m_stepAngle; } ///< rad, positive
    Duration stepTime() const { return m_stepTime; } ///< turnTime_s is the time of 45 degrees
    Duration settleTime() const { return m_settle; }
    /// A measured step that takes longer than this has gone wrong.
    Duration stepLimit() const { return 3 * m_stepTime + std::chrono::seconds(2); }
    /// Half a turn without a single read: the reader is mute or there are no tags below.
    Duration silenceLimit() const;
    Duration solveLimit() const { return std::chrono::seconds(30); }

    double wheelSpeed() const { return m_wheelSpeed; } ///< m/s, positive
    WheelSpeeds wheelSpeeds(Rotation rotation) const;
    /// The measured way between two neighbouring stops (counted from stop 0, also beyond a whole turn). The
    /// wire has whole degrees, so steps of 22.5 degrees are 23 and 22 in turn and their sum stays true.
    DriveSegment segment(int fromStop, int toStop) const;

    // For the display of progress.
    Duration expectedDwell() const { return m_expectedDwell; }
    static constexpr Duration expectedSolve() { return std::chrono::milliseconds(300); }

private:
    int m_stopCount;
    Rotation m_rotation;
    double m_stepAngle;
    Duration m_stepTime;
    Duration m_settle;
    Duration m_longestDwell;
    Duration m_expectedDwell;
    double m_wheelSpeed;
};

} // namespace agv::procedure
