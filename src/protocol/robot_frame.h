// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "protocol/robot_messages.h"
#include "protocol/robot_stream.h"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <vector>

/// Robot link, both directions. A frame on TCP is the type (0 network -> UART, 1 UART -> TCP, 2 UART -> UDP),
/// the payload length n, and n bytes of payload. A UDP datagram is one packet: the type, then the payload,
/// no length. Integers are big-endian, two's complement. Payloads, first byte is the id:
///
///   console -> robot   0 addSegments  u32 first number, u8 count, count x (i16 left mm/s, i16 right mm/s,
///                                     i16 end distance mm, i16 end angle deg; 0 = no limit)
///                      1 dock   2 undock   3 interrupt   5 dockDemo
///                      4 directDrive  i16 left mm/s, i16 right mm/s, -500..500
///   robot -> console   0 assert  file name, NUL, u16 line       1 debug  text, NUL, i32 value
///                      2 segmentDone  u32 number, u64 ms
///                      3 sensorUpdate  u8 charging state, u16 mV, i16 mA, i8 degC, u16 mAh charge,
///                                      u16 mAh capacity, u8 charging source
///                      4 segmentUpdate  u32 number, u64 ms, i16 mm, i16 deg
///                      5 stateUpdate  u8 state
namespace agv::protocol {

using Bytes = std::vector<std::uint8_t>;

/// One TCP frame. Speeds are rounded to 1 mm/s, distances to 1 mm, angles to 1 degree. BadInput: a speed
/// beyond +-500 mm/s, a value that does not fit its field or is not a number, no or more than 31 segments,
/// an end distance or end angle that would round to 0 and so lose its limit.
Result<Bytes> encodeCommand(const RobotCommand& command);
/// One TCP frame (type 1) or UDP datagram (type 2); for the simulated plant and tests. BadInput as above, and
/// for a text that is not ASCII, contains NUL or is too long.
Result<Bytes> encodeReportFrame(const RobotReport& report);
Result<Bytes> encodeReportDatagram(const RobotReport& report);

/// A payload without type and length. The decoders accept exactly what the encoders write.
std::expected<RobotReport, RobotFrameError> decodeReportPayload(std::span<const std::uint8_t> payload);
std::expected<RobotCommand, RobotFrameError> decodeCommandPayload(std::span<const std::uint8_t> payload);
/// A whole UDP datagram: type 2, then the payload.
std::expected<RobotReport, RobotFrameError> decodeReportDatagram(std::span<const std::uint8_t> datagram);

} // namespace agv::protocol
