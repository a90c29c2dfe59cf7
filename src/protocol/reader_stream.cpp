// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/reader_stream.h"

#include "protocol/drop_text.h"

#include <numeric>

namespace agv::protocol {

namespace {

constexpr std::string_view readBegin = "SCAN:";

} // namespace

std::uint64_t ReaderStream::Counts::droppedTotal() const
{
    return std::accumulate(dropped.begin(), dropped.end(), std::uint64_t{0});
}

void ReaderStream::feed(std::string_view bytes, const ReportSink& sink)
{
    feed(bytes, Time{}, [&sink](const ReaderReport& report, Time) { sink(report); });
}

void ReaderStream::feed(std::string_view bytes, Time arrival, const TimedReportSink& sink)
{
    const std::uint64_t chunkStart = m_framer.streamPosition();
    const auto lineTime = [&] { return m_framer.lineStart() < chunkStart ? m_pendingSince : arrival; };
    m_framer.feed(bytes, [&](std::string_view line) { decodeLine(line, lineTime(), sink); });
    m_pendingSince = lineTime();
}

void ReaderStream::decodeLine(std::string_view line, Time firstByte, const TimedReportSink& sink)
{
    // From 1: a "SCAN:" at the very start begins the first piece.
    for (std::size_t cut = line.find(readBegin, 1); cut != std::string_view::npos;
         cut = line.find(readBegin, 1)) {
        decodePiece(line.substr(0, cut), firstByte, sink);
        line.remove_prefix(cut);
    }
    decodePiece(line, firstByte, sink);
}

void ReaderStream::decodePiece(std::string_view piece, Time firstByte, const TimedReportSink& sink)
{
    if (isBlankLine(piece))
        return;
    const auto report = decodeReaderLine(piece);
    if (!report) {
        ++m_counts.dropped[static_cast<std::size_t>(report.error())];
        return;
    }
    if (std::holds_alternative<CompleteRead>(*report) || std::holds_alternative<Rc522Read>(*report))
        ++m_counts.complete;
    else if (std::holds_alternative<IncompleteRead>(*report))
        ++m_counts.incomplete;
    else
        ++m_counts.other;
    sink(*report, firstByte);
}

ReaderStream::Counts ReaderStream::counts() const
{
    Counts counts = m_counts;
    counts.dropped[static_cast<std::size_t>(ReaderLineError::Overlong)] = m_framer.overlongLines();
    return counts;
}

std::string dropDetail(const ReaderStream::Counts& counts)
{
    return dropText<ReaderLineError>(counts.dropped);
}

} // namespace agv::protocol
