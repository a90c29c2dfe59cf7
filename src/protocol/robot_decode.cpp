// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/robot_frame.h"
#include "protocol/wire_bytes.h"

#include <array>
#include <cmath>
#include <limits>

namespace agv::protocol {

namespace {

using Payload = std::span<const std::uint8_t>;
using Failure = std::unexpected<RobotFrameError>;
template<typename T>
using Decoded = std::expected<T, RobotFrameError>;

/// The message when its payload had exactly the bytes of its fields.
template<typename Message>
Decoded<Message> ifExact(const FieldReader& fields, const Message& message)
{
    if (!fields.endedExactly())
        return Failure(RobotFrameError::BadLength);
    return message;
}

// --- robot -> console -------------------------------------------------------------------------------

Decoded<RobotReport> decodeAssert(FieldReader fields)
{
    const auto file = fields.takeText();
    if (!file || !isAscii(*file))
        return Failure(RobotFrameError::BadValue);
    const int line = fields.take<std::uint16_t>();
    return ifExact<RobotReport>(fields, AssertReport{*file, line});
}

Decoded<RobotReport> decodeDebug(FieldReader fields)
{
    const auto text = fields.takeText();
    if (!text || !isAscii(*text))
        return Failure(RobotFrameError::BadValue);
    const auto value = fields.take<std::int32_t>();
    return ifExact<RobotReport>(fields, DebugReport{*text, value});
}

Decoded<RobotReport> decodeSegmentDone(FieldReader fields)
{
    SegmentDone done;
    done.number = fields.take<std::uint32_t>();
    done.robotTime_ms = fields.take<std::uint64_t>();
    return ifExact<RobotReport>(fields, done);
}

Decoded<RobotReport> decodeSensorUpdate(FieldReader fields)
{
    constexpr unsigned internalChargerBit = 1U;
    constexpr unsigned homeBaseBit = 2U;

    BatteryStatus battery;
    const auto charging = fields.take<std::uint8_t>();
    battery.voltage_V = fields.take<std::uint16_t>() * 1e-3;
    battery.current_A = fields.take<std::int16_t>() * 1e-3;
    // NOLINTNEXTLINE(bugprone-signed-char-misuse): a number of one byte, no character
    battery.temperature_degC = fields.take<std::int8_t>();
    battery.charge_Ah = fields.take<std::uint16_t>() * 1e-3;
    battery.capacity_Ah = fields.take<std::uint16_t>() * 1e-3;
    const unsigned source = fields.take<std::uint8_t>();
    if (!fields.endedExactly())
        return Failure(RobotFrameError::BadLength);
    if (charging > static_cast<std::uint8_t>(ChargingState::Fault) ||
        source > (internalChargerBit | homeBaseBit))
        return Failure(RobotFrameError::BadValue);
    battery.charging = static_cast<ChargingState>(charging);
    battery.internalCharger = (source & internalChargerBit) != 0;
    battery.homeBase = (source & homeBaseBit) != 0;
    return SensorUpdate{battery};
}

Decoded<RobotReport> decodeSegmentUpdate(FieldReader fields)
{
    SegmentUpdate update;
    update.number = fields.take<std::uint32_t>();
    update.robotTime_ms = fields.take<std::uint64_t>();
    update.distance_m = metresFromMm(fields.take<std::int16_t>());
    update.angle = radFromDeg(fields.take<std::int16_t>());
    return ifExact<RobotReport>(fields, update);
}

Decoded<RobotReport> decodeStateUpdate(FieldReader fields)
{
    const auto state = fields.take<std::uint8_t>();
    if (!fields.endedExactly())
        return Failure(RobotFrameError::BadLength);
    if (state > static_cast<std::uint8_t>(RobotState::Error))
        return Failure(RobotFrameError::BadValue);
    return StateUpdate{static_cast<RobotState>(state)};
}

// --- console -> robot -------------------------------------------------------------------------------

bool isWheelSpeed(double speed_m_s) { return std::abs(speed_m_s) <= maxWheelSpeed_m_s; }

WheelSpeeds takeSpeeds(FieldReader& fields)
{
    const auto left = fields.take<std::int16_t>();
    const auto right = fields.take<std::int16_t>();
    return {metresFromMm(left), metresFromMm(right)};
}

bool inRange(const WheelSpeeds& speeds) { return isWheelSpeed(speeds.left) && isWheelSpeed(speeds.right); }

Decoded<RobotCommand> decodeAddSegments(FieldReader fields)
{
    AddSegments command;
    command.firstNumber = fields.take<std::uint32_t>();
    const std::size_t count = fields.take<std::uint8_t>();
    constexpr std::size_t bytesPerSegment = 8;
    if (fields.bytesLeft() != count * bytesPerSegment)
        return Failure(RobotFrameError::BadLength);
    if (count == 0 || count > maxSegments ||
        command.firstNumber > std::numeric_limits<std::uint32_t>::max() - (count - 1))
        return Failure(RobotFrameError::BadValue);
    command.segments.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        DriveSegment segment;
        segment.speeds = takeSpeeds(fields);
        segment.endDistance_m = metresFromMm(fields.take<std::int16_t>());
        segment.endAngle = radFromDeg(fields.take<std::int16_t>());
        if (!inRange(segment.speeds))
            return Failure(RobotFrameError::BadValue);
        command.segments.push_back(segment);
    }
    return command;
}

template<typename Command>
Decoded<RobotCommand> decodeBare(FieldReader fields)
{
    return ifExact<RobotCommand>(fields, Command{});
}

Decoded<RobotCommand> decodeDirectDrive(FieldReader fields)
{
    const DirectDrive command{takeSpeeds(fields)};
    if (!fields.endedExactly())
        return Failure(RobotFrameError::BadLength);
    if (!inRange(command.speeds))
        return Failure(RobotFrameError::BadValue);
    return command;
}

/// Dispatches on the id; the decoders stand in the order of the ids, as do the variants' alternatives.
template<typename Message, std::size_t n>
Decoded<Message> decodePayload(const std::array<Decoded<Message> (*)(FieldReader), n>& decoders,
                               Payload payload)
{
    static_assert(n == std::variant_size_v<Message>);
    if (payload.empty())
        return Failure(RobotFrameError::EmptyPayload);
    if (payload.size() > maxPayloadBytes)
        return Failure(RobotFrameError::BadLength);
    if (payload.front() >= n)
        return Failure(RobotFrameError::UnknownMessage);
    return decoders[payload.front()](FieldReader(payload.subspan(1)));
}

} // namespace

Decoded<RobotReport> decodeReportPayload(Payload payload)
{
    constexpr std::array decoders{decodeAssert,       decodeDebug,         decodeSegmentDone,
                                  decodeSensorUpdate, decodeSegmentUpdate, decodeStateUpdate};
    return decodePayload<RobotReport>(decoders, payload);
}

Decoded<RobotCommand> decodeCommandPayload(Payload payload)
{
    constexpr std::array decoders{decodeAddSegments,     decodeBare<Dock>,  decodeBare<Undock>,
                                  decodeBare<Interrupt>, decodeDirectDrive, decodeBare<DockDemo>};
    return decodePayload<RobotCommand>(decoders, payload);
}

Decoded<RobotReport> decodeReportDatagram(Payload datagram)
{
    if (datagram.empty())
        return Failure(RobotFrameError::EmptyPayload);
    if (datagram.front() != static_cast<std::uint8_t>(FrameType::uartToUdp))
        return Failure(RobotFrameError::UnknownType);
    return decodeReportPayload(datagram.subspan(1));
}

} // namespace agv::protocol
