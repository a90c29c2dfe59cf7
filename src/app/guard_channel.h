// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

/// What the console and its watchdog process say to each other, one message a packet of a Unix socket.
namespace agv::app {

struct GuardMessage {
    enum class Kind : std::int32_t {
        Beat,    ///< console: I am alive
        Guard,   ///< console: this descriptor (ancillary data) is the connection of `robot`
        Release, ///< console: `robot` needs no watching any more
        Spoke,   ///< watchdog: the console was silent, so the robots have been stopped
    };
    Kind kind = Kind::Beat;
    std::int32_t robot = 0;
};

inline constexpr std::chrono::milliseconds beatInterval{200};
/// The console is taken for dead or stopped after two such times without a message. Two, because the first
/// one may have run out while the whole computer stood still.
inline constexpr std::chrono::milliseconds silenceInterval{500};

/// First argument of the program when it is started as the watchdog; the channel is its standard input.
inline constexpr const char* guardCommand = "guard-robots";

} // namespace agv::app
