// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/series_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace agv::model {
namespace {

std::vector<double> sortedMagnitudes(const std::vector<SeriesPoint>& points)
{
    std::vector<double> magnitudes;
    magnitudes.reserve(points.size());
    for (const SeriesPoint& point : points)
        magnitudes.push_back(std::abs(point.value));
    std::ranges::sort(magnitudes);
    return magnitudes;
}

double availabilityOf(const std::vector<SeriesPoint>& points, double from, double to, double gap_s)
{
    if (!(to > from))
        return 1.0;
    double covered = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double next = i + 1 < points.size() ? points[i + 1].t : to;
        covered += std::min(gap_s, next - points[i].t);
    }
    return std::min(1.0, covered / (to - from));
}

} // namespace

double quantileOf(const std::vector<double>& sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 >= sorted.size())
        return sorted.back();
    return std::lerp(sorted[below], sorted[below + 1], place - static_cast<double>(below));
}

std::optional<SeriesStatistics> statisticsOf(const TimeSeries& series, double from, double to, double gap_s)
{
    std::vector<SeriesPoint> points;
    series.range(from, to, points);
    if (points.empty())
        return std::nullopt;
    SeriesStatistics statistics;
    statistics.count = points.size();
    const auto n = static_cast<double>(points.size());
    double squares = 0.0;
    for (const SeriesPoint& point : points) {
        statistics.mean += point.value / n;
        squares += point.value * point.value / n;
    }
    double deviations = 0.0;
    std::vector<double> values;
    values.reserve(points.size());
    for (const SeriesPoint& point : points) {
        const double deviation = point.value - statistics.mean;
        deviations += deviation * deviation;
        values.push_back(point.value);
    }
    std::ranges::sort(values);
    const std::vector<double> magnitudes = sortedMagnitudes(points);
    statistics.sd = points.size() > 1 ? std::sqrt(deviations / (n - 1.0)) : 0.0;
    statistics.rms = std::sqrt(squares);
    statistics.median = quantileOf(values, 0.5);
    statistics.p50 = quantileOf(magnitudes, 0.5);
    statistics.p75 = quantileOf(magnitudes, 0.75);
    statistics.p95 = quantileOf(magnitudes, 0.95);
    statistics.largest = magnitudes.back();
    // Before the first value there was nothing to be available.
    statistics.availability =
        availabilityOf(points, std::max(from, points.front().t), std::min(to, series.back().t), gap_s);
    return statistics;
}

std::vector<SeriesPoint> distributionOf(const TimeSeries& series, double from, double to, std::size_t most)
{
    std::vector<SeriesPoint> points;
    series.range(from, to, points);
    const std::vector<double> magnitudes = sortedMagnitudes(points);
    std::vector<SeriesPoint> distribution;
    const std::size_t step = std::max<std::size_t>(1, magnitudes.size() / std::max<std::size_t>(1, most));
    for (std::size_t i = 0; i < magnitudes.size(); i += step)
        distribution.push_back(
            {magnitudes[i], static_cast<double>(i + 1) / static_cast<double>(magnitudes.size())});
    if (!magnitudes.empty() && distribution.back().value < 1.0)
        distribution.push_back({magnitudes.back(), 1.0});
    return distribution;
}

Histogram histogramOf(const TimeSeries& series, double from, double to, std::size_t classes)
{
    std::vector<SeriesPoint> points;
    series.range(from, to, points);
    Histogram histogram;
    if (points.empty() || classes == 0)
        return histogram;
    const auto [low, high] = std::ranges::minmax(points, {}, &SeriesPoint::value);
    histogram.lowest = low.value;
    histogram.width = std::max((high.value - low.value) / static_cast<double>(classes), 1e-12);
    histogram.counts.assign(classes, 0.0);
    for (const SeriesPoint& point : points) {
        const auto place = static_cast<std::size_t>((point.value - low.value) / histogram.width);
        histogram.counts[std::min(place, classes - 1)] += 1.0;
    }
    return histogram;
}

} // namespace agv::model
