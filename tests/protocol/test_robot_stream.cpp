// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/robot_samples.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

using namespace agv;
using namespace agv::protocol;

namespace {

template<typename Message>
std::vector<Message> feed(MessageStream<Message>& stream, std::span<const std::uint8_t> bytes)
{
    std::vector<Message> messages;
    stream.feed(bytes, [&messages](const Message& message) { messages.push_back(message); });
    return messages;
}

void append(Bytes& bytes, const Result<Bytes>& frame)
{
    ASSERT_TRUE(frame) << frame.error().detail;
    bytes.insert(bytes.end(), frame->begin(), frame->end());
}

Bytes allReports()
{
    Bytes bytes;
    for (const RobotReport& report : samples::reports())
        append(bytes, encodeReportFrame(report));
    return bytes;
}

Bytes allCommands()
{
    Bytes bytes;
    for (const RobotCommand& command : samples::commands())
        append(bytes, encodeCommand(command));
    return bytes;
}

/// One frame of every reason to drop it, each followed by a good one.
Bytes damagedReports()
{
    const Bytes good{1, 2, 5, 3};
    Bytes bytes;
    for (const Bytes& bad : {Bytes{9, 2, 5, 3}, Bytes{0, 1, 1}, Bytes{2, 2, 5, 3}, Bytes{1, 3, 77, 1, 2},
                             Bytes{1, 3, 5, 0, 0}, Bytes{1, 2, 5, 9}, Bytes{1, 0}}) {
        bytes.insert(bytes.end(), bad.begin(), bad.end());
        bytes.insert(bytes.end(), good.begin(), good.end());
    }
    return bytes;
}

/// Every split into two pieces, and byte by byte, gives the messages and counts of the whole.
template<typename Message>
void expectSameAtEverySplit(const Bytes& bytes, const std::vector<Message>& expected,
                            const FrameCounts& counts)
{
    const std::span<const std::uint8_t> all(bytes);
    for (std::size_t i = 0; i <= bytes.size(); ++i) {
        MessageStream<Message> stream;
        auto messages = feed(stream, all.first(i));
        for (const Message& message : feed(stream, all.subspan(i)))
            messages.push_back(message);
        ASSERT_EQ(messages, expected) << "split at " << i;
        ASSERT_EQ(stream.counts(), counts) << "split at " << i;
        ASSERT_EQ(stream.pendingBytes(), 0U);
    }
    MessageStream<Message> stream;
    std::vector<Message> messages;
    for (const std::uint8_t& byte : bytes)
        stream.feed(std::span(&byte, 1),
                    [&messages](const Message& message) { messages.push_back(message); });
    EXPECT_EQ(messages, expected);
    EXPECT_EQ(stream.counts(), counts);
}

} // namespace

TEST(RobotStream, givesEveryReportAtEverySplit)
{
    FrameCounts counts;
    counts.good = samples::reports().size();
    expectSameAtEverySplit(allReports(), samples::reports(), counts);
}

TEST(RobotStream, givesEveryCommandAtEverySplit)
{
    FrameCounts counts;
    counts.good = samples::commands().size();
    expectSameAtEverySplit(allCommands(), samples::commands(), counts);
}

TEST(RobotStream, countsEveryDroppedFrameByItsReasonAndFindsTheNextOneAtEverySplit)
{
    FrameCounts counts;
    counts.good = 7;
    counts.dropped = {3, 1, 1, 1, 1};
    expectSameAtEverySplit(damagedReports(),
                           std::vector<RobotReport>(7, StateUpdate{RobotState::DirectDriving}), counts);
    EXPECT_EQ(counts.droppedTotal(), 7U);
    EXPECT_EQ(dropDetail(counts), "3 unknown type, 1 unknown message, 1 bad length, 1 bad value, 1 empty");
    EXPECT_EQ(dropDetail(FrameCounts{}), "");
}

TEST(RobotStream, dropsCommandsThatComeFromTheWrongSide)
{
    ReportStream reports;
    EXPECT_TRUE(feed(reports, allCommands()).empty());
    EXPECT_EQ(reports.counts().dropped[static_cast<std::size_t>(RobotFrameError::UnknownType)],
              samples::commands().size());
    CommandStream commands;
    EXPECT_TRUE(feed(commands, allReports()).empty());
    EXPECT_EQ(commands.counts().droppedTotal(), samples::reports().size());
}

TEST(RobotStream, holdsBackHalfAFrameAndForgetsItOnReset)
{
    ReportStream stream;
    EXPECT_TRUE(feed(stream, Bytes{1}).empty());
    EXPECT_TRUE(feed(stream, Bytes{2, 5}).empty());
    EXPECT_EQ(stream.pendingBytes(), 3U);
    stream.reset();
    EXPECT_EQ(stream.pendingBytes(), 0U);
    EXPECT_EQ(feed(stream, Bytes{1, 2, 5, 4}).size(), 1U);
    EXPECT_EQ(stream.counts().good, 1U);
    EXPECT_EQ(stream.counts().droppedTotal(), 0U);
}

TEST(RobotStream, neverHoldsBackMoreThanOneFrame)
{
    ReportStream stream;
    for (int i = 0; i < 10'000; ++i) {
        feed(stream, Bytes{1, 255, 7});
        ASSERT_LE(stream.pendingBytes(), 256U);
    }
    EXPECT_EQ(stream.counts().good, 0U);
    EXPECT_GT(stream.counts().droppedTotal(), 0U);
}
