// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedure/jog_dead_man.h"

#include <gtest/gtest.h>

/// Short words for the tests of the dead-man.
namespace agv::procedure::jog_test {

using namespace std::chrono_literals;

inline constexpr Time start = Time{} + 1h;
inline constexpr WheelSpeeds ahead{0.1, 0.1};
inline constexpr WheelSpeeds curve{0.04, 0.1};

inline JogCommand command(std::uint32_t press, Time input, WheelSpeeds speeds = ahead,
                          JogSource source = JogSource::Pad)
{
    return {source, press, speeds, input};
}

/// A machine in each of the states; the hand of press 1 holds in Driving and Spent.
inline JogDeadMan machineIn(JogState state)
{
    JogDeadMan machine;
    if (state == JogState::Driving || state == JogState::Spent)
        machine.press(command(1, start), JogReason::None, start);
    if (state == JogState::Spent)
        machine.obstruct(JogReason::RobotError);
    if (state == JogState::Latched)
        machine.stopAll();
    EXPECT_EQ(machine.state(), state);
    return machine;
}

inline constexpr auto ready = JogState::Ready;
inline constexpr auto driving = JogState::Driving;
inline constexpr auto spent = JogState::Spent;
inline constexpr auto latched = JogState::Latched;
inline constexpr auto nothing = JogAction::None;
inline constexpr auto drive = JogAction::Drive;
inline constexpr auto stop = JogAction::Stop;
inline constexpr Time soon = start + 20ms;

} // namespace agv::procedure::jog_test
