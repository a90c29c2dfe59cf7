// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/range_measurement.h"
#include "core/result.h"
#include "core/uwb_snapshot.h"

#include <string>
#include <vector>

namespace agv::procedure {

/// Where the antenna of the tag stands while its ranges are calibrated, plant frame, m.
struct CalibrationPlace {
    double x = 0.0, y = 0.0, z = 0.0;
};

/// Finds what is to be added to the ranges between one tag, which stands at a known place, and each anchor:
/// true distance minus the median of the ranges, so that a short obstruction does not count. The ranges must
/// not be corrected yet; then a second calibration replaces the first.
///
/// | state      | start      | range             | time is over        | abort  | cancel |
/// |------------|------------|-------------------|---------------------|--------|--------|
/// | Idle       | Collecting | -                 | -                   | -      | Idle   |
/// | Collecting | Collecting | of the tag: taken | Finished or Failed  | Failed | Idle   |
/// | Finished   | Collecting | -                 | -                   | -      | Idle   |
/// | Failed     | Collecting | -                 | -                   | -      | Idle   |
///
/// start() fails at once when its values are of no use. Finished: at least one anchor has an offset. No
/// clock, no timer: the caller says what time it is.
class RangeCalibration {
public:
    static constexpr double usualDuration_s = 30.0;
    static constexpr double shortest_s = 1.0;
    static constexpr double longest_s = 600.0;
    /// Fewer ranges of an anchor give no offset.
    static constexpr std::size_t leastRanges = 20;
    /// A spread beyond this is no noise: the anchor was hidden part of the time, or the tag moved.
    static constexpr double largeSpread_m = 0.15;
    /// Antenna delays and clocks err by less.
    static constexpr double largeOffset_m = 1.0;

    /// `duration_s` from shortest_s to longest_s.
    void start(int tag, const CalibrationPlace& place, const std::vector<UwbAnchor>& anchors,
               double duration_s, Time now);
    /// Every range that is heard, as measured. Those of other tags and of anchors that are not in the list
    /// are left out.
    void add(const RangeMeasurement& range, Time now);
    void onTimer(Time now);
    /// What is being collected is worth nothing any more; `reason` is a plain English sentence.
    void abort(const std::string& reason);
    void cancel();

    RangeCalibrationState state() const { return m_state; }
    RangeCalibrationSnapshot snapshot(Time now) const;

private:
    struct Anchor {
        int id = 0;
        double distance_m = 0.0; ///< true
        std::vector<double> ranges_m;
    };
    static Result<void> check(const CalibrationPlace& place, const std::vector<UwbAnchor>& anchors,
                              double duration_s);
    static RangeCalibrationRow rowOf(const Anchor& anchor);
    void finish();
    std::string whatToKnow() const;

    RangeCalibrationState m_state = RangeCalibrationState::Idle;
    int m_tag = 0;
    Time m_start;
    Duration m_duration{};
    std::vector<Anchor> m_anchors; ///< in the order of the plant
    std::string m_reason;
};

} // namespace agv::procedure
