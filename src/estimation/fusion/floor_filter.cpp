// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fusion/floor_filter.h"

#include "estimation/rssi_likelihood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace agv::estimation {

namespace {

constexpr double kCell_m = 1e-4;
/// Beyond the table's reach by this many sds nothing is read.
constexpr double kReachSds = 4.0;
/// Kernel after resampling: share of the cloud's sds, and least widths, without which the cloud collapses.
constexpr double kRoughening = 0.2;
constexpr double kLeastPlace_m = 3e-4;
constexpr double kLeastHeading = 1.4e-3;
constexpr double kLeastScale = 5e-4;
constexpr float kReadableFloor = 1e-3F;
/// Memory of the plausibility of reads.
constexpr double kForget = 0.05;
constexpr double kObstructedReach_m = 5.0; ///< an obstructed range is as likely anywhere within

double rootOf(double variance) { return std::sqrt(std::max(variance, 0.0)); }

} // namespace

FloorFilter::FloorFilter(const TagMap& tags, const RssiTable& table, const FloorFilterSettings& settings)
    : m_settings(settings),
      m_tags(tags),
      m_random(settings.seed)
{
    const auto n = static_cast<std::size_t>(std::max(settings.particles, 16));
    for (auto* column : {&m_x, &m_y, &m_heading, &m_scale, &m_difference, &m_weight, &m_log, &m_spare})
        column->assign(n, 0.0);
    for (auto* column : {&m_placedX, &m_placedY, &m_readable})
        column->assign(n, 0.0F);
    m_tagsByX.reserve(tags.size());
    for (const auto& [uid, place] : tags)
        m_tagsByX.push_back(place);
    std::ranges::sort(m_tagsByX, [](Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    m_candidates.reserve(256);
    fillTable(table);
}

void FloorFilter::fillTable(const RssiTable& table)
{
    const double reach =
        (table.empty() ? 0.0 : table.front().upperEdge) + kReachSds * m_settings.distanceSd_m;
    m_table.cells = static_cast<int>(reach / kCell_m) + 2;
    const RssiLikelihood likelihood(table, {.distanceSd_m = m_settings.distanceSd_m,
                                            .offByOne = m_settings.offByOne,
                                            .missed = 0.0,
                                            .outlier = m_settings.outlier});
    const auto cells = static_cast<std::size_t>(m_table.cells);
    m_table.logRead.assign(8 * cells, 0.0F);
    m_table.read.assign(cells, 0.0F);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const OutcomeProbabilities p = likelihood.probabilities(kCell_m * static_cast<double>(cell));
        for (std::size_t rssi = 0; rssi < 8; ++rssi) {
            m_table.logRead[rssi * cells + cell] = static_cast<float>(std::log(p[rssi]));
            m_table.read[cell] += static_cast<float>(p[rssi]);
        }
    }
}

int FloorFilter::cellOf(float distance_m) const
{
    const float cells = distance_m * static_cast<float>(1.0 / kCell_m);
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): a distance is not negative, and this is the inner loop
    return std::min(static_cast<int>(cells + 0.5F), m_table.cells - 1);
}

void FloorFilter::start(const Pose2& pose, const PoseCovariance& covariance)
{
    const Eigen::Matrix3d c = Eigen::Map<const Eigen::Matrix3d>(covariance.data());
    const Eigen::LDLT<Eigen::Matrix3d> factor(c);
    const Eigen::Vector3d roots = factor.vectorD().cwiseMax(0.0).cwiseSqrt();
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        Eigen::Vector3d draw;
        for (int k = 0; k < 3; ++k)
            draw(k) = roots(k) * m_random.normal();
        draw = factor.transpositionsP().transpose() * (factor.matrixL() * draw);
        m_x[i] = pose.position.x + draw(0);
        m_y[i] = pose.position.y + draw(1);
        m_heading[i] = pose.heading + draw(2);
        m_scale[i] = m_settings.wheelScaleSd * m_random.normal();
        m_difference[i] = m_settings.wheelDifferenceSd * m_random.normal();
        m_weight[i] = 1.0 / static_cast<double>(m_x.size());
    }
    m_plausible = 1.0;
    m_started = true;
    summarise();
}

void FloorFilter::predict(double left_m_s, double right_m_s, double dt_s)
{
    if (!m_started || !(dt_s > 0.0) || !std::isfinite(dt_s) || !std::isfinite(left_m_s) ||
        !std::isfinite(right_m_s))
        return;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        // The console reports true speed times (1 + error).
        const double left = left_m_s / (1.0 + m_scale[i]) * (1.0 + m_settings.wheelNoise * m_random.normal());
        const double right = right_m_s / (1.0 + m_scale[i] + m_difference[i]) *
                             (1.0 + m_settings.wheelNoise * m_random.normal());
        const double way = 0.5 * (left + right) * dt_s;
        const double turn = (right - left) / m_settings.track_m * dt_s;
        const double along = m_heading[i] + 0.5 * turn;
        m_x[i] += way * std::cos(along) + m_settings.placeNoise_m * m_random.normal();
        m_y[i] += way * std::sin(along) + m_settings.placeNoise_m * m_random.normal();
        m_heading[i] += turn + m_settings.headingNoise * m_random.normal();
    }
    summarise();
}

void FloorFilter::slip(double left_m, double right_m)
{
    if (!m_started)
        return;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        const double left = left_m * m_random.normal();
        const double right = right_m * m_random.normal();
        m_x[i] += 0.5 * (left + right) * std::cos(m_heading[i]);
        m_y[i] += 0.5 * (left + right) * std::sin(m_heading[i]);
        m_heading[i] += (right - left) / m_settings.track_m;
    }
    summarise();
}

void FloorFilter::place(Point2 offset)
{
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        const Point2 p = fromVehicleFrame({{m_x[i], m_y[i]}, m_heading[i]}, offset);
        m_placedX[i] = static_cast<float>(p.x);
        m_placedY[i] = static_cast<float>(p.y);
    }
}

void FloorFilter::gatherCandidates(Point2 around, double reach)
{
    m_candidates.clear();
    auto tag = std::ranges::lower_bound(m_tagsByX, around.x - reach, {}, &Point2::x);
    for (; tag != m_tagsByX.end() && tag->x <= around.x + reach; ++tag)
        if (std::abs(tag->y - around.y) <= reach)
            m_candidates.push_back(*tag);
}

void FloorFilter::addReadable()
{
    const Point2 antenna = fromVehicleFrame(m_pose, m_settings.antenna);
    const double spread =
        4.0 * (rootOf(m_covariance[0] + m_covariance[4]) +
               std::hypot(m_settings.antenna.x, m_settings.antenna.y) * rootOf(m_covariance[8]));
    gatherCandidates(antenna, kCell_m * m_table.cells + spread);
    std::ranges::fill(m_readable, 0.0F);
    for (const Point2 tag : m_candidates) {
        const auto tx = static_cast<float>(tag.x);
        const auto ty = static_cast<float>(tag.y);
        for (std::size_t i = 0; i < m_readable.size(); ++i) {
            const float dx = m_placedX[i] - tx;
            const float dy = m_placedY[i] - ty;
            m_readable[i] += m_table.read[static_cast<std::size_t>(cellOf(std::sqrt(dx * dx + dy * dy)))];
        }
    }
    for (float& readable : m_readable)
        readable = std::log(readable + kReadableFloor);
}

double FloorFilter::readVariance() const
{
    const double reach = kCell_m * m_table.cells;
    return reach * reach + m_covariance[0] + m_covariance[4];
}

double FloorFilter::testRatio(Point2 tag) const
{
    const double off = distance(tag, fromVehicleFrame(m_pose, m_settings.antenna));
    return off * off / readVariance();
}

MeasurementRecord FloorFilter::weigh(Point2 tag, int rssi)
{
    const float* row =
        m_table.logRead.data() + static_cast<std::size_t>(rssi) * static_cast<std::size_t>(m_table.cells);
    const auto tx = static_cast<float>(tag.x);
    const auto ty = static_cast<float>(tag.y);
    for (std::size_t i = 0; i < m_log.size(); ++i) {
        const float dx = m_placedX[i] - tx;
        const float dy = m_placedY[i] - ty;
        m_log[i] += static_cast<double>(row[cellOf(std::sqrt(dx * dx + dy * dy))] - m_readable[i]);
    }
    MeasurementRecord record;
    record.kind = MeasurementKind::FloorTag;
    record.innovation = distance(tag, fromVehicleFrame(m_pose, m_settings.antenna));
    record.variance = readVariance();
    record.testRatio = testRatio(tag);
    record.rejected = record.testRatio > 1.0;
    record.weight = record.rejected ? 0.0 : 1.0;
    record.fused = true;
    m_plausible += kForget * (record.weight - m_plausible);
    return record;
}

const MeasurementRecords& FloorFilter::update(std::span<const FloorRead> reads)
{
    m_records.clear();
    if (!m_started || reads.empty())
        return m_records;
    std::ranges::fill(m_log, 0.0);
    place(m_settings.antenna);
    addReadable();
    for (const FloorRead& read : reads) {
        const auto tag = m_tags.find(read.uid);
        if (tag == m_tags.end() || read.rssi < 0 || read.rssi > 7) {
            MeasurementRecord record;
            record.kind = MeasurementKind::FloorTag;
            record.rejected = true;
            m_records.add(record);
            continue;
        }
        m_records.add(weigh(tag->second, read.rssi));
    }
    normalise();
    summarise();
    resampleWhenNeeded();
    return m_records;
}

/// Of each particle: in sight with a Gaussian error, or anything at all. The density of the latter keeps the
/// best particles when every range is obstructed.
MeasurementRecord FloorFilter::weigh(const AnchorRange& range, Point2 tag, double height_m, double share)
{
    const double vertical = range.anchor.z() - height_m;
    const double precision = 1.0 / m_settings.rangeSd_m;
    const double obstructed = m_settings.obstructed / kObstructedReach_m;
    const double inSight = (1.0 - m_settings.obstructed) * precision / std::sqrt(2.0 * std::numbers::pi);
    const auto residualAt = [&](double x, double y) {
        return range.range_m - std::hypot(x - range.anchor.x(), y - range.anchor.y(), vertical);
    };
    for (std::size_t i = 0; i < m_log.size(); ++i) {
        const double off = precision * residualAt(m_placedX[i], m_placedY[i]);
        m_log[i] += share * std::log(inSight * std::exp(-0.5 * off * off) + obstructed);
    }
    const Point2 at = fromVehicleFrame(m_pose, tag);
    MeasurementRecord record;
    record.source = range.index;
    record.innovation = residualAt(at.x, at.y);
    record.variance = 1.0 / (precision * precision) + m_covariance[0] + m_covariance[4];
    record.testRatio = record.innovation * record.innovation / (kRecordGate * kRecordGate * record.variance);
    record.rejected = record.testRatio > 1.0;
    record.weight = record.rejected ? 0.0 : 1.0;
    record.fused = true;
    return record;
}

const MeasurementRecords& FloorFilter::update(AnchorRanges ranges, Point2 tag, double height_m, double share)
{
    m_records.clear();
    if (!m_started || ranges.empty())
        return m_records;
    std::ranges::fill(m_log, 0.0);
    place(tag);
    for (const AnchorRange& range : ranges)
        m_records.add(weigh(range, tag, height_m, std::clamp(share, 0.0, 1.0)));
    normalise();
    summarise();
    resampleWhenNeeded();
    return m_records;
}

void FloorFilter::normalise()
{
    double most = -1e300;
    for (std::size_t i = 0; i < m_log.size(); ++i) {
        m_log[i] += std::log(m_weight[i] + 1e-300);
        most = std::max(most, m_log[i]);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < m_log.size(); ++i)
        sum += m_weight[i] = std::exp(m_log[i] - most);
    for (double& w : m_weight)
        w /= sum;
}

void FloorFilter::summarise()
{
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double c = 0.0;
    double s = 0.0;
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        mean.x() += m_weight[i] * m_x[i];
        mean.y() += m_weight[i] * m_y[i];
        c += m_weight[i] * std::cos(m_heading[i]);
        s += m_weight[i] * std::sin(m_heading[i]);
    }
    mean.z() = std::atan2(s, c);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        const Eigen::Vector3d away(m_x[i] - mean.x(), m_y[i] - mean.y(), wrapAngle(m_heading[i] - mean.z()));
        sum += m_weight[i] * away * away.transpose();
    }
    m_pose = {{mean.x(), mean.y()}, wrapAngle(mean.z())};
    Eigen::Map<Eigen::Matrix3d>(m_covariance.data()) = sum;
}

void FloorFilter::resampleWhenNeeded()
{
    double squares = 0.0;
    for (const double w : m_weight)
        squares += w * w;
    if (1.0 / squares >= 0.5 * static_cast<double>(m_weight.size()))
        return;
    const Cloud cloud = cloudNow();
    drawByWeight();
    // Kernel with shrinkage (Liu and West 2001): spreads equal particles without widening the cloud, and
    // along its own axes, because place and heading are tied together by the antenna's offset.
    const double keep = std::sqrt(1.0 - kRoughening * kRoughening);
    const std::array columns{&m_x, &m_y, &m_heading, &m_scale, &m_difference};
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        Cloud::Vector noise;
        for (Eigen::Index k = 0; k < noise.size(); ++k)
            noise(k) = m_random.normal();
        noise = (kRoughening * (cloud.root * noise)).eval();
        for (std::size_t k = 0; k < columns.size(); ++k) {
            double& value = (*columns[k])[i];
            const auto row = static_cast<Eigen::Index>(k);
            value = cloud.mean(row) + keep * (value - cloud.mean(row)) + noise(row);
        }
    }
}

/// Mean and root of the covariance of all five columns.
FloorFilter::Cloud FloorFilter::cloudNow() const
{
    Cloud cloud;
    const std::array columns{&m_x, &m_y, &m_heading, &m_scale, &m_difference};
    cloud.mean.setZero();
    for (std::size_t i = 0; i < m_x.size(); ++i)
        for (std::size_t k = 0; k < columns.size(); ++k)
            cloud.mean(static_cast<Eigen::Index>(k)) += m_weight[i] * (*columns[k])[i];
    Cloud::Matrix covariance = Cloud::Matrix::Zero();
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        Cloud::Vector away;
        for (std::size_t k = 0; k < columns.size(); ++k)
            away(static_cast<Eigen::Index>(k)) = (*columns[k])[i] - cloud.mean(static_cast<Eigen::Index>(k));
        covariance += m_weight[i] * away * away.transpose();
    }
    const std::array least{kLeastPlace_m, kLeastPlace_m, kLeastHeading, kLeastScale, kLeastScale};
    for (Eigen::Index k = 0; k < covariance.rows(); ++k)
        covariance(k, k) += least[static_cast<std::size_t>(k)] * least[static_cast<std::size_t>(k)];
    cloud.root = covariance.llt().matrixL();
    return cloud;
}

/// Systematic resampling: every column from the same draw, all weights equal after it.
void FloorFilter::drawByWeight()
{
    const std::size_t n = m_weight.size();
    const double offset = m_random.uniform();
    for (auto* column : {&m_x, &m_y, &m_heading, &m_scale, &m_difference}) {
        double reached = m_weight[0];
        std::size_t source = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double level = (offset + static_cast<double>(i)) / static_cast<double>(n);
            while (reached < level && source + 1 < n)
                reached += m_weight[++source];
            m_spare[i] = (*column)[source];
        }
        std::swap(*column, m_spare);
    }
    std::ranges::fill(m_weight, 1.0 / static_cast<double>(n));
}

} // namespace agv::estimation
