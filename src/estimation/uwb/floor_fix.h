// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/ids.h"

#include <optional>
#include <span>
#include <vector>

namespace agv::estimation {

/// Mean position of the floor tags read at one time: thesis equation 4.1. Nothing without tags.
std::optional<Point2> meanOfTags(std::span<const Point2> tags);

/// What a receiver heard of one sender: a floor tag's RSSI or an anchor's range; any unit, the same
/// everywhere.
struct Heard {
    std::uint64_t source = 0;
    double value = 0.0;
};

/// Scene analysis (thesis 4.3.3 and 4.4): what was heard at surveyed places; a new reading lies where the
/// most similar entry was taken.
class FingerprintTable {
public:
    /// `missing`: the value a source counts as having where it was not heard (weaker than any RSSI, farther
    /// than any range).
    explicit FingerprintTable(double missing) : m_missing(missing) {}

    /// A surveyed place and what is heard there; readings of the same source count once, the last one.
    void add(Point2 place, std::span<const Heard> readings);
    std::size_t size() const { return m_entries.size(); }

    struct Match {
        Point2 place;
        double distance = 0.0; ///< root mean square difference per source, in the unit of the values
    };
    /// The nearest entry in the space of readings, or nothing when nothing was heard or nothing surveyed.
    std::optional<Match> nearest(std::span<const Heard> readings) const;
    /// Mean of the k nearest, each weighted by the inverse of its distance. k >= 1.
    std::optional<Match> nearest(std::span<const Heard> readings, std::size_t k) const;

private:
    struct Entry {
        Point2 place;
        std::vector<Heard> readings; ///< by source
    };
    double distanceTo(const Entry& entry, std::span<const Heard> sorted) const;

    std::vector<Entry> m_entries;
    double m_missing;
};

} // namespace agv::estimation
