// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_stream.h"

#include "protocol/drop_text.h"
#include "protocol/trek_line_parts.h"

#include <algorithm>
#include <utility>

namespace agv::protocol {

namespace {

bool isUlm(UwbDialect dialect) { return dialect == UwbDialect::UlmFour || dialect == UwbDialect::UlmEight; }

std::uint8_t usableRanges(const TrekReport& report, UwbDialect dialect)
{
    unsigned measured = 0;
    for (std::size_t k = 0; k < report.rangeCount; ++k)
        measured |= (report.range_mm[k] > 0 ? 1U : 0U) << k;
    return static_cast<std::uint8_t>(isUlm(dialect) ? measured : measured & report.mask);
}

std::int64_t deviceTime_ms(const TrekReport& report, UwbDialect dialect)
{
    switch (report.kind) {
    case TrekLineKind::Corrected:
    case TrekLineKind::Anchors: {
        const auto time = trekTime_ms(report.debug, dialect);
        return time ? std::int64_t{*time} : -1;
    }
    case TrekLineKind::Single:
        return report.debug;
    case TrekLineKind::Imu:
        return report.deviceTime_ms;
    case TrekLineKind::Raw:
        break; // its debug field holds antenna delays
    }
    return -1;
}

TrekDrop reasonOf(std::string_view text)
{
    constexpr auto isText = [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; };
    // Its last byte, the configuration, may be anything.
    if (text.starts_with("nVer"))
        return TrekDrop::HandshakeReply;
    if (!std::ranges::all_of(text, isText))
        return TrekDrop::Noise;
    if (isTrekTimeoutNote(text))
        return TrekDrop::TimeoutNote;
    if (text.starts_with("me "))
        return TrekDrop::EventCounters;
    return text.starts_with('$') ? TrekDrop::CloneText : TrekDrop::OtherText;
}

std::uint64_t countWhere(const TrekStream::Counts& counts, bool damage)
{
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < trekDropCount; ++i)
        sum += isDamage(static_cast<TrekDrop>(i)) == damage ? counts.dropped[i] : 0;
    return sum;
}

} // namespace

std::uint64_t TrekStream::Counts::damaged() const { return countWhere(*this, true); }
std::uint64_t TrekStream::Counts::skipped() const { return countWhere(*this, false); }

void TrekStream::beginChunk(std::string_view bytes, Time arrival)
{
    m_chunk = bytes;
    m_arrival = arrival;
}

const TrekReport* TrekStream::nextReport()
{
    do {
        if (findReport())
            return &m_report;
    } while (takeLine());
    return nullptr;
}

/// Makes the next line, or the front of an over-long one, the one to search. False at the end of the chunk.
bool TrekStream::takeLine()
{
    forgetSearched();
    while (!m_chunk.empty()) {
        const std::size_t room = maxLine - m_held.size();
        const std::string_view window = m_chunk.substr(0, room + 1);
        const std::size_t lineFeed = std::min(window.find('\n'), window.size());
        const std::size_t end = std::min(window.substr(0, lineFeed).find('\r'), lineFeed);
        if (end == window.size() && end <= room) {
            holdBack(end);
            return false;
        }
        if (end == window.size()) {
            holdBack(room);
            cutOverlong();
            return true;
        }
        endLine(end);
        if (!m_line.empty())
            return true;
        forgetSearched();
    }
    return false;
}

/// The line ends `n` bytes into the chunk. Where nothing was held back it is searched in place.
void TrekStream::endLine(std::size_t n)
{
    m_lineHasEnd = true;
    if (m_held.empty()) {
        beginSearch(m_chunk.substr(0, n));
        m_chunk.remove_prefix(n);
    } else {
        holdBack(n);
        m_searched = m_held.size();
        beginSearch(m_held);
    }
    m_chunk.remove_prefix(1);
}

void TrekStream::holdBack(std::size_t n)
{
    if (n == 0)
        return;
    if (m_pieces.empty() || m_pieces.back().arrival != m_arrival)
        m_pieces.push_back({m_held.size(), m_arrival});
    m_held.append(m_chunk.substr(0, n));
    m_chunk.remove_prefix(n);
}

/// A report may have begun in the line held back, whatever stood before it: that part stays.
void TrekStream::cutOverlong()
{
    const std::string_view held = m_held;
    const auto mayBegin = [&](std::size_t at) {
        return held.size() - at < 5 || beginsTrekReport(held.substr(at));
    };
    std::size_t cut = held.rfind('m');
    while (cut != std::string_view::npos && cut > 0 && !mayBegin(cut))
        cut = held.rfind('m', cut - 1);
    if (cut == std::string_view::npos || cut == 0)
        cut = held.size();
    m_isOverlong = true;
    m_searched = cut;
    beginSearch(held.substr(0, cut));
}

void TrekStream::beginSearch(std::string_view line)
{
    m_line = line;
    m_at = 0;
    m_textBegin = 0;
    m_error.reset();
}

void TrekStream::forgetSearched()
{
    beginSearch({});
    if (m_lineHasEnd)
        m_isOverlong = m_overlongCounted = false;
    m_lineHasEnd = false;
    if (m_searched == 0)
        return;
    m_held.erase(0, m_searched);
    const auto isLater = [this](const PieceTime& piece) { return piece.offset > m_searched; };
    const auto later = std::ranges::find_if(m_pieces, isLater);
    m_pieces.erase(m_pieces.begin(), m_held.empty() ? m_pieces.end() : later - 1);
    for (PieceTime& piece : m_pieces)
        piece.offset -= std::min(piece.offset, m_searched);
    m_searched = 0;
}

/// Searches on in the line; at its end counts what is left of it.
bool TrekStream::findReport()
{
    while (m_at < m_line.size()) {
        const std::string_view rest = m_line.substr(m_at);
        if (beginsTrekReport(rest)) {
            const auto length = decodeTrekReport(rest, m_report);
            if (length) {
                drop(m_line.substr(m_textBegin, m_at - m_textBegin));
                finishReport(timeAt(m_at));
                m_at += *length;
                m_textBegin = m_at;
                return true;
            }
            if (!m_error)
                m_error = length.error();
        }
        m_at = std::min(m_line.find('m', m_at + 1), m_line.size());
    }
    drop(m_line.substr(m_textBegin));
    m_textBegin = m_line.size();
    return false;
}

void TrekStream::finishReport(Time firstByte)
{
    m_dialect.observe(m_report);
    const UwbDialect dialect = m_dialect.dialect();
    m_report.usable = usableRanges(m_report, dialect);
    m_report.deviceTime_ms = deviceTime_ms(m_report, dialect);
    m_report.firstByte = firstByte;
    ++m_counts.reports;
}

void TrekStream::drop(std::string_view text)
{
    const auto error = std::exchange(m_error, std::nullopt);
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos)
        return;
    text.remove_prefix(begin);
    if (m_isOverlong && std::exchange(m_overlongCounted, true))
        return;
    const TrekDrop reason = m_isOverlong ? TrekDrop::Overlong : error.value_or(reasonOf(text));
    ++m_counts.dropped[static_cast<std::size_t>(reason)];
    m_dialect.observeText(text);
}

Time TrekStream::timeAt(std::size_t offset) const
{
    const auto piece = std::find_if(m_pieces.rbegin(), m_pieces.rend(),
                                    [offset](const PieceTime& p) { return p.offset <= offset; });
    return piece == m_pieces.rend() ? m_arrival : piece->arrival;
}

void TrekStream::reset()
{
    beginSearch({});
    m_chunk = {};
    m_held.clear();
    m_pieces.clear();
    m_searched = 0;
    m_isOverlong = m_overlongCounted = m_lineHasEnd = false;
    m_dialect.reset();
}

std::string dropDetail(const TrekStream::Counts& counts) { return dropText<TrekDrop>(counts.dropped); }

} // namespace agv::protocol
