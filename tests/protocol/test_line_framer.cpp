// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/line_framer.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace agv::protocol;
using Lines = std::vector<std::string>;

namespace {

Lines linesOf(LineFramer& framer, std::string_view bytes)
{
    Lines lines;
    framer.feed(bytes, [&lines](std::string_view line) { lines.emplace_back(line); });
    return lines;
}

Lines linesOf(std::string_view bytes, std::size_t maxLength = 256)
{
    LineFramer framer(maxLength);
    return linesOf(framer, bytes);
}

} // namespace

TEST(LineFramer, endsALineAtCrLfCrLfAndTheLiteral)
{
    EXPECT_EQ(linesOf("a\rb\nc\r\nd<\\r>e\n\rf\r"), (Lines{"a", "b", "c", "d", "e", "f"}));
}

TEST(LineFramer, passesNoEmptyAndNoBlankLines)
{
    EXPECT_EQ(linesOf("\r\r\n\n<\\r><\\r>  \r\t \n a \r"), (Lines{" a "}));
    EXPECT_TRUE(isBlankLine(""));
    EXPECT_TRUE(isBlankLine(" \t "));
    EXPECT_FALSE(isBlankLine(" x"));
}

TEST(LineFramer, holdsBackALineWithoutEnd)
{
    LineFramer framer;
    EXPECT_EQ(linesOf(framer, "abc"), Lines{});
    EXPECT_EQ(framer.pendingBytes(), 3U);
    EXPECT_EQ(linesOf(framer, "def\r"), Lines{"abcdef"});
    EXPECT_EQ(framer.pendingBytes(), 0U);
}

TEST(LineFramer, keepsWhatOnlyLooksLikeTheLiteralEnd)
{
    EXPECT_EQ(linesOf("a<b\r<\\\r<\\r\r<\\R>\r<<\\r>"), (Lines{"a<b", "<\\", "<\\r", "<\\R>", "<"}));
    EXPECT_EQ(linesOf("<\\<\\r>x\r"), (Lines{"<\\", "x"}));
}

TEST(LineFramer, keepsBytesThatAreNotAscii)
{
    const std::string line("\x00\xff\x80x", 4);
    EXPECT_EQ(linesOf(line + "\r"), Lines{line});
}

TEST(LineFramer, dropsALineOneByteTooLongAndNotOneOfFullLength)
{
    for (const char* const end : {"\r", "\n", "\r\n", "<\\r>"}) {
        LineFramer framer(8);
        EXPECT_EQ(linesOf(framer, "12345678" + std::string(end) + "123456789" + end + "ok" + end),
                  (Lines{"12345678", "ok"}))
            << end;
        EXPECT_EQ(framer.overlongLines(), 1U);
    }
}

TEST(LineFramer, countsTheBeginningOfALiteralThatNeverCameAsLength)
{
    LineFramer framer(4);
    EXPECT_EQ(linesOf(framer, "123<\r12<\\\r1234<\\r\n12<\\\r"), (Lines{"123<", "12<\\", "12<\\"}));
    EXPECT_EQ(framer.overlongLines(), 1U);
}

TEST(LineFramer, countsAnOverlongLineOnceAndBeforeItsEndComes)
{
    LineFramer framer(4);
    EXPECT_EQ(linesOf(framer, std::string(100'000, 'x')), Lines{});
    EXPECT_EQ(framer.overlongLines(), 1U);
    EXPECT_EQ(framer.pendingBytes(), 0U);
    EXPECT_EQ(linesOf(framer, "<\\"), Lines{});
    EXPECT_EQ(linesOf(framer, "r>good\r"), Lines{"good"});
    EXPECT_EQ(framer.overlongLines(), 1U);
}

TEST(LineFramer, forgetsHalfALineHalfALiteralAndAnOverlongLineOnReset)
{
    LineFramer framer(4);
    linesOf(framer, "ab");
    framer.reset();
    EXPECT_EQ(linesOf(framer, "cd\r"), Lines{"cd"});
    linesOf(framer, "<\\r");
    framer.reset();
    EXPECT_EQ(linesOf(framer, ">\r"), Lines{">"});
    linesOf(framer, "123456");
    framer.reset();
    EXPECT_EQ(linesOf(framer, "ef\r"), Lines{"ef"});
    EXPECT_EQ(framer.overlongLines(), 1U);
}

TEST(LineFramer, tellsWhereInTheStreamALineBegan)
{
    LineFramer framer;
    std::vector<std::uint64_t> starts;
    const auto note = [&](std::string_view) { starts.push_back(framer.lineStart()); };
    framer.feed("ab\r\ncd", note);
    EXPECT_EQ(framer.streamPosition(), 6U);
    framer.feed("ef\r", note);
    EXPECT_EQ(starts, (std::vector<std::uint64_t>{0, 4}));
}

TEST(LineFramer, givesTheSameLinesAtEverySplit)
{
    const std::string stream = "one\r\ntwo<\\r>three\n\n<\\<\\r>much too long a line<\\r>four\rfive\r\n";
    LineFramer whole(10);
    const Lines expected = linesOf(whole, stream);
    ASSERT_EQ(expected, (Lines{"one", "two", "three", "<\\", "four", "five"}));
    for (std::size_t i = 0; i <= stream.size(); ++i) {
        for (std::size_t j = i; j <= stream.size(); ++j) {
            LineFramer framer(10);
            Lines lines;
            for (const auto& part : {stream.substr(0, i), stream.substr(i, j - i), stream.substr(j)})
                framer.feed(part, [&lines](std::string_view line) { lines.emplace_back(line); });
            ASSERT_EQ(lines, expected) << "split at " << i << " and " << j;
            ASSERT_EQ(framer.overlongLines(), whole.overlongLines());
            ASSERT_EQ(framer.streamPosition(), stream.size());
        }
    }
}
