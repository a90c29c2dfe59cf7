// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/robot_stream.h"

#include "protocol/drop_text.h"
#include "protocol/robot_frame.h"
#include "protocol/wire_bytes.h"

#include <numeric>

namespace agv::protocol {

namespace {

/// What is different between the two directions.
template<typename Message>
struct Direction;

template<>
struct Direction<RobotReport> {
    static constexpr FrameType type = FrameType::uartToTcp;
    static auto decode(std::span<const std::uint8_t> payload) { return decodeReportPayload(payload); }
};

template<>
struct Direction<RobotCommand> {
    static constexpr FrameType type = FrameType::networkToUart;
    static auto decode(std::span<const std::uint8_t> payload) { return decodeCommandPayload(payload); }
};

} // namespace

template<typename Message>
void MessageStream<Message>::feed(std::span<const std::uint8_t> bytes, const Sink& sink)
{
    if (m_pending.empty()) {
        bytes = bytes.subspan(takeFrames(bytes, sink));
        m_pending.assign(bytes.begin(), bytes.end());
        return;
    }
    m_pending.insert(m_pending.end(), bytes.begin(), bytes.end());
    const std::size_t taken = takeFrames(m_pending, sink);
    m_pending.erase(m_pending.begin(), m_pending.begin() + static_cast<std::ptrdiff_t>(taken));
}

/// Passes on every whole frame; returns the number of bytes they have.
template<typename Message>
std::size_t MessageStream<Message>::takeFrames(std::span<const std::uint8_t> bytes, const Sink& sink)
{
    std::size_t taken = 0;
    while (bytes.size() - taken >= frameHeaderBytes) {
        const auto rest = bytes.subspan(taken);
        const std::size_t length = rest[1];
        if (rest.size() < frameHeaderBytes + length)
            break;
        takeFrame(rest[0], rest.subspan(frameHeaderBytes, length), sink);
        taken += frameHeaderBytes + length;
    }
    return taken;
}

template<typename Message>
void MessageStream<Message>::takeFrame(std::uint8_t type, std::span<const std::uint8_t> payload,
                                       const Sink& sink)
{
    if (type != static_cast<std::uint8_t>(Direction<Message>::type)) {
        m_counts.drop(RobotFrameError::UnknownType);
        return;
    }
    const auto message = Direction<Message>::decode(payload);
    if (!message) {
        m_counts.drop(message.error());
        return;
    }
    ++m_counts.good;
    sink(*message);
}

template class MessageStream<RobotReport>;
template class MessageStream<RobotCommand>;

std::uint64_t FrameCounts::droppedTotal() const
{
    return std::accumulate(dropped.begin(), dropped.end(), std::uint64_t{0});
}

std::string dropDetail(const FrameCounts& counts) { return dropText<RobotFrameError>(counts.dropped); }

const char* toText(RobotFrameError error)
{
    switch (error) {
    case RobotFrameError::UnknownType:
        return "unknown type";
    case RobotFrameError::UnknownMessage:
        return "unknown message";
    case RobotFrameError::BadLength:
        return "bad length";
    case RobotFrameError::BadValue:
        return "bad value";
    case RobotFrameError::EmptyPayload:
        return "empty";
    }
    return "unknown";
}

} // namespace agv::protocol
