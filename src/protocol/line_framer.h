// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace agv::protocol {

/// True for lines of nothing but spaces and tabs, and for empty ones.
inline bool isBlankLine(std::string_view line)
{
    return line.find_first_not_of(" \t") == std::string_view::npos;
}

/// Cuts a byte stream into lines. Ends of line: CR, LF, CR LF, and the four characters "<\r>" that the old
/// program met. Half lines are kept until their end arrives; where the stream is split changes nothing.
/// Lines of nothing but blanks are not passed on. A line longer than maxLength is dropped whole and counted.
class LineFramer {
public:
    /// `line` is valid during the call only. A sink must not feed or reset the framer that calls it.
    using LineSink = std::function<void(std::string_view line)>;

    /// maxLength: bytes of a line without its end. Memory never exceeds it by more than 3 bytes.
    explicit LineFramer(std::size_t maxLength = 256) : m_maxLength(maxLength) {}

    /// Passes every complete line to `sink`, without its end.
    void feed(std::string_view bytes, const LineSink& sink);

    /// Forgets a half line, e.g. after a reconnection; the count stays.
    void reset();

    /// Counted as soon as a line is over-long, even if its end never comes.
    std::uint64_t overlongLines() const { return m_overlongLines; }
    /// Bytes of the half line held back.
    std::size_t pendingBytes() const { return m_line.size(); }
    /// Bytes fed so far; with lineStart() it tells in which chunk a line began.
    std::uint64_t streamPosition() const { return m_position; }
    /// Position in the stream of the first byte of the line being passed or held back.
    std::uint64_t lineStart() const { return m_lineStart; }

private:
    void take(char byte);
    void endLine(std::size_t lengthOfEnd, const LineSink& sink);

    std::size_t m_maxLength;
    std::string m_line;
    std::size_t m_literalMatched = 0; ///< characters of "<\r>" at the end of what has been taken
    bool m_discarding = false;        ///< inside an over-long line
    std::uint64_t m_overlongLines = 0;
    std::uint64_t m_position = 0;
    std::uint64_t m_lineStart = 0;
};

} // namespace agv::protocol
