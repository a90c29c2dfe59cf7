// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace agv {

enum class RangeKind : std::uint8_t {
    TagAnchor,    ///< a tag and an anchor
    AnchorAnchor, ///< two anchors, for finding the anchors' own places
};

/// One distance between two UWB units, as every source of ranges (serial line, log, range table, simulated
/// kit) gives it and every estimator takes it. Trivially copyable, no memory of its own.
struct RangeMeasurement {
    /// When the distance was true, s: the age of the report is already taken off. Live it counts from the
    /// epoch of the steady clock and never falls for one tag. In a file it is that file's own time, which may
    /// step back where recordings were joined: a filter starts anew there.
    double time_s = 0.0;
    double range_m = 0.0; ///< as measured, finite and > 0, not corrected by the plant's correction table
    /// Time between two reports of this tag and so the age already taken off time_s, s; 0: not known, then
    /// time_s is the time of the report.
    double reportPeriod_s = 0.0;
    std::int32_t tag = 0;       ///< id of the tag; AnchorAnchor: of the first anchor
    std::int32_t anchor = 0;    ///< id of the anchor as in UwbAnchor::id; AnchorAnchor: of the second one
    std::int32_t sequence = -1; ///< number of the exchange, 0..255 and wrapping (RSEQ); -1: not known
    RangeKind kind = RangeKind::TagAnchor;

    friend bool operator==(const RangeMeasurement&, const RangeMeasurement&) = default;
};

} // namespace agv
