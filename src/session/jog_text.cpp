// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/jog_text.h"

namespace agv::session {

std::string sentenceOf(JogReason reason)
{
    switch (reason) {
    case JogReason::None:
        return {};
    case JogReason::Released:
        return "the operator let go";
    case JogReason::FocusLost:
        return "the keyboard went elsewhere";
    case JogReason::WindowHidden:
        return "the drive pad is no longer to be seen";
    case JogReason::DialogOpened:
        return "a dialog opened over the window";
    case JogReason::OtherChosen:
        return "another AGV was chosen";
    case JogReason::OpposingKeys:
        return "the keys cancelled each other";
    case JogReason::WindowStalled:
        return "the window did not react for a moment";
    case JogReason::ScreenLocked:
        return "the screen was locked";
    case JogReason::Suspended:
        return "this computer or this program was put to sleep";
    case JogReason::InputOld:
        return "no word came from the operator's hand for 250 ms";
    case JogReason::LinkOld:
        return "the robot did not confirm a command for 250 ms: check its Wi-Fi";
    case JogReason::LinkLost:
        return "the link to the robot was lost";
    case JogReason::NotConnected:
        return "the robot is not connected";
    case JogReason::TurnRuns:
        return "a turn is running";
    case JogReason::DrivesItself:
        return "the robot docks or undocks by itself: wait, or press Stop";
    case JogReason::Docked:
        return "the robot is docked: undock it first";
    case JogReason::RobotError:
        return "the robot is in error: look at the robot, then switch it off and on";
    case JogReason::StopAll:
        return "Stop all was pressed: look that the way is free, then release it";
    case JogReason::StoppedHere:
        return "Stop was pressed";
    case JogReason::OtherSource:
        return "it is driven from elsewhere: mouse and keys do not drive together";
    case JogReason::HandHolds:
        return "it is driven by hand: let go first";
    case JogReason::BadSpeed:
        return "the speed is zero";
    }
    return {};
}

std::string nameOf(DockOrder order)
{
    switch (order) {
    case DockOrder::Dock:
        return "dock";
    case DockOrder::Undock:
        return "undock";
    case DockOrder::Charge:
        return "dock to charge";
    }
    return {};
}

bool isOrdinary(JogReason reason) { return reason == JogReason::None || reason == JogReason::Released; }

} // namespace agv::session
