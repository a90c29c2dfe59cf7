// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/static_position.h"

#include "estimation/uwb/anchor_plane.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr double kGridCell_m = 0.005;
constexpr int kGrid = 64;
/// Best cells that are split in four at each level.
constexpr std::size_t kKept = 512;
constexpr double kFinest_m = 0.004;
constexpr int kMostLevels = 12;
/// Natural logarithm below the best beyond which a cell adds nothing.
constexpr float kNegligibleCell = 20.0F;
constexpr float kMatters = 10.0F;
constexpr double kMargin = 4.0; ///< sds around the longest possible distance

bool usable(const AnchorRange& range, double farthest_m)
{
    return range.index >= 0 && range.index < kMaxAnchors && range.range_m >= 0.0 &&
           range.range_m < farthest_m && range.sd_m > 0.0 && range.anchor.allFinite();
}

} // namespace

StaticPosition::StaticPosition(const StaticPositionSettings& settings) : m_settings(settings) {}

void StaticPosition::clear()
{
    for (Heard& heard : m_heard) {
        heard.count = 0;
        std::ranges::fill(heard.log, 0.0F);
    }
    m_reports = 0;
}

double StaticPosition::logRange(double error, double sd_m) const
{
    const double share = m_settings.obstruction.seenAtFirst;
    const double z = error / sd_m;
    const double seen = share * std::exp(-0.5 * z * z - std::log(sd_m) - kLogRootTwoPi);
    const double hidden =
        (1.0 - share) * std::exp(logNormalPlusExponential(error, sd_m, m_settings.obstruction.meanBias_m));
    return std::log(seen + hidden + m_settings.outlier);
}

void StaticPosition::add(AnchorRanges ranges)
{
    for (const AnchorRange& range : ranges) {
        if (!usable(range, m_settings.farthest_m))
            continue;
        Heard& heard = m_heard[static_cast<std::size_t>(range.index)];
        heard.log.resize(static_cast<std::size_t>(m_settings.farthest_m / kGridCell_m) + 2, 0.0F);
        heard.shortest_m = heard.count > 0 ? std::min(heard.shortest_m, range.range_m) : range.range_m;
        heard.anchor = range.anchor;
        heard.sd_m = range.sd_m;
        ++heard.count;
        // Beyond these errors the density is the outlier's alone.
        const double most = m_settings.obstruction.meanBias_m * 12.0;
        const auto first = static_cast<std::size_t>(std::max(range.range_m - most, 0.0) / kGridCell_m);
        const std::size_t last = std::min(
            static_cast<std::size_t>((range.range_m + 8.0 * range.sd_m) / kGridCell_m), heard.log.size() - 1);
        const auto outlier = static_cast<float>(std::log(m_settings.outlier));
        for (std::size_t i = first; i <= last; ++i)
            heard.log[i] += static_cast<float>(
                                logRange(range.range_m - kGridCell_m * static_cast<double>(i), range.sd_m)) -
                            outlier;
    }
    ++m_reports;
}

float StaticPosition::logAt(double x, double y) const
{
    float sum = 0.0F;
    for (const Heard& heard : m_heard) {
        if (heard.count == 0)
            continue;
        const double dx = x - heard.anchor.x();
        const double dy = y - heard.anchor.y();
        const double dz = m_settings.height_m - heard.anchor.z();
        const double cells = std::sqrt(dx * dx + dy * dy + dz * dz) * (1.0 / kGridCell_m);
        // NOLINTNEXTLINE(bugprone-incorrect-roundings): a distance is not negative; inner loop
        const auto cell = static_cast<std::size_t>(cells + 0.5);
        sum += cell < heard.log.size() ? heard.log[cell] : 0.0F;
    }
    return sum;
}

/// Cells of the last level that matter, and their size.
std::vector<StaticPosition::Cell> StaticPosition::refined(double& width_x, double& width_y) const
{
    // An obstructed path is longer, never shorter: the tag is within every shortest range. Should an outlier
    // empty that box, the largest range's box is taken.
    double x0 = -1e9, x1 = 1e9, y0 = -1e9, y1 = 1e9;
    double fx0 = 1e9, fx1 = -1e9, fy0 = 1e9, fy1 = -1e9;
    for (const Heard& heard : m_heard) {
        if (heard.count == 0)
            continue;
        const double r = heard.shortest_m + kMargin * heard.sd_m;
        x0 = std::max(x0, heard.anchor.x() - r);
        x1 = std::min(x1, heard.anchor.x() + r);
        y0 = std::max(y0, heard.anchor.y() - r);
        y1 = std::min(y1, heard.anchor.y() + r);
        fx0 = std::min(fx0, heard.anchor.x() - r);
        fx1 = std::max(fx1, heard.anchor.x() + r);
        fy0 = std::min(fy0, heard.anchor.y() - r);
        fy1 = std::max(fy1, heard.anchor.y() + r);
    }
    if (!(x1 - x0 > 0.01 && y1 - y0 > 0.01)) {
        x0 = fx0;
        x1 = fx1;
        y0 = fy0;
        y1 = fy1;
    }
    width_x = (x1 - x0) / kGrid;
    width_y = (y1 - y0) / kGrid;
    std::vector<Cell> cells;
    cells.reserve(static_cast<std::size_t>(kGrid) * kGrid);
    const auto add = [&](double x, double y) {
        cells.push_back({static_cast<float>(x), static_cast<float>(y), logAt(x, y)});
    };
    for (int i = 0; i < kGrid; ++i)
        for (int k = 0; k < kGrid; ++k)
            add(x0 + (i + 0.5) * width_x, y0 + (k + 0.5) * width_y);
    std::vector<Cell> kept;
    for (int level = 0; level < kMostLevels && std::max(width_x, width_y) > kFinest_m; ++level) {
        // Enough cells where the probability is: finer ones would only have to be cut off.
        const float best = std::ranges::max(cells, {}, &Cell::log).log;
        if (std::ranges::count_if(cells, [&](const Cell& c) { return c.log > best - kMatters; }) >
            static_cast<std::ptrdiff_t>(kKept))
            break;
        const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(std::min(kKept, cells.size()));
        std::ranges::nth_element(cells, middle - 1, std::greater{}, &Cell::log);
        kept.assign(cells.begin(), middle);
        cells.clear();
        width_x *= 0.5;
        width_y *= 0.5;
        for (const Cell& cell : kept)
            for (const double sx : {-0.5, 0.5})
                for (const double sy : {-0.5, 0.5})
                    add(static_cast<double>(cell.x) + sx * width_x,
                        static_cast<double>(cell.y) + sy * width_y);
    }
    return cells;
}

UwbFix StaticPosition::fix() const
{
    UwbFix fix;
    AnchorRangeList heard;
    for (const Heard& h : m_heard)
        if (h.count > 0)
            heard.add({h.anchor, h.shortest_m, h.sd_m, 0});
    const AnchorRanges anchors(heard.data(), heard.size());
    fix.status = checkRanges(anchors, 3);
    Vec3 unused;
    if (fix.ok() && !planarStart(anchors, m_settings.height_m, unused))
        fix.status = FixStatus::CollinearAnchors;
    if (!fix.ok())
        return fix;
    double width_x = 0.0;
    double width_y = 0.0;
    const std::vector<Cell> cells = refined(width_x, width_y);
    const float best = std::ranges::max(cells, {}, &Cell::log).log;
    double total = 0.0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (const Cell& cell : cells) {
        if (cell.log < best - kNegligibleCell)
            continue;
        const double weight = std::exp(static_cast<double>(cell.log - best));
        const Eigen::Vector2d p(static_cast<double>(cell.x), static_cast<double>(cell.y));
        total += weight;
        mean += weight * p;
        second += weight * p * p.transpose();
    }
    mean /= total;
    fix.position << mean, m_settings.height_m;
    fix.covariance.topLeftCorner<2, 2>() = second / total - mean * mean.transpose();
    fix.covariance(0, 0) += width_x * width_x / 12.0;
    fix.covariance(1, 1) += width_y * width_y / 12.0;
    fix.dop = dopOf(anchors, fix.covariance);
    fix.used = static_cast<int>(heard.size());
    return fix;
}

MeasurementRecords StaticPosition::explain(AnchorRanges ranges, const Eigen::Vector2d& position) const
{
    MeasurementRecords records;
    for (const AnchorRange& range : ranges) {
        MeasurementRecord record;
        record.source = range.index;
        if (!usable(range, m_settings.farthest_m)) {
            record.rejected = true;
            records.add(record);
            continue;
        }
        const Eigen::Vector3d away(position.x() - range.anchor.x(), position.y() - range.anchor.y(),
                                   m_settings.height_m - range.anchor.z());
        record.innovation = range.range_m - away.norm();
        record.variance = range.sd_m * range.sd_m;
        record.testRatio =
            record.innovation * record.innovation / (kRecordGate * kRecordGate * record.variance);
        Obstruction seen(m_settings.obstruction);
        record.weight = seen.update(m_settings.obstruction, record.innovation, record.variance);
        record.rejected = record.weight < 0.5;
        record.fused = true;
        records.add(record);
    }
    return records;
}

} // namespace agv::estimation
