// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "protocol/line_framer.h"
#include "protocol/reader_line.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace agv::protocol {

/// Bytes of one reader -> reports; keeps the counts that the link panel shows. One per connection.
///
/// The reader's bytes pass a software UART that may lose some, line ends too. A line is therefore cut again
/// before every "SCAN:" inside it, and each piece is judged by itself: what stands before a read, noise or a
/// damaged line, cannot take the read with it.
class ReaderStream {
public:
    struct Counts {
        std::uint64_t complete = 0;                                ///< CompleteRead, Rc522Read
        std::uint64_t incomplete = 0;                              ///< IncompleteRead
        std::uint64_t other = 0;                                   ///< OK, inventory headers
        std::array<std::uint64_t, readerLineErrorCount> dropped{}; ///< by ReaderLineError
        std::uint64_t droppedTotal() const;
        friend bool operator==(const Counts&, const Counts&) = default;
    };
    /// A sink must not feed or reset the stream that calls it.
    using ReportSink = std::function<void(const ReaderReport&)>;
    /// `firstByte`: arrival of the chunk in which the line of the report began.
    using TimedReportSink = std::function<void(const ReaderReport&, Time firstByte)>;

    void feed(std::string_view bytes, const ReportSink& sink);
    /// `arrival`: when this chunk was received; the time of a read is that of the first byte of its line.
    void feed(std::string_view bytes, Time arrival, const TimedReportSink& sink);
    /// Forgets a half line (after a reconnection); the counts stay.
    void reset() { m_framer.reset(); }
    Counts counts() const;

private:
    void decodeLine(std::string_view line, Time firstByte, const TimedReportSink& sink);
    void decodePiece(std::string_view piece, Time firstByte, const TimedReportSink& sink);

    LineFramer m_framer;
    Counts m_counts;
    Time m_pendingSince; ///< arrival of the first byte of the half line held back
};

/// "3 noise, 1 over-long": the non-zero counts in words, empty when nothing was dropped.
std::string dropDetail(const ReaderStream::Counts& counts);

} // namespace agv::protocol
