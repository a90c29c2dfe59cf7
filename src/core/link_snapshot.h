// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace agv {

/// Life of one connection (procedure/link_life.h has the transitions).
enum class LinkState {
    Down,    ///< closed by the operator
    Opening, ///< connecting
    Up,      ///< connected and data is fresh
    Silent,  ///< connected, but nothing has arrived for too long
    Waiting, ///< lost; another try follows by itself
    Failed,  ///< needs the operator
};

/// What the link panel shows of one connection.
struct LinkSnapshot {
    std::string name;    ///< "RFID reader 1", "Robot 1"
    std::string address; ///< peer
    LinkState state = LinkState::Down;
    std::string reason; ///< why it is Waiting, Silent or Failed, and what to do; plain English
    double messagesPerSecond = 0.0;
    std::optional<double> dataAge_s; ///< age of the last message; empty: none yet
    std::uint64_t received = 0;      ///< good messages
    std::uint64_t dropped = 0;       ///< bad ones, all reasons
    std::string dropDetail;          ///< "3 garbled, 1 over-long"; empty when nothing was dropped
    std::optional<double> retryIn_s; ///< while Waiting
    friend bool operator==(const LinkSnapshot&, const LinkSnapshot&) = default;
};

/// A device is at the other end, whether it says something or not.
inline bool isConnected(const LinkSnapshot& link)
{
    return link.state == LinkState::Up || link.state == LinkState::Silent;
}

} // namespace agv
