// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/random.h"
#include "model/series_statistics.h"
#include "model/time_series.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace agv::model;

namespace {

TimeSeries noisy(std::size_t count, std::size_t capacity = 1'000'000)
{
    TimeSeries series(capacity);
    agv::SplitMix64 random(7);
    for (std::size_t i = 0; i < count; ++i)
        series.append(0.01 * static_cast<double>(i), random.normal());
    return series;
}

std::vector<SeriesPoint> envelopeOf(const TimeSeries& series, double from, double to, std::size_t buckets)
{
    std::vector<SeriesPoint> points;
    series.envelope(from, to, buckets, points);
    return points;
}

double highest(const std::vector<SeriesPoint>& points)
{
    return std::ranges::max(points, {}, &SeriesPoint::value).value;
}
double lowest(const std::vector<SeriesPoint>& points)
{
    return std::ranges::min(points, {}, &SeriesPoint::value).value;
}

TimeSeries seriesOf(const std::vector<double>& values)
{
    TimeSeries series;
    for (std::size_t i = 0; i < values.size(); ++i)
        series.append(static_cast<double>(i), values[i]);
    return series;
}

} // namespace

TEST(TimeSeries, LeavesOutWhatIsNoNumberAndWhatIsOlderThanTheLast)
{
    TimeSeries series;
    series.append(1.0, 5.0);
    series.append(2.0, std::nan(""));
    series.append(std::numeric_limits<double>::infinity(), 1.0);
    series.append(0.5, 1.0);
    series.append(1.0, 6.0); // at the same time
    EXPECT_EQ(series.points(), (std::vector<SeriesPoint>{{1.0, 5.0}, {1.0, 6.0}}));
}

TEST(TimeSeries, DropsTheOldestAtItsCapacityAndStillFindsPeaks)
{
    TimeSeries series(1000);
    for (int i = 0; i < 2500; ++i)
        series.append(i, i == 2000 ? 99.0 : 0.0);
    EXPECT_LE(series.size(), 1000U);
    EXPECT_GE(series.size(), 875U);
    EXPECT_EQ(series.back().t, 2499.0);
    EXPECT_EQ(highest(envelopeOf(series, 0, 3000, 10)), 99.0);
}

TEST(TimeSeries, GivesEveryPointWhereTheyAreFew)
{
    const TimeSeries series = noisy(1000);
    const std::vector<SeriesPoint> all = envelopeOf(series, 0.0, 9.99, 600);
    EXPECT_EQ(all, series.points());
}

TEST(TimeSeries, LosesNoPeakAndStaysSmallAtEveryZoom)
{
    const TimeSeries series = noisy(200'000);
    for (const auto& [from, to] : {std::pair(0.0, 2000.0), std::pair(100.0, 900.0), std::pair(333.33, 777.77),
                                   std::pair(1999.0, 2000.0), std::pair(-50.0, 5000.0)}) {
        std::vector<SeriesPoint> inside;
        series.range(from, to, inside);
        const std::vector<SeriesPoint> drawn = envelopeOf(series, from, to, 500);
        EXPECT_GE(highest(drawn), highest(inside));
        EXPECT_LE(lowest(drawn), lowest(inside));
        EXPECT_LE(drawn.size(), 2U * 500U * 16U + 2U);
        EXPECT_TRUE(std::ranges::is_sorted(drawn, {}, &SeriesPoint::t));
        EXPECT_LE(drawn.front().t, inside.front().t) << "the line comes from outside the picture";
        EXPECT_GE(drawn.back().t, inside.back().t);
    }
}

TEST(TimeSeries, GivesNothingForAnEmptySeriesOrARangeThatIsNone)
{
    EXPECT_TRUE(envelopeOf(TimeSeries(), 0, 1, 100).empty());
    EXPECT_TRUE(envelopeOf(noisy(10), 1, 0, 100).empty());
    EXPECT_TRUE(envelopeOf(noisy(10), 0, 1, 0).empty());
}

TEST(SeriesStatistics, AreThoseOfTheTextbook)
{
    const TimeSeries series = seriesOf({-3.0, 1.0, 2.0, 4.0});
    const SeriesStatistics s = statisticsOf(series, 0, 3).value();
    EXPECT_EQ(s.count, 4U);
    EXPECT_DOUBLE_EQ(s.mean, 1.0);
    EXPECT_DOUBLE_EQ(s.sd, std::sqrt(26.0 / 3.0));
    EXPECT_DOUBLE_EQ(s.rms, std::sqrt(30.0 / 4.0));
    EXPECT_DOUBLE_EQ(s.median, 1.5);
    EXPECT_DOUBLE_EQ(s.p50, 2.5); // of 1, 2, 3, 4
    EXPECT_DOUBLE_EQ(s.p75, 3.25);
    EXPECT_DOUBLE_EQ(s.p95, 3.85);
    EXPECT_DOUBLE_EQ(s.largest, 4.0);
}

TEST(SeriesStatistics, AreOfTheRangeOnlyAndEmptyOutsideIt)
{
    const TimeSeries series = seriesOf({10.0, 20.0, 30.0, 40.0});
    EXPECT_DOUBLE_EQ(statisticsOf(series, 1, 2)->mean, 25.0);
    EXPECT_DOUBLE_EQ(statisticsOf(series, 2, 2)->sd, 0.0);
    EXPECT_EQ(statisticsOf(series, 4, 9), std::nullopt);
    EXPECT_EQ(statisticsOf(TimeSeries(), 0, 9), std::nullopt);
}

TEST(SeriesStatistics, CountTheTimeWithoutAValueAsMissing)
{
    TimeSeries series;
    for (int i = 0; i <= 100; ++i) {
        if (i < 30 || i > 70)
            series.append(0.1 * i, 1.0);
    }
    // 2.9 s to 7.1 s is a gap, of which the first second still counts.
    EXPECT_NEAR(statisticsOf(series, 0, 10)->availability, 1.0 - 3.2 / 10.0, 1e-9);
    EXPECT_NEAR(statisticsOf(series, 0, 2)->availability, 1.0, 1e-9);
}

TEST(SeriesStatistics, TheDistributionRisesToOneAndPassesThroughTheQuantiles)
{
    const TimeSeries series = noisy(50'000);
    const std::vector<SeriesPoint> points = distributionOf(series, 0, 1e9, 1000);
    EXPECT_LE(points.size(), 1002U);
    EXPECT_TRUE(std::ranges::is_sorted(points, {}, &SeriesPoint::t));
    EXPECT_TRUE(std::ranges::is_sorted(points, {}, &SeriesPoint::value));
    EXPECT_DOUBLE_EQ(points.back().value, 1.0);
    const double p95 = statisticsOf(series, 0, 1e9)->p95;
    EXPECT_NEAR(p95, 1.96, 0.03); // of a normal distribution
    const auto at = std::ranges::lower_bound(points, p95, {}, &SeriesPoint::t);
    EXPECT_NEAR(at->value, 0.95, 0.002);
}

TEST(SeriesStatistics, TheHistogramHoldsEveryValue)
{
    const TimeSeries series = noisy(1000);
    const Histogram histogram = histogramOf(series, 0, 1e9, 12);
    double sum = 0.0;
    for (const double count : histogram.counts)
        sum += count;
    EXPECT_EQ(sum, 1000.0);
    EXPECT_EQ(histogramOf(seriesOf({5.0, 5.0, 5.0}), 0, 9, 4).counts[0], 3.0);
    EXPECT_TRUE(histogramOf(TimeSeries(), 0, 9, 4).counts.empty());
}
