// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/error_metrics.h"
#include "estimation/uwb/uwb_vectors.h"

namespace agv::estimation {

/// One of the reference tracks: a tag at 0.3 m height on a rectangle of 3 x 1 m at 0.1 m/s, ranges at 10 Hz
/// with 5 cm noise; anchors of the thesis.
struct ReferenceTrack {
    CsvColumns columns;

    explicit ReferenceTrack(const std::string& obstruction, int run)
        : columns(loadColumns(AGV_TEST_DATA "/vectors/uwb_run_" + obstruction + "_" + std::to_string(run) +
                              ".csv"))
    {}

    std::size_t size() const { return columns.at("k").size(); }
    Eigen::Vector2d truth(std::size_t k) const { return at("tx", "ty", k); }
    Eigen::Vector2d at(const std::string& x, const std::string& y, std::size_t k) const
    {
        return {columns.at(x)[k], columns.at(y)[k]};
    }
    std::vector<AnchorRange> ranges(std::size_t k) const
    {
        std::vector<double> r;
        for (const char* name : {"r0", "r1", "r2", "r3"})
            r.push_back(columns.at(name)[k]);
        return rangesFrom(thesisAnchors(), r, 0.05);
    }
};

constexpr double kTrackHeight_m = 0.3;
constexpr double kTrackPeriod_s = 0.1;
/// Epochs left out of the statistics at the start.
constexpr std::size_t kTrackStart = 30;

} // namespace agv::estimation
