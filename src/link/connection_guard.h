// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace agv::link {

/// Told of every connection of a robot, so that robots can be stopped even when this process cannot do it
/// any more. Called in the session thread.
class ConnectionGuard {
public:
    virtual ~ConnectionGuard() = default;
    /// `descriptor` is the robot's connection until release(), or until guard() is called for it again.
    virtual void guard(int robot, int descriptor) = 0;
    /// The connection of this robot has ended; called at once.
    virtual void release(int robot) = 0;
};

} // namespace agv::link
