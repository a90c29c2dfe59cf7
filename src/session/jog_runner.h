// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "core/jog.h"
#include "core/snapshot.h"
#include "procedure/jog_dead_man.h"

#include <functional>
#include <string>

namespace agv::session {

class RobotLink;

/// Drives one AGV by hand: gives the dead-man the time, the state of the robot and the age of its
/// confirmations, and sends what it says. Also the orders to dock and undock. Lives in the session thread.
class JogRunner : public QObject {
    Q_OBJECT
public:
    /// `limit_m_s`: of this AGV's wheels. `isTurning`: an initialisation turn runs.
    JogRunner(RobotLink& robot, double limit_m_s, std::function<bool()> isTurning, QObject* parent);

    /// Faster wheels than the limits are slowed; a refused press says why in the snapshot.
    void press(const JogCommand& command);
    void hold(const JogCommand& command);
    void release(const JogCommand& command, JogReason why);
    /// Ends a hold from outside; the zeros are sent here.
    void obstruct(JogReason why);
    /// Stop all: the caller sends the zeros.
    void latch();
    void releaseLatch();
    void order(DockOrder order);
    /// The robot reported something: what forbids driving stops it.
    void onRobotState();

    bool isDriving() const { return m_deadMan.state() == JogState::Driving; }
    JogSnapshot snapshot(Time now) const;

signals:
    void message(agv::EventLevel level, const QString& text);
    void changed();

private:
    void onTimer();
    void perform(procedure::JogAction action);
    JogReason obstacle(Time now) const;
    JogCommand limited(const JogCommand& command) const;
    void reportPress(bool drove);
    void reportEnd();
    void armTimer();

    RobotLink& m_robot;
    double m_limit_m_s;
    std::function<bool()> m_isTurning;
    QTimer* m_timer;
    procedure::JogDeadMan m_deadMan;
    std::string m_note;
};

} // namespace agv::session
