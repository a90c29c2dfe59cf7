// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/jog.h"

#include <cstdint>
#include <optional>

namespace agv::procedure {

struct JogDeadManParameters {
    Duration interval = std::chrono::milliseconds(50); ///< of the drive commands: 20 Hz
    /// A hand that was not heard of for this long holds no more. The same bound holds for the robot's word
    /// that it got a command; the caller watches that one.
    Duration longestSilence = std::chrono::milliseconds(250);
};

/// What the caller sends to the robot.
enum class JogAction {
    None,
    Drive, ///< JogDeadMan::speeds()
    Stop,  ///< zero at once, and a whole ZeroBurst
};

/// The dead-man of driving by hand, as a pure state machine: an AGV drives while one hand holds and says so,
/// and in no other case. One for each AGV. It never starts by itself, never repeats a command whose cause is
/// gone, and says nothing at all unless a hand holds.
/// | event \ state           | Ready          | Driving                   | Spent          | Latched |
/// |-------------------------|----------------|---------------------------|----------------|---------|
/// | press                   | Driving, Drive | Driving, Drive (1)        | Driving, Drive | refused |
/// | press, obstacle or (2)  | refused        | Spent, Stop (1)           | refused        | refused |
/// | hold of this press      |                | new speeds, next in time  |                |         |
/// | hold, too old           |                | Spent, Stop               |                |         |
/// | hold of another press   |                |                           |                |         |
/// | release of this press   |                | Ready, Stop               | Ready          | Latched |
/// | release of another press|                |                           |                |         |
/// | obstruct                |                | Spent, Stop               |                |         |
/// | stopAll (3)             | Latched        | Latched                   | Latched        | Latched |
/// | releaseLatch            |                |                           |                | Ready, or Spent
/// (4) | | timer, command due      |                | Drive                     |                |         |
/// | timer, hand too silent  |                | Spent, Stop               |                |         |
/// An empty cell: same state, no action. (1) of the same source; a press of another source is refused and
/// changes nothing. (2) its input is too old, or there is nothing to drive. (3) the caller sends the zeros of
/// Stop all itself. (4) while the press that Stop all ended has not been let go.
/// Before every event a hand that was silent for too long is stopped: after this thread itself stood still,
/// the word that comes first must not drive.
class JogDeadMan {
public:
    explicit JogDeadMan(JogDeadManParameters parameters = {}) : m_parameters(parameters) {}

    /// `obstacle`: what forbids driving now; None: nothing. A refused press says why in reason().
    JogAction press(const JogCommand& command, JogReason obstacle, Time now);
    /// "Still held", perhaps with other speeds. They are sent when the next command is due.
    JogAction hold(const JogCommand& command, Time now);
    /// `why`: Released, or what took the hand away.
    JogAction release(const JogCommand& command, JogReason why);
    /// The AGV may not be driven any more: lost, in error, stopped by other means, a turn begins.
    JogAction obstruct(JogReason why);
    void stopAll();
    void releaseLatch();
    JogAction onTimer(Time now);

    /// When onTimer() has something to do; empty while no hand holds.
    std::optional<Time> deadline() const;
    JogState state() const { return m_state; }
    WheelSpeeds speeds() const { return m_command.speeds; } ///< of the hand that holds, or held last
    JogSource source() const { return m_command.source; }
    /// Why it was stopped or refused last; None while it drives well.
    JogReason reason() const { return m_reason; }
    /// The bound for the hand and for the robot's confirmations.
    Duration longestSilence() const { return m_parameters.longestSilence; }

private:
    bool isTooOld(Time input, Time now) const { return now - input >= m_parameters.longestSilence; }
    bool isOfThisPress(const JogCommand& command) const
    {
        return command.source == m_command.source && command.press == m_command.press;
    }
    JogReason refusal(const JogCommand& command, JogReason obstacle, Time now) const;
    JogAction stopHeld(JogReason why);

    JogDeadManParameters m_parameters;
    JogState m_state = JogState::Ready;
    JogCommand m_command;
    JogReason m_reason = JogReason::None;
    bool m_letGo = true; ///< the hand of m_command is known to be off
    Time m_next;         ///< when the next command is due
};

} // namespace agv::procedure
