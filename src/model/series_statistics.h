// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/time_series.h"

#include <optional>
#include <vector>

namespace agv::model {

/// Of the values of a time range, in their own unit.
struct SeriesStatistics {
    std::size_t count = 0;
    double mean = 0.0; ///< of an error: the bias
    double sd = 0.0;   ///< about the mean, n - 1
    double rms = 0.0;
    double median = 0.0;
    // Of the magnitudes: of a position error the circular errors CE50, CE75, CE95.
    double p50 = 0.0, p75 = 0.0, p95 = 0.0, largest = 0.0;
    double availability = 0.0; ///< share of the range with a value not older than `gap_s`
};

/// Longer without a value counts as missing, s.
inline constexpr double usualGap_s = 1.0;

/// Empty without a value in [from, to].
std::optional<SeriesStatistics> statisticsOf(const TimeSeries& series, double from, double to,
                                             double gap_s = usualGap_s);

/// Linear interpolation between order statistics (Hyndman and Fan 1996, type 7). `sorted` rises and is not
/// empty; `share` 0 to 1.
double quantileOf(const std::vector<double>& sorted, double share);

/// The empirical distribution of the magnitudes of the values in [from, to]: value, share that is not larger.
/// At most `most` points.
std::vector<SeriesPoint> distributionOf(const TimeSeries& series, double from, double to,
                                        std::size_t most = 2000);

/// Equal classes over the values in [from, to].
struct Histogram {
    double lowest = 0.0, width = 0.0; ///< of the first class, of each
    std::vector<double> counts;
};
Histogram histogramOf(const TimeSeries& series, double from, double to, std::size_t classes);

} // namespace agv::model
