// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/serial_capture.h"

#include "core/random.h"

#include <gtest/gtest.h>

using namespace agv;
using namespace agv::recording;
using namespace std::chrono_literals;

namespace {

constexpr Time begin = Time{} + 1000s;

} // namespace

TEST(SerialCapture, isReadableText)
{
    std::string text;
    SerialCaptureWriter writer([&text](std::string_view line) { text += line; }, begin);
    writer.note("port /dev/ttyACM0 0483:5740\n");
    writer.bytes("mc 0f 00000663\r", begin + 1500us);
    writer.bytes(std::string("\n\x00\xff\\@#", 6), begin + 100ms);
    EXPECT_EQ(text, "# agv-uwb-capture 1\n# port /dev/ttyACM0 0483:5740\\n\n@1.5 mc 0f 00000663\\r\n"
                    "@100 \\n\\x00\\xFF\\\\@#\n");
}

TEST(SerialCapture, losesNoByteAndNoRead)
{
    std::string text;
    SerialCaptureWriter writer([&text](std::string_view line) { text += line; }, begin);
    SplitMix64 random(3);
    std::vector<SerialChunk> sent;
    for (int i = 0; i < 300; ++i) {
        SerialChunk chunk{i * 12500us, {}};
        for (std::uint64_t n = random.next() % 70; n > 0; --n)
            chunk.bytes += static_cast<char>(random.next() & 0xFFU);
        writer.bytes(chunk.bytes, begin + chunk.since);
        sent.push_back(chunk);
    }
    const SerialCapture capture = readSerialCapture(text);
    EXPECT_TRUE(capture.hasTimes);
    EXPECT_EQ(capture.chunks, sent);
    EXPECT_TRUE(capture.problems.empty());
}

TEST(SerialCapture, takesAnyOtherTextAsBytesWithoutTimes)
{
    const std::string text = "mc 0f 00000663\r\n@1.5 not escaped \\r\n";
    const SerialCapture capture = readSerialCapture(text);
    EXPECT_FALSE(capture.hasTimes);
    ASSERT_EQ(capture.chunks.size(), 1U);
    EXPECT_EQ(capture.chunks[0].bytes, text);
}

TEST(SerialCapture, namesTheLinesThatAreNoReadAndGoesOn)
{
    const SerialCapture capture = readSerialCapture(
        "# agv-uwb-capture 1\n@x a\n@1 a\\\n@1 \\q\n@1 \\x0\n@1 \\x0g\n@-1 a\nmc 0f\n@2 ok\n@3\n");
    ASSERT_EQ(capture.chunks.size(), 2U);
    EXPECT_EQ(capture.chunks[0], (SerialChunk{2ms, "ok"}));
    EXPECT_EQ(capture.chunks[1], (SerialChunk{3ms, ""}));
    ASSERT_EQ(capture.problems.count(), 7U);
    EXPECT_EQ(capture.problems.kept()[0].line, 2);
    EXPECT_EQ(capture.problems.kept()[6].line, 8);
}

TEST(SerialCapture, isToldFromOtherTextByItsLines)
{
    EXPECT_TRUE(looksLikeRawCapture("boot\r\n\r\nma 0e 00000000"));
    EXPECT_TRUE(looksLikeRawCapture("mi,1.5,0.5"));
    EXPECT_TRUE(looksLikeRawCapture("ma00 t00 00000650"));
    EXPECT_FALSE(looksLikeRawCapture("many lines\nmicrosecond"));
}
