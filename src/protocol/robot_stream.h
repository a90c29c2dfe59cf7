// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/robot_messages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace agv::protocol {

/// Why a frame, datagram or payload is not a message.
enum class RobotFrameError : std::uint8_t {
    UnknownType,    ///< type byte that does not belong to this direction
    UnknownMessage, ///< message or command id that the protocol does not have
    BadLength,      ///< payload too short or too long for its id
    BadValue,       ///< a field outside its range (state 9, charging 7, a text without its NUL or not ASCII)
    EmptyPayload,   ///< no payload at all
};
inline constexpr std::size_t robotFrameErrorCount = 5;

/// In words for a count of them: "unknown message", ...
const char* toText(RobotFrameError error);

struct FrameCounts {
    std::uint64_t good = 0;
    std::array<std::uint64_t, robotFrameErrorCount> dropped{}; ///< by RobotFrameError
    void drop(RobotFrameError error) { ++dropped[static_cast<std::size_t>(error)]; }
    std::uint64_t droppedTotal() const;
    friend bool operator==(const FrameCounts&, const FrameCounts&) = default;
};

/// "2 unknown message": the non-zero counts in words, empty when nothing was dropped.
std::string dropDetail(const FrameCounts& counts);

/// Reassembles the frames of one direction of the robot link (robot_frame.h) from a TCP stream at any split
/// and decodes them. The length byte keeps it in step: a frame of a wrong type, id or content is dropped
/// whole and counted, the next one is found. Holds back at most 256 bytes. One per connection.
template<typename Message>
class MessageStream {
public:
    /// A sink must not feed or reset the stream that calls it.
    using Sink = std::function<void(const Message&)>;

    void feed(std::span<const std::uint8_t> bytes, const Sink& sink);
    /// Forgets a half frame (after a reconnection); the counts stay.
    void reset() { m_pending.clear(); }
    const FrameCounts& counts() const { return m_counts; }
    /// Bytes of the half frame held back.
    std::size_t pendingBytes() const { return m_pending.size(); }

private:
    std::size_t takeFrames(std::span<const std::uint8_t> bytes, const Sink& sink);
    void takeFrame(std::uint8_t type, std::span<const std::uint8_t> payload, const Sink& sink);

    std::vector<std::uint8_t> m_pending;
    FrameCounts m_counts;
};

extern template class MessageStream<RobotReport>;
extern template class MessageStream<RobotCommand>;

/// Robot -> console.
using ReportStream = MessageStream<RobotReport>;
/// Console -> robot: for the simulated robots and for tests that read the wire.
using CommandStream = MessageStream<RobotCommand>;

} // namespace agv::protocol
