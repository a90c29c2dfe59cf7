// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/range_measurement.h"
#include "protocol/trek_line.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace agv::protocol {

/// The ranges of one report; no memory of its own.
class RangeSet {
public:
    void add(const RangeMeasurement& range) { m_ranges[m_count++] = range; } ///< @pre fewer than 8
    std::size_t size() const { return m_count; }
    bool empty() const { return m_count == 0; }
    const RangeMeasurement* begin() const { return m_ranges.data(); }
    const RangeMeasurement* end() const { return m_ranges.data() + m_count; }
    const RangeMeasurement& operator[](std::size_t i) const { return m_ranges[i]; }

private:
    std::array<RangeMeasurement, mostTrekRanges> m_ranges{};
    std::size_t m_count = 0;
};

/// What was heard of one tag.
struct TagTraffic {
    std::uint64_t reports = 0;
    std::uint64_t missed = 0;    ///< exchanges that the gaps of RSEQ say were lost
    std::uint64_t repeated = 0;  ///< reports with the RSEQ of the one before
    std::uint64_t restarts = 0;  ///< RSEQ went back, or on by more than half its range
    double reportPeriod_s = 0.0; ///< measured, median of the last ones; 0: not known yet
    int lastSequence = -1;
    double lastArrival_s = 0.0; ///< in the time base of the reader
};

/// Reports -> ranges in SI, with the age of the data taken off, and the traffic of every tag. One per
/// connection, behind a TrekStream.
///
/// The ranges in a report come from the exchange before, so they are one report period of the tag old when
/// its first byte arrives. The period is the one of the unit's configuration (setReportPeriod) or, for units
/// that do not tell, the median of the last seven times between reports; until three are known nothing is
/// taken off and RangeMeasurement::reportPeriod_s is 0.
///
///  * Used: mc lines, lines of firmware 1.06, mi lines. mr lines repeat their mc uncorrected: no ranges.
///  * ma lines with four ranges: r1 = A0-A1, r2 = A0-A2, r3 = A1-A2. Which pairs eight ranges would be is not
///    known: no ranges.
///  * RSEQ counts modulo 256: after a silence of more than 128 exchanges the number missed is not known.
class TrekRanges {
public:
    enum class TimeBase : std::uint8_t {
        Arrival,     ///< of the first byte of the line
        DeviceClock, ///< of the unit, s since its start; for captures without times. A line without a time
                     ///< counts as one period, 0.1 s when that is not known, after the one before.
    };

    explicit TrekRanges(TimeBase base = TimeBase::Arrival) : m_base(base), m_tags(mostTags) {}

    /// From UwbConfiguration::reportPeriod_s(); nothing: measure it.
    void setReportPeriod(std::optional<double> period_s) { m_period_s = period_s; }
    RangeSet read(const TrekReport& report);

    /// @pre 0 <= tag < mostTags
    const TagTraffic& traffic(int tag) const { return m_tags[static_cast<std::size_t>(tag)].traffic; }
    /// All that were heard, rising.
    std::vector<int> tags() const;
    /// After a reconnection: the next report of a tag begins a new sequence; the counts stay.
    void reset();

    static constexpr std::size_t mostTags = 256;

private:
    static constexpr std::size_t mostPeriods = 7;
    struct Tag {
        TagTraffic traffic;
        std::array<float, mostPeriods> periods_s{}; ///< a ring
        std::size_t periodCount = 0;                ///< since the last reset
        double lastTime_s = 0.0;                    ///< of the ranges given
        bool isFresh = true;                        ///< nothing heard since the last reset
    };

    double timeOf_s(const TrekReport& report);
    void follow(Tag& tag, const TrekReport& report, double time_s);
    void addPeriod(Tag& tag, double period_s);
    RangeSet tagRanges(const TrekReport& report, double time_s, double period_s) const;

    TimeBase m_base;
    std::optional<double> m_period_s;
    std::vector<Tag> m_tags;
    double m_lastDeviceTime_s = 0.0;
};

} // namespace agv::protocol
