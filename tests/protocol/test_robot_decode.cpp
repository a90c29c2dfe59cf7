// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/robot_samples.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

using namespace agv;
using namespace agv::protocol;

namespace {

Bytes payloadOf(const Result<Bytes>& frame)
{
    return frame ? Bytes(frame->begin() + 2, frame->end()) : Bytes{};
}

void expectReportError(const Bytes& payload, RobotFrameError expected)
{
    const auto report = decodeReportPayload(payload);
    ASSERT_FALSE(report);
    EXPECT_STREQ(toText(report.error()), toText(expected));
}

void expectCommandError(const Bytes& payload, RobotFrameError expected)
{
    const auto command = decodeCommandPayload(payload);
    ASSERT_FALSE(command);
    EXPECT_STREQ(toText(command.error()), toText(expected));
}

} // namespace

TEST(RobotDecoder, decodesEveryCommandItEncodesAtTheExtremesOfItsFields)
{
    for (const RobotCommand& command : samples::commands()) {
        const auto frame = encodeCommand(command);
        ASSERT_TRUE(frame) << frame.error().detail;
        const auto decoded = decodeCommandPayload(payloadOf(frame));
        ASSERT_TRUE(decoded) << "command " << command.index() << ": " << toText(decoded.error());
        EXPECT_EQ(*decoded, command) << "command " << command.index();
    }
}

TEST(RobotDecoder, decodesEveryReportItEncodesAtTheExtremesOfItsFields)
{
    for (const RobotReport& report : samples::reports()) {
        const auto frame = encodeReportFrame(report);
        ASSERT_TRUE(frame) << frame.error().detail;
        const auto decoded = decodeReportPayload(payloadOf(frame));
        ASSERT_TRUE(decoded) << "report " << report.index() << ": " << toText(decoded.error());
        EXPECT_EQ(*decoded, report) << "report " << report.index();

        const auto datagram = encodeReportDatagram(report);
        ASSERT_TRUE(datagram);
        EXPECT_EQ(decodeReportDatagram(*datagram), decoded);
    }
}

TEST(RobotDecoder, refusesEveryTruncationAndEveryExtraByte)
{
    const auto refuses = [](auto decode, const Bytes& payload, std::size_t id) {
        for (std::size_t length = 0; length < payload.size(); ++length) {
            const auto cut =
                decode(Bytes(payload.begin(), payload.begin() + static_cast<std::ptrdiff_t>(length)));
            ASSERT_FALSE(cut) << "message " << id << " cut to " << length << " bytes";
            if (length == 0)
                EXPECT_EQ(cut.error(), RobotFrameError::EmptyPayload);
            else
                EXPECT_TRUE(cut.error() == RobotFrameError::BadLength ||
                            cut.error() == RobotFrameError::BadValue);
        }
        Bytes longer = payload;
        longer.push_back(0);
        const auto decoded = decode(longer);
        ASSERT_FALSE(decoded) << "message " << id;
        EXPECT_EQ(decoded.error(), RobotFrameError::BadLength) << "message " << id;
    };
    for (const RobotCommand& command : samples::commands())
        refuses([](const Bytes& b) { return decodeCommandPayload(b); }, payloadOf(encodeCommand(command)),
                command.index());
    for (const RobotReport& report : samples::reports())
        refuses([](const Bytes& b) { return decodeReportPayload(b); }, payloadOf(encodeReportFrame(report)),
                report.index());
}

TEST(RobotDecoder, namesEveryUnknownId)
{
    for (int id = 6; id <= 255; ++id) {
        expectReportError({static_cast<std::uint8_t>(id), 0, 0}, RobotFrameError::UnknownMessage);
        expectCommandError({static_cast<std::uint8_t>(id)}, RobotFrameError::UnknownMessage);
    }
}

TEST(RobotDecoder, refusesASegmentCountThatDoesNotMatchItsPayload)
{
    const Bytes two = payloadOf(encodeCommand(AddSegments{7, std::vector<DriveSegment>(2)}));
    ASSERT_EQ(two.size(), 22U);
    for (int count = 0; count <= 255; ++count) {
        Bytes payload = two;
        payload[5] = static_cast<std::uint8_t>(count);
        if (count == 2)
            EXPECT_TRUE(decodeCommandPayload(payload));
        else
            expectCommandError(payload, RobotFrameError::BadLength);
    }
    expectCommandError({0, 0, 0, 0, 7, 0}, RobotFrameError::BadValue);
}

TEST(RobotDecoder, refusesSegmentNumbersThatWrapAround)
{
    Bytes payload = payloadOf(encodeCommand(AddSegments{0, std::vector<DriveSegment>(2)}));
    for (std::size_t i = 1; i <= 4; ++i)
        payload[i] = 0xFF;
    expectCommandError(payload, RobotFrameError::BadValue);
    payload[4] = 0xFE;
    EXPECT_TRUE(decodeCommandPayload(payload));
}

TEST(RobotDecoder, refusesWheelSpeedsBeyondTheRange)
{
    EXPECT_TRUE(decodeCommandPayload(Bytes{4, 0x01, 0xF4, 0xFE, 0x0C}));        // 500, -500
    expectCommandError({4, 0x01, 0xF5, 0, 0}, RobotFrameError::BadValue);       // 501
    expectCommandError({4, 0, 0, 0xFE, 0x0B}, RobotFrameError::BadValue);       // -501
    expectCommandError({4, 0x80, 0x00, 0x7F, 0xFF}, RobotFrameError::BadValue); // -32768, 32767
    expectCommandError({0, 0, 0, 0, 0, 1, 0x01, 0xF5, 0, 0, 0, 0, 0, 1}, RobotFrameError::BadValue);
}

TEST(RobotDecoder, refusesStatesAndChargesThatDoNotExist)
{
    for (int state = 0; state <= 255; ++state) {
        const auto report = decodeReportPayload(Bytes{5, static_cast<std::uint8_t>(state)});
        EXPECT_EQ(report.has_value(), state <= 8) << state;
    }
    expectReportError({5, 9}, RobotFrameError::BadValue);
    const Bytes good = payloadOf(encodeReportFrame(SensorUpdate{}));
    for (int value = 0; value <= 255; ++value) {
        Bytes charging = good;
        charging[1] = static_cast<std::uint8_t>(value);
        EXPECT_EQ(decodeReportPayload(charging).has_value(), value <= 5) << value;
        Bytes source = good;
        source.back() = static_cast<std::uint8_t>(value);
        EXPECT_EQ(decodeReportPayload(source).has_value(), value <= 3) << value;
    }
}

TEST(RobotDecoder, refusesTextsWithoutEndOrWithBytesThatAreNotAscii)
{
    expectReportError({0, 'a', '.', 'c'}, RobotFrameError::BadValue);
    expectReportError({1, 'a'}, RobotFrameError::BadValue);
    expectReportError({0, 'a', 0xE4, 0, 0, 1}, RobotFrameError::BadValue);
    expectReportError({1, 0x80, 0, 0, 0, 0, 1}, RobotFrameError::BadValue);
}

TEST(RobotDecoder, refusesDatagramsOfAnotherTypeEmptyOnesAndOnesLongerThanAFrame)
{
    const auto errorOf = [](const Bytes& datagram) {
        const auto report = decodeReportDatagram(datagram);
        return report ? std::string("good") : std::string(toText(report.error()));
    };
    EXPECT_EQ(errorOf({}), "empty");
    EXPECT_EQ(errorOf({2}), "empty");
    EXPECT_EQ(errorOf({2, 5, 0}), "good");
    for (int type = 0; type <= 255; ++type)
        EXPECT_EQ(errorOf({static_cast<std::uint8_t>(type), 5, 0}), type == 2 ? "good" : "unknown type");
    EXPECT_EQ(errorOf({2, 77}), "unknown message");
    Bytes oversized{2, 1};
    oversized.insert(oversized.end(), 1000, 'x');
    EXPECT_EQ(errorOf(oversized), "bad length");
}

TEST(RobotDecoder, hasWordsForEveryError)
{
    std::set<std::string> words;
    for (std::size_t i = 0; i < robotFrameErrorCount; ++i)
        words.insert(toText(static_cast<RobotFrameError>(i)));
    EXPECT_EQ(words.size(), robotFrameErrorCount);
    EXPECT_FALSE(words.contains("unknown"));
}
