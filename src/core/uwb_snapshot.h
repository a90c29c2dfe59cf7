// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/ids.h"
#include "core/link_snapshot.h"
#include "core/uwb_unit.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace agv {

/// Symmetric covariance of (x, y), m^2.
struct PositionCovariance {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    friend bool operator==(const PositionCovariance&, const PositionCovariance&) = default;
};

/// The last range of a tag to one anchor.
struct UwbRangeSnapshot {
    int anchor = 0;
    double range_m = 0.0;             ///< corrected
    std::optional<double> residual_m; ///< measured minus expected before this report; empty: no position then
    bool rejected = false;            ///< held for obstructed
    friend bool operator==(const UwbRangeSnapshot&, const UwbRangeSnapshot&) = default;
};

/// One UWB tag, as its ranges say.
struct UwbTagSnapshot {
    int id = 0;
    std::string label;
    std::optional<RobotId> agv;
    std::optional<Point2> position; ///< at the time of the snapshot; empty: see reason
    PositionCovariance covariance;  ///< of the position, for known anchors and height
    double z_m = 0.0;               ///< assumed height
    std::string reason;             ///< why there is no position; plain English
    double reportsPerSecond = 0.0;
    double age_s = 0.0;                   ///< since the ranges were measured, not since they arrived
    std::vector<UwbRangeSnapshot> ranges; ///< of the last report, from anchors that are known
    /// Radius about the mean of the last positions that holds 95 % of them: repeatability, not accuracy.
    /// Empty: too few positions yet.
    std::optional<double> r95_m;
    std::uint64_t reports = 0; ///< in all
    std::uint64_t missed = 0;  ///< exchanges that gaps in RSEQ say were lost
    friend bool operator==(const UwbTagSnapshot&, const UwbTagSnapshot&) = default;
};

/// How the ranges of an anchor fit the positions of the tags: measured minus expected.
struct ResidualSummary {
    double mean_m = 0.0;
    double sd_m = 0.0;
    int count = 0; ///< ranges it was made of, the last ones
    friend bool operator==(const ResidualSummary&, const ResidualSummary&) = default;
};

/// One anchor of the plant, as the unit on the port hears of it.
struct UwbAnchorSnapshot {
    int id = 0;
    double rangesPerSecond = 0.0;
    std::optional<double> age_s;             ///< of its last range; empty: none yet
    std::optional<ResidualSummary> residual; ///< empty: too few ranges with a position yet
    std::string warning; ///< why its place in the list is doubted; plain English; empty: it is not
    friend bool operator==(const UwbAnchorSnapshot&, const UwbAnchorSnapshot&) = default;
};

/// Ranges between two anchors.
struct AnchorPairSnapshot {
    int first = 0, second = 0; ///< ids, rising
    double range_m = 0.0;      ///< median of the last ones
    double sd_m = 0.0;         ///< of a single one
    int count = 0;
    friend bool operator==(const AnchorPairSnapshot&, const AnchorPairSnapshot&) = default;
};

/// What the calibration of the ranges at a known place found for one anchor.
struct RangeCalibrationRow {
    int anchor = 0;
    int count = 0;                  ///< ranges so far
    std::optional<double> offset_m; ///< to be added to measured ranges (RangeCorrection); empty: too few
    double spread_m = 0.0;          ///< sd of a single range
    friend bool operator==(const RangeCalibrationRow&, const RangeCalibrationRow&) = default;
};

enum class RangeCalibrationState { Idle, Collecting, Finished, Failed };

/// The calibration of the ranges of one tag that stands at a known place.
struct RangeCalibrationSnapshot {
    RangeCalibrationState state = RangeCalibrationState::Idle;
    int tag = 0;
    double progress = 0.0;                 ///< 0..1
    std::string reason;                    ///< why it failed, or what to know of the result; plain English
    std::vector<RangeCalibrationRow> rows; ///< by anchor
    friend bool operator==(const RangeCalibrationSnapshot&, const RangeCalibrationSnapshot&) = default;
};

/// The UWB unit on its serial port and what it reports.
struct UwbSnapshot {
    LinkSnapshot link;
    UwbDialect dialect = UwbDialect::Unknown;    ///< in force
    bool dialectIsChosen = false;                ///< by the plant file or the operator; else from the content
    std::optional<UwbUnit> unit;                 ///< version and configuration, when it told them
    std::string unitNote;                        ///< why it did not tell them; plain English
    std::uint64_t missed = 0;                    ///< gaps in RSEQ of all tags
    std::vector<UwbTagSnapshot> tags;            ///< that were heard, by id
    std::vector<UwbAnchorSnapshot> anchors;      ///< all of the plant, in its order
    std::vector<AnchorPairSnapshot> anchorPairs; ///< that were heard
    RangeCalibrationSnapshot calibration;
    friend bool operator==(const UwbSnapshot&, const UwbSnapshot&) = default;
};

} // namespace agv
