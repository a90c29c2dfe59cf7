// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/robot_frame.h"
#include "protocol/wire_bytes.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace agv::protocol {

namespace {

struct Range {
    double low;
    double high;
};

template<typename Integer>
constexpr Range rangeOf{static_cast<double>(std::numeric_limits<Integer>::min()),
                        static_cast<double>(std::numeric_limits<Integer>::max())};
constexpr Range wheelSpeedRange_mm_s{-maxWheelSpeed_m_s * 1e3, maxWheelSpeed_m_s * 1e3};

/// Writes the payload of one message; remembers the first field that could not be written.
class PayloadWriter {
public:
    explicit PayloadWriter(std::string_view message, std::size_t id) : m_message(message)
    {
        put(static_cast<std::uint8_t>(id));
    }

    template<typename Integer>
    void put(Integer value)
    {
        appendBigEndian(m_bytes, value);
    }

    /// Rounds to the field's unit.
    template<typename Integer>
    void putRounded(double value, std::string_view name, Range range = rangeOf<Integer>)
    {
        const double rounded = std::round(value);
        // Written so that a NaN fails too.
        if (!(rounded >= range.low && rounded <= range.high)) {
            fail(name, "is " + std::to_string(value) + ", outside " + std::to_string(std::lround(range.low)) +
                           " to " + std::to_string(std::lround(range.high)));
            return;
        }
        put(static_cast<Integer>(rounded));
    }

    /// As putRounded, for a limit whose 0 means "no limit": a limit that rounds to 0 would never end.
    void putLimit(double value, std::string_view name)
    {
        if (value != 0.0 && std::round(value) == 0.0)
            fail(name, "is " + std::to_string(value) + ", which rounds to 0, that is, no limit at all");
        else
            putRounded<std::int16_t>(value, name);
    }

    void putText(std::string_view text, std::string_view name)
    {
        if (!isAscii(text) || text.contains('\0'))
            fail(name, "is not plain ASCII");
        m_bytes.insert(m_bytes.end(), text.begin(), text.end());
        put(std::uint8_t{0});
    }

    void fail(std::string_view name, std::string_view problem)
    {
        if (!m_problem)
            m_problem = std::string(m_message) + ": " + std::string(name) + " " + std::string(problem);
    }

    Result<Bytes> finish()
    {
        if (m_bytes.size() > maxPayloadBytes)
            fail("payload", "has " + std::to_string(m_bytes.size()) + " bytes; a frame holds at most 255");
        if (m_problem)
            return failure(ErrorCode::BadInput, *m_problem);
        return std::move(m_bytes);
    }

private:
    std::string_view m_message;
    Bytes m_bytes;
    std::optional<std::string> m_problem;
};

void putSpeeds(PayloadWriter& payload, const WheelSpeeds& speeds)
{
    payload.putRounded<std::int16_t>(mmFromMetres(speeds.left), "left wheel speed (mm/s)",
                                     wheelSpeedRange_mm_s);
    payload.putRounded<std::int16_t>(mmFromMetres(speeds.right), "right wheel speed (mm/s)",
                                     wheelSpeedRange_mm_s);
}

void putBody(PayloadWriter& payload, const AddSegments& command)
{
    const std::size_t count = command.segments.size();
    if (count == 0 || count > maxSegments) {
        payload.fail("number of segments",
                     "is " + std::to_string(count) + ", outside 1 to " + std::to_string(maxSegments));
        return;
    }
    if (command.firstNumber > std::numeric_limits<std::uint32_t>::max() - (count - 1))
        payload.fail("segment numbers", "run past 4294967295; start again from 0");
    payload.put(command.firstNumber);
    payload.put(static_cast<std::uint8_t>(count));
    for (const DriveSegment& segment : command.segments) {
        putSpeeds(payload, segment.speeds);
        payload.putLimit(mmFromMetres(segment.endDistance_m), "end distance (mm)");
        payload.putLimit(degFromRad(segment.endAngle), "end angle (degrees)");
    }
}

void putBody(PayloadWriter&, const Dock&) {}
void putBody(PayloadWriter&, const Undock&) {}
void putBody(PayloadWriter&, const Interrupt&) {}
void putBody(PayloadWriter& payload, const DirectDrive& command) { putSpeeds(payload, command.speeds); }
void putBody(PayloadWriter&, const DockDemo&) {}

void putBody(PayloadWriter& payload, const AssertReport& report)
{
    payload.putText(report.file, "file name");
    payload.putRounded<std::uint16_t>(report.line, "line");
}

void putBody(PayloadWriter& payload, const DebugReport& report)
{
    payload.putText(report.text, "text");
    payload.put(report.value);
}

void putBody(PayloadWriter& payload, const SegmentDone& report)
{
    payload.put(report.number);
    payload.put(report.robotTime_ms);
}

void putBody(PayloadWriter& payload, const SensorUpdate& report)
{
    const BatteryStatus& battery = report.battery;
    if (battery.charging > ChargingState::Fault)
        payload.fail("charging state", "is unknown");
    payload.put(static_cast<std::uint8_t>(battery.charging));
    payload.putRounded<std::uint16_t>(battery.voltage_V * 1e3, "voltage (mV)");
    payload.putRounded<std::int16_t>(battery.current_A * 1e3, "current (mA)");
    payload.putRounded<std::int8_t>(battery.temperature_degC, "battery temperature (degC)");
    payload.putRounded<std::uint16_t>(battery.charge_Ah * 1e3, "charge (mAh)");
    payload.putRounded<std::uint16_t>(battery.capacity_Ah * 1e3, "capacity (mAh)");
    payload.put(
        static_cast<std::uint8_t>((battery.internalCharger ? 1U : 0U) | (battery.homeBase ? 2U : 0U)));
}

void putBody(PayloadWriter& payload, const SegmentUpdate& report)
{
    payload.put(report.number);
    payload.put(report.robotTime_ms);
    payload.putRounded<std::int16_t>(mmFromMetres(report.distance_m), "distance (mm)");
    payload.putRounded<std::int16_t>(degFromRad(report.angle), "angle (degrees)");
}

void putBody(PayloadWriter& payload, const StateUpdate& report)
{
    if (report.state > RobotState::Error)
        payload.fail("state", "is unknown");
    payload.put(static_cast<std::uint8_t>(report.state));
}

// In the order of the ids, as the variants' alternatives.
constexpr std::array<std::string_view, std::variant_size_v<RobotCommand>> commandNames{
    "addSegments", "dock", "undock", "interrupt", "directDrive", "dockDemo"};
constexpr std::array<std::string_view, std::variant_size_v<RobotReport>> reportNames{
    "assert", "debug", "segmentDone", "sensorUpdate", "segmentUpdate", "stateUpdate"};

/// The alternative's index is its id.
template<typename Message, std::size_t n>
Result<Bytes> encodePayload(const Message& message, const std::array<std::string_view, n>& names)
{
    PayloadWriter payload(names[message.index()], message.index());
    std::visit([&payload](const auto& body) { putBody(payload, body); }, message);
    return payload.finish();
}

/// Type, length, payload; or type and payload alone for a datagram.
Result<Bytes> wrapped(FrameType type, bool withLength, const Result<Bytes>& payload)
{
    if (!payload)
        return payload;
    Bytes packet{static_cast<std::uint8_t>(type)};
    packet.reserve(frameHeaderBytes + payload->size());
    if (withLength)
        packet.push_back(static_cast<std::uint8_t>(payload->size()));
    packet.insert(packet.end(), payload->begin(), payload->end());
    return packet;
}

} // namespace

Result<Bytes> encodeCommand(const RobotCommand& command)
{
    return wrapped(FrameType::networkToUart, true, encodePayload(command, commandNames));
}

Result<Bytes> encodeReportFrame(const RobotReport& report)
{
    return wrapped(FrameType::uartToTcp, true, encodePayload(report, reportNames));
}

Result<Bytes> encodeReportDatagram(const RobotReport& report)
{
    return wrapped(FrameType::uartToUdp, false, encodePayload(report, reportNames));
}

} // namespace agv::protocol
