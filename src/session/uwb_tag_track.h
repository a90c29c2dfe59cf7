// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "estimation/uwb/position_spread.h"
#include "estimation/uwb/range_ekf.h"
#include "protocol/trek_ranges.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace agv::session {

/// Position of one UWB tag from its reports: an EKF with a line-of-sight state per anchor. It starts with
/// the first three ranges of one exchange, and anew after a silence or when the ranges go on to contradict
/// it. Positions are given ahead of the age of the ranges. Ranges are corrected before anything is made of
/// them.
class UwbTagTrack {
public:
    /// After such a silence the tag may be anywhere.
    static constexpr double startAnewAfter_s = 3.0;
    /// An older position is not shown.
    static constexpr double shownFor_s = 3.0;
    /// So many reports in a row of which more than half is held for obstructed start it anew.
    static constexpr int contradictionsAllowed = 30;

    /// At most estimation::kMaxAnchors anchors are used, the first ones. Of the corrections those of this tag
    /// count.
    UwbTagTrack(const UwbTag& tag, const std::vector<UwbAnchor>& anchors,
                const std::vector<RangeCorrection>& corrections = {});

    /// The same tag in an edited plant; its position starts anew when what it comes from changed: the height,
    /// an anchor or a correction. True when it did.
    bool setLayout(const UwbTag& tag, const std::vector<UwbAnchor>& anchors,
                   const std::vector<RangeCorrection>& corrections);

    /// The ranges of one report of this tag; `arrival_s` is when it came.
    void take(const protocol::RangeSet& ranges, double arrival_s);
    /// What it knows at `now_s`, times of the steady clock; rate and traffic are the caller's.
    UwbTagSnapshot snapshot(double now_s) const;
    /// The ranges of the last report and what was made of them; empty after one without ranges.
    std::span<const UwbRangeSnapshot> shown() const { return m_shown; }
    /// The same as the filter took them, corrected, by the index of the anchor in the plant's list.
    estimation::AnchorRanges corrected() const { return {m_ranges.data(), m_ranges.size()}; }
    double height_m() const { return m_tag.z_m; }
    const UwbTag& tag() const { return m_tag; }
    /// Where the tag was when the last ranges were measured; empty without a position.
    std::optional<Point2> position() const;
    PositionCovariance covariance() const;             ///< of position()
    double measured_s() const { return m_measured_s; } ///< of the last ranges

private:
    /// An anchor as it enters into the positions of this tag.
    struct Anchor {
        int id = 0;
        double x = 0.0, y = 0.0, z = 0.0;
        double offset_m = 0.0; ///< added to its ranges
        friend bool operator==(const Anchor&, const Anchor&) = default;
    };
    static std::vector<Anchor> anchorsFor(int tag, const std::vector<UwbAnchor>& anchors,
                                          const std::vector<RangeCorrection>& corrections);
    void stop();
    void gather(const protocol::RangeSet& ranges);
    void follow(double time_s);
    std::string whyNoPosition(double age_s) const;

    UwbTag m_tag;
    std::vector<Anchor> m_anchors; ///< by AnchorRange::index
    estimation::RangeEkf m_filter;
    estimation::PositionSpread m_spread;
    estimation::AnchorRangeList m_ranges;  ///< of the last report; before the start, of the last exchange
    int m_sequence = -1;                   ///< that m_ranges are of
    int m_unknownAnchor = -1;              ///< of the last report; -1: none
    double m_measured_s = 0.0;             ///< of the last ranges
    double m_arrival_s = 0.0;              ///< of the last report, with ranges or without
    std::vector<UwbRangeSnapshot> m_shown; ///< m_ranges and what the filter made of them
    int m_contradictions = 0;
};

} // namespace agv::session
