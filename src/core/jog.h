// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/robot_status.h"
#include "core/units.h"

#include <cstdint>
#include <string>

/// Driving an AGV by hand: what the operator's hand says, and what became of it.
namespace agv {

/// What the operator holds. Only one of them drives an AGV at a time.
enum class JogSource { Pad, Keys };

/// Why an AGV driven by hand was stopped, or why it is not driven.
enum class JogReason {
    None,
    Released,      ///< the operator let go: the ordinary end
    FocusLost,     ///< the pad or the window lost the keyboard
    WindowHidden,  ///< the window was hidden or minimised, or the pad is no longer to be seen
    DialogOpened,  ///< a dialog lies over the window
    OtherChosen,   ///< the operator chose another AGV
    OpposingKeys,  ///< keys that cancel each other
    WindowStalled, ///< the window did not react for a while: nobody knows how old its input is
    ScreenLocked,
    Suspended, ///< the computer goes to sleep, or the desktop put the program aside
    InputOld,  ///< no word that the operator still holds came in time
    LinkOld,   ///< the robot did not confirm a command in time
    LinkLost,
    NotConnected,
    TurnRuns,     ///< an initialisation turn
    DrivesItself, ///< docks or undocks
    Docked,
    RobotError,
    StopAll,     ///< until the operator releases it
    StoppedHere, ///< the Stop of this AGV
    OtherSource, ///< something else drives the AGV
    HandHolds,   ///< it is driven by hand, so it is not told to dock
    BadSpeed,    ///< no number, or nothing to drive
};

/// What the hand says: once when it presses, then "still held" every 50 ms.
struct JogCommand {
    JogSource source = JogSource::Pad;
    /// Grows with each press; the word of an earlier press drives nothing any more.
    std::uint32_t press = 0;
    WheelSpeeds speeds;
    Time input; ///< when the hand was last known to hold
};

enum class JogState {
    Ready,   ///< a press drives
    Driving, ///< a hand holds
    Spent,   ///< stopped while the hand held on: it must let go and press anew
    Latched, ///< Stop all holds until the operator releases it
};

struct JogSnapshot {
    JogState state = JogState::Ready;
    std::string note;     ///< what became of the last press, if that needs a word; plain English
    std::string obstacle; ///< why a press would not drive now; empty: it would
    friend bool operator==(const JogSnapshot&, const JogSnapshot&) = default;
};

/// Where the hand points, in the vehicle's view: each -1, 0 or 1.
struct JogDirection {
    int forward = 0; ///< 1 ahead, -1 back
    int left = 0;    ///< 1 to the left, -1 to the right
    friend bool operator==(const JogDirection&, const JogDirection&) = default;
};

/// To the robots' own docks. Charge is the base's own docking, to charge.
enum class DockOrder { Dock, Undock, Charge };

/// Hands never drive faster than this (ISO 10218-1: reduced speed of manual operation), m/s.
inline constexpr double mostJogSpeed_m_s = 0.250;
inline constexpr double usualJogSpeed_m_s = 0.100;

/// Wheel speeds for a direction: straight, on the spot, or a curve whose inner wheel, on the side of the
/// arrow, runs at 0.4 of `speed_m_s`: the vehicle then goes round a circle of 0.33 m radius. No wheel is
/// faster than `speed_m_s`.
WheelSpeeds jogSpeeds(JogDirection direction, double speed_m_s);

/// Both wheels slowed by the same factor until none is faster than `limit_m_s`, so that a curve stays the
/// same curve. Zero when a speed is not a number.
WheelSpeeds slowedTo(const WheelSpeeds& speeds, double limit_m_s);

} // namespace agv
