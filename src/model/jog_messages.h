// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

namespace agv::model {

/// The sentences of the session on driving by hand; see Messages.
inline constexpr const char* jogPatterns[] = {
    QT_TRANSLATE_NOOP("agv::model::Messages", "It was told to stop"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "It was told to %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "It does not drive: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "It does not dock: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "It does not undock: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "It does not dock to charge: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Stopped: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Driving by hand ended: %1"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Driven by hand, with the keys"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Driven by hand, with the pad"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "Stop was pressed"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "dock"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "undock"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "dock to charge"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the operator let go"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the keyboard went elsewhere"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the drive pad is no longer to be seen"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "a dialog opened over the window"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "another AGV was chosen"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the keys cancelled each other"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the window did not react for a moment"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the screen was locked"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "this computer or this program was put to sleep"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "no word came from the operator's hand for 250 ms"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "the robot did not confirm a command for 250 ms: check its Wi-Fi"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the link to the robot was lost"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the robot docks or undocks by itself: wait, or press Stop"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "Stop all was pressed: look that the way is free, then release it"),
    QT_TRANSLATE_NOOP("agv::model::Messages",
                      "it is driven from elsewhere: mouse and keys do not drive together"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "it is driven by hand: let go first"),
    QT_TRANSLATE_NOOP("agv::model::Messages", "the speed is zero"),
};

} // namespace agv::model
