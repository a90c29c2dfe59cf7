// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/uwb_snapshot.h"
#include "estimation/recent_values.h"
#include "session/rate_meter.h"

#include <optional>
#include <span>
#include <vector>

namespace agv::session {

/// How often each anchor of the plant ranges and how its ranges fit the positions of the tags.
class AnchorStatistics {
public:
    /// Ranges with a position that the residuals are summed up from, the last ones.
    static constexpr std::size_t residualsKept = 200;
    /// Fewer say nothing about mean and deviation.
    static constexpr std::size_t leastResiduals = 20;

    explicit AnchorStatistics(const std::vector<UwbAnchor>& anchors) { setAnchors(anchors); }

    /// Anchors that stay keep their rate and age.
    void setAnchors(const std::vector<UwbAnchor>& anchors);
    /// The residuals so far belong to a layout that holds no more.
    void forgetResiduals();

    /// An anchor that is not of the plant is left out.
    void heard(int anchor, Time arrival, Time measured);
    /// What a track made of the ranges of one report; those without a residual are left out.
    void add(std::span<const UwbRangeSnapshot> ranges);

    /// All anchors in the order of the plant, without warnings.
    std::vector<UwbAnchorSnapshot> snapshot(Time now);

private:
    struct Anchor {
        int id = 0;
        RateMeter rate;
        std::optional<Time> measured; ///< its last range
        estimation::RecentValues<double, residualsKept> residuals_m;
    };
    Anchor* find(int id);

    std::vector<Anchor> m_anchors;
};

} // namespace agv::session
