// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "protocol/trek_dialect.h"
#include "protocol/trek_line.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::protocol {

/// Bytes of one UWB unit -> reports, whatever the reads look like; keeps the counts that the link panel
/// shows. One per connection.
///
/// Lines end with CR, LF or CR LF. USB splits every line, UARTs deliver bursts and lose bytes, line ends too.
/// A line is therefore searched for reports as often as it holds one: neither what stands before a report nor
/// what stands behind it can take the report with it. What is left of a line counts as one drop, by its
/// reason. Where the stream is split changes nothing.
///
/// Memory is bounded (maxLine and the times of its pieces); after the first lines nothing is allocated.
class TrekStream {
public:
    struct Counts {
        std::uint64_t reports = 0;
        std::array<std::uint64_t, trekDropCount> dropped{}; ///< by TrekDrop
        /// Left by a damaged stream.
        std::uint64_t damaged() const;
        /// Text that units are known to print.
        std::uint64_t skipped() const;
        friend bool operator==(const Counts&, const Counts&) = default;
    };
    /// Longest line, bytes; the longest report of any dialect has about 230.
    static constexpr std::size_t maxLine = 512;

    /// `arrival`: when this chunk was received; a report has the time of its first byte. `sink` takes a
    /// const TrekReport&, valid during the call only, and must not feed or reset the stream.
    template<typename Sink>
    void feed(std::string_view bytes, Time arrival, Sink&& sink)
    {
        beginChunk(bytes, arrival);
        while (const TrekReport* report = nextReport())
            sink(*report);
    }
    /// Forgets a half line and the detected dialect, for after a reconnection; the counts stay.
    void reset();
    /// Ends the half line as if its end had come, for the end of a file.
    template<typename Sink>
    void finish(Sink&& sink)
    {
        feed("\n", m_arrival, sink);
    }

    const Counts& counts() const { return m_counts; }
    TrekDialectDetector& dialect() { return m_dialect; }
    const TrekDialectDetector& dialect() const { return m_dialect; }

private:
    /// A piece of the half line begins at an offset and came at a time.
    struct PieceTime {
        std::size_t offset = 0;
        Time arrival;
    };

    void beginChunk(std::string_view bytes, Time arrival);
    const TrekReport* nextReport();
    bool takeLine();
    void endLine(std::size_t n);
    void forgetSearched();
    void beginSearch(std::string_view line);
    void holdBack(std::size_t n);
    void cutOverlong();
    bool findReport();
    void finishReport(Time firstByte);
    void drop(std::string_view text);
    Time timeAt(std::size_t offset) const;

    TrekReport m_report;
    TrekDialectDetector m_dialect;
    Counts m_counts;
    std::string_view m_chunk; ///< what is left of the chunk
    Time m_arrival;           ///< of the chunk

    std::string m_held;              ///< the half line
    std::vector<PieceTime> m_pieces; ///< of m_held
    std::size_t m_searched = 0;      ///< bytes of m_held that m_line covers
    bool m_isOverlong = false;       ///< the beginning of this line was cut off
    bool m_overlongCounted = false;
    bool m_lineHasEnd = false;

    std::string_view m_line;         ///< being searched; in m_held or in the chunk
    std::size_t m_at = 0;            ///< where the search goes on
    std::size_t m_textBegin = 0;     ///< of what is not part of a report
    std::optional<TrekDrop> m_error; ///< of the first report that begins in that text
};

/// "3 noise, 1 over-long": the non-zero counts in words, empty when nothing was dropped or skipped.
std::string dropDetail(const TrekStream::Counts& counts);

} // namespace agv::protocol
