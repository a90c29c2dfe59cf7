// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/jog_desk.h"

#include "session/agv_line.h"
#include "session/jog_runner.h"

namespace agv::session {

AgvLine* JogDesk::line(int robot) const
{
    const auto found = m_lines.find(robot);
    return found != m_lines.end() ? found->second : nullptr;
}

void JogDesk::press(int robot, const JogCommand& command)
{
    if (AgvLine* agv = line(robot))
        agv->jog().press(command);
}

void JogDesk::hold(int robot, const JogCommand& command)
{
    if (AgvLine* agv = line(robot))
        agv->jog().hold(command);
}

void JogDesk::release(int robot, const JogCommand& command, JogReason why)
{
    if (AgvLine* agv = line(robot))
        agv->jog().release(command, why);
}

void JogDesk::endAll(JogReason why)
{
    for (const auto& [robot, agv] : m_lines)
        agv->jog().obstruct(why);
}

void JogDesk::stop(int robot)
{
    if (AgvLine* agv = line(robot))
        agv->stopByHand();
}

void JogDesk::order(int robot, DockOrder order)
{
    if (AgvLine* agv = line(robot))
        agv->jog().order(order);
}

void JogDesk::releaseStopAll()
{
    for (const auto& [robot, agv] : m_lines)
        agv->jog().releaseLatch();
}

} // namespace agv::session
