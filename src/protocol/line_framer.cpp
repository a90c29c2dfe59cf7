// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/line_framer.h"

namespace agv::protocol {

namespace {

constexpr std::string_view literalEnd = "<\\r>";

} // namespace

void LineFramer::feed(std::string_view bytes, const LineSink& sink)
{
    for (const char byte : bytes) {
        if (byte == '\r' || byte == '\n') {
            endLine(0, sink);
        } else {
            take(byte);
            if (m_literalMatched == literalEnd.size())
                endLine(literalEnd.size(), sink);
        }
        ++m_position;
    }
}

void LineFramer::take(char byte)
{
    // '<' occurs in the literal only at its start, so a mismatch can fall back to length 1 or 0.
    if (byte == literalEnd[m_literalMatched])
        ++m_literalMatched;
    else
        m_literalMatched = byte == literalEnd.front() ? 1 : 0;

    if (m_discarding)
        return;
    if (m_line.empty())
        m_lineStart = m_position;
    m_line.push_back(byte);
    // Characters that may still turn out to be the end do not count as length.
    if (m_line.size() - m_literalMatched > m_maxLength) {
        ++m_overlongLines;
        m_discarding = true;
        m_line.clear();
    }
}

void LineFramer::endLine(std::size_t lengthOfEnd, const LineSink& sink)
{
    if (!m_discarding) {
        const std::string_view line = std::string_view(m_line).substr(0, m_line.size() - lengthOfEnd);
        // "<\r" was not counted as length while it could have become the end, but it did not.
        if (line.size() > m_maxLength)
            ++m_overlongLines;
        else if (!isBlankLine(line))
            sink(line);
    }
    reset();
}

void LineFramer::reset()
{
    m_line.clear();
    m_literalMatched = 0;
    m_discarding = false;
}

} // namespace agv::protocol
