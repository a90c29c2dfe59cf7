// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/robot_samples.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

using namespace agv;
using namespace agv::protocol;
using samples::segment;

namespace {

void expectBadInput(const Result<Bytes>& result, const std::string& word)
{
    ASSERT_FALSE(result) << word;
    EXPECT_EQ(result.error().code, ErrorCode::BadInput);
    EXPECT_NE(result.error().detail.find(word), std::string::npos) << result.error().detail;
}

Bytes bytesOf(const Result<Bytes>& result)
{
    EXPECT_TRUE(result) << result.error().detail;
    return result.value_or(Bytes{});
}

Bytes command(const RobotCommand& command) { return bytesOf(encodeCommand(command)); }
Bytes frame(const RobotReport& report) { return bytesOf(encodeReportFrame(report)); }

} // namespace

TEST(RobotEncoder, writesTheBytesOfEveryCommand)
{
    EXPECT_EQ(command(AddSegments{0x01020304, {segment(-100, 100, 0, 45), segment(0, 0, -2, 0)}}),
              (Bytes{0,    22,                                       // type, length
                     0,    1,    2,    3,    4,    2,                // id, first number, count
                     0xFF, 0x9C, 0x00, 0x64, 0,    0,    0x00, 0x2D, // -100, 100, no distance, 45
                     0,    0,    0,    0,    0xFF, 0xFE, 0,    0})); // 0, 0, -2, no angle
    EXPECT_EQ(command(Dock{}), (Bytes{0, 1, 1}));
    EXPECT_EQ(command(Undock{}), (Bytes{0, 1, 2}));
    EXPECT_EQ(command(Interrupt{}), (Bytes{0, 1, 3}));
    EXPECT_EQ(command(DirectDrive{{-0.1, 0.5}}), (Bytes{0, 5, 4, 0xFF, 0x9C, 0x01, 0xF4}));
    EXPECT_EQ(command(DockDemo{}), (Bytes{0, 1, 5}));
}

TEST(RobotEncoder, writesTheBytesOfEveryReport)
{
    EXPECT_EQ(frame(AssertReport{"a.c", 258}), (Bytes{1, 7, 0, 'a', '.', 'c', 0, 1, 2}));
    EXPECT_EQ(frame(DebugReport{"x", -2}), (Bytes{1, 7, 1, 'x', 0, 0xFF, 0xFF, 0xFF, 0xFE}));
    EXPECT_EQ(frame(SegmentDone{0x01020304, 0x1112131415161718}),
              (Bytes{1, 13, 2, 1, 2, 3, 4, 0x11, 0x12, 0x13, 0x14, 0x15, 0x16, 0x17, 0x18}));
    EXPECT_EQ(frame(samples::sensorUpdate(ChargingState::Trickle, 16400, -350, -5, 2100, 2696, false, true)),
              (Bytes{1, 12, 3, 3, 0x40, 0x10, 0xFE, 0xA2, 0xFB, 0x08, 0x34, 0x0A, 0x88, 2}));
    EXPECT_EQ(frame(SegmentUpdate{1, 2, metresFromMm(-3), radFromDeg(45)}),
              (Bytes{1, 17, 4, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0xFF, 0xFD, 0, 45}));
    EXPECT_EQ(frame(StateUpdate{RobotState::Error}), (Bytes{1, 2, 5, 8}));
}

TEST(RobotEncoder, putsADatagramsPayloadRightAfterItsType)
{
    EXPECT_EQ(bytesOf(encodeReportDatagram(StateUpdate{RobotState::DirectDriving})), (Bytes{2, 5, 3}));
    for (const RobotReport& report : samples::reports()) {
        const Bytes framed = frame(report);
        const Bytes datagram = bytesOf(encodeReportDatagram(report));
        EXPECT_EQ(Bytes(framed.begin() + 2, framed.end()), Bytes(datagram.begin() + 1, datagram.end()));
    }
}

TEST(RobotEncoder, roundsToTheUnitsOfTheWire)
{
    EXPECT_EQ(command(DirectDrive{{0.0994, 0.0996}}), command(DirectDrive{{0.099, 0.1}}));
    EXPECT_EQ(command(DirectDrive{{-0.5004, 0.5004}}), command(DirectDrive{{-0.5, 0.5}}));
    EXPECT_EQ(command(AddSegments{0, {segment(100, 100, 99.6, -44.7)}}),
              command(AddSegments{0, {segment(100, 100, 100, -45)}}));
}

TEST(RobotEncoder, refusesSpeedsBeyondTheRangeOrNotNumbers)
{
    for (const double bad : {0.501, -0.501, 1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
        expectBadInput(encodeCommand(DirectDrive{{bad, 0.0}}), "left wheel speed");
        expectBadInput(encodeCommand(DirectDrive{{0.0, bad}}), "right wheel speed");
        expectBadInput(encodeCommand(AddSegments{0, {{{bad, 0.0}, 0.1, 0.0}}}), "left wheel speed");
        expectBadInput(encodeCommand(AddSegments{0, {{{0.0, bad}, 0.1, 0.0}}}), "right wheel speed");
    }
}

TEST(RobotEncoder, refusesSegmentsThatDoNotFit)
{
    expectBadInput(encodeCommand(AddSegments{0, {}}), "number of segments is 0");
    expectBadInput(encodeCommand(AddSegments{0, std::vector<DriveSegment>(32)}), "number of segments is 32");
    expectBadInput(
        encodeCommand(AddSegments{std::numeric_limits<std::uint32_t>::max(), std::vector<DriveSegment>(2)}),
        "segment numbers run past");
    expectBadInput(encodeCommand(AddSegments{0, {segment(0, 0, 32768, 0)}}), "end distance");
    expectBadInput(encodeCommand(AddSegments{0, {segment(0, 0, 0, -32769)}}), "end angle");
    expectBadInput(
        encodeCommand(AddSegments{0, {segment(0, 0, std::numeric_limits<double>::quiet_NaN(), 0)}}),
        "end distance");
}

TEST(RobotEncoder, neverTurnsALimitIntoNoLimit)
{
    for (const double small : {0.4, -0.4, 1e-9}) {
        expectBadInput(encodeCommand(AddSegments{0, {segment(-100, 100, small, 0)}}), "end distance");
        expectBadInput(encodeCommand(AddSegments{0, {segment(-100, 100, 0, small)}}), "end angle");
    }
    EXPECT_TRUE(encodeCommand(AddSegments{0, {segment(-100, 100, 0.6, -0.6)}}));
}

TEST(RobotEncoder, namesTheMessageAndTheFirstFieldThatIsWrong)
{
    const auto result = encodeCommand(DirectDrive{{0.7, 0.9}});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().detail,
              "directDrive: left wheel speed (mm/s) is 700.000000, outside -500 to 500");
}

TEST(RobotEncoder, refusesTextsThatAreNotAsciiOrTooLong)
{
    expectBadInput(encodeReportFrame(AssertReport{"\xC3\xA4", 1}), "file name");
    expectBadInput(encodeReportFrame(DebugReport{std::string("a\0b", 3), 1}), "text");
    expectBadInput(encodeReportFrame(AssertReport{std::string(252, 'x'), 1}), "256 bytes");
    expectBadInput(encodeReportDatagram(DebugReport{std::string(250, 'x'), 1}), "256 bytes");
    expectBadInput(encodeReportFrame(AssertReport{"a.c", -1}), "line");
    expectBadInput(encodeReportFrame(AssertReport{"a.c", 65536}), "line");
}

TEST(RobotEncoder, refusesReportsOutsideTheirFields)
{
    const BatteryStatus good{};
    const auto with = [&good](auto change) {
        BatteryStatus battery = good;
        change(battery);
        return encodeReportFrame(SensorUpdate{battery});
    };
    EXPECT_TRUE(encodeReportFrame(SensorUpdate{good}));
    expectBadInput(with([](auto& b) { b.voltage_V = 65.536; }), "voltage");
    expectBadInput(with([](auto& b) { b.voltage_V = -0.001; }), "voltage");
    expectBadInput(with([](auto& b) { b.current_A = 32.768; }), "current");
    expectBadInput(with([](auto& b) { b.current_A = -32.769; }), "current");
    expectBadInput(with([](auto& b) { b.temperature_degC = 128; }), "temperature");
    expectBadInput(with([](auto& b) { b.temperature_degC = -129; }), "temperature");
    expectBadInput(with([](auto& b) { b.charge_Ah = 65.536; }), "charge");
    expectBadInput(with([](auto& b) { b.capacity_Ah = -1.0; }), "capacity");
    expectBadInput(with([](auto& b) { b.charging = static_cast<ChargingState>(6); }), "charging state");
    expectBadInput(encodeReportFrame(SegmentUpdate{0, 0, 32.768, 0.0}), "distance");
    expectBadInput(encodeReportFrame(SegmentUpdate{0, 0, 0.0, radFromDeg(-32769)}), "angle");
    expectBadInput(encodeReportDatagram(StateUpdate{static_cast<RobotState>(9)}), "state");
}
