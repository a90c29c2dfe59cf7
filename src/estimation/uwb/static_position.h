// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "estimation/measurement_record.h"
#include "estimation/uwb/fix.h"
#include "estimation/uwb/obstruction.h"

#include <array>
#include <vector>

namespace agv::estimation {

struct StaticPositionSettings {
    double height_m = 0.0;        ///< of the tag
    double outlier = 1e-4;        ///< density of a range that means nothing, 1/m
    double farthest_m = 40.0;     ///< longest range kept
    ObstructionModel obstruction; ///< seenAtFirst: share of ranges with line of sight
};

/// Position of a tag that stands still, from any number of reports. Every range is normal around the distance
/// or, when its anchor is hidden, normal plus exponential, and which of the two it was is summed over each
/// time:
///     log p(x) = sum over anchors and reports of log(s N(e) + (1 - s) EMG(e) + o),   e = r - |x - anchor|.
/// As a sum of functions of one distance per anchor it is kept in tables, so a report costs the same however
/// many came before. The answer is the posterior mean over a grid that is refined where the probability is:
/// no start, no local minimum, and two explanations are weighed instead of one being picked. Anchors that are
/// hidden for a time contribute as soon as they are seen.
class StaticPosition {
public:
    explicit StaticPosition(const StaticPositionSettings& settings = {});

    /// Forgets everything.
    void clear();
    /// Takes a report; ranges that are not usable are left out.
    void add(AnchorRanges ranges);
    int reports() const { return m_reports; }
    /// Mean and covariance of the position; status when fewer than three anchors were heard or they stand on
    /// a line.
    UwbFix fix() const;
    /// What the ranges of a report look like from a position: innovations, and whether an anchor was hidden.
    MeasurementRecords explain(AnchorRanges ranges, const Eigen::Vector2d& position) const;

private:
    struct Heard {
        Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
        double sd_m = 0.05;
        double shortest_m = 0.0;
        int count = 0;
        std::vector<float> log; ///< by distance
    };
    struct Cell {
        float x = 0.0F;
        float y = 0.0F;
        float log = 0.0F;
    };
    double logRange(double error, double sd_m) const;
    float logAt(double x, double y) const;
    std::vector<Cell> refined(double& width_x, double& width_y) const;

    StaticPositionSettings m_settings;
    std::array<Heard, kMaxAnchors> m_heard;
    int m_reports = 0;
};

} // namespace agv::estimation
