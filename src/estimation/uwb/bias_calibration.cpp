// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/bias_calibration.h"

#include <algorithm>
#include <cmath>

#include <array>
#include <Eigen/Cholesky>

namespace agv::estimation {

namespace {

constexpr int kBiasReweightings = 10;
/// Places beyond this many sds weigh less (Huber).
constexpr double kBiasHuber = 1.5;
constexpr double kSdOfMad = 1.4826;
constexpr double kLeastNoise_m = 0.01;

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Columns of the unknowns: of each tag, anchor and pair; offsets first, then slopes.
struct Columns {
    std::map<int, int> tags, anchors;
    int pairs = 0;
    int count() const { return static_cast<int>(tags.size() + 2 * anchors.size()) + 1 + 2 * pairs; }
};

struct Row {
    int pair = 0;
    std::array<int, 6> columns{}; ///< tag, anchor, pair, slope, anchor slope, pair slope
    double error_m = 0.0;
    double distance_m = 0.0;

    double valueOf(std::size_t i) const { return i < 3 ? 1.0 : distance_m; }
    double predicted(const Eigen::VectorXd& unknowns) const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < columns.size(); ++i)
            sum += valueOf(i) * unknowns(columns[i]);
        return sum;
    }
};

Eigen::VectorXd solveRows(const std::vector<Row>& rows, const Eigen::VectorXd& prior, double placeSd_m)
{
    Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(prior.size());
    for (int k = 0; k < kBiasReweightings; ++k) {
        Eigen::MatrixXd information = prior.asDiagonal();
        Eigen::VectorXd right = Eigen::VectorXd::Zero(prior.size());
        for (const Row& row : rows) {
            const double t = std::abs(row.error_m - row.predicted(unknowns)) / placeSd_m;
            const double weight = (k > 0 && t > kBiasHuber ? kBiasHuber / t : 1.0) / (placeSd_m * placeSd_m);
            for (std::size_t i = 0; i < 6; ++i) {
                right(row.columns[i]) += weight * row.valueOf(i) * row.error_m;
                for (std::size_t m = 0; m < 6; ++m)
                    information(row.columns[i], row.columns[m]) += weight * row.valueOf(i) * row.valueOf(m);
            }
        }
        unknowns = information.ldlt().solve(right);
    }
    return unknowns;
}

} // namespace

void BiasCalibration::add(int tag, int anchor, int place, double range_m, double distance_m)
{
    if (std::isfinite(range_m) && std::isfinite(distance_m) && distance_m >= 0.0)
        m_samples[{tag, anchor}][place].push_back({range_m - distance_m, distance_m});
}

BiasCalibration::Place BiasCalibration::medianPlace(const std::vector<Sample>& samples)
{
    std::vector<double> errors;
    std::vector<double> distances;
    for (const Sample& s : samples) {
        errors.push_back(s.error_m);
        distances.push_back(s.distance_m);
    }
    Place place{medianOf(errors), medianOf(distances), 0.0};
    for (double& e : errors)
        e = std::abs(e - place.error_m);
    place.spread_m = kSdOfMad * medianOf(errors);
    return place;
}

Result<RangeBiases> BiasCalibration::solve() const
{
    if (m_samples.empty())
        return failure(
            ErrorCode::NoSolution,
            "calibration: no range was measured at a known place; check that tags, anchors and times of "
            "the ranges and of the truth belong together");
    Columns columns;
    for (const auto& [pair, places] : m_samples) {
        columns.tags.try_emplace(pair.first, static_cast<int>(columns.tags.size()));
        columns.anchors.try_emplace(pair.second, static_cast<int>(columns.anchors.size()));
    }
    columns.pairs = static_cast<int>(m_samples.size());
    const int tags = static_cast<int>(columns.tags.size());
    const int anchors = static_cast<int>(columns.anchors.size());
    const int slope = tags + anchors + columns.pairs;
    Eigen::VectorXd sds(columns.count());
    sds << Eigen::VectorXd::Constant(tags, m_settings.tagOffset_m),
        Eigen::VectorXd::Constant(anchors, m_settings.anchorOffset_m),
        Eigen::VectorXd::Constant(columns.pairs, m_settings.pairOffset_m), m_settings.slope,
        Eigen::VectorXd::Constant(anchors, m_settings.anchorSlope),
        Eigen::VectorXd::Constant(columns.pairs, m_settings.pairSlope);

    std::vector<Row> rows;
    std::vector<std::vector<double>> spreads(m_samples.size());
    int number = 0;
    for (const auto& [pair, places] : m_samples) {
        const int tag = columns.tags.at(pair.first);
        const int anchor = columns.anchors.at(pair.second);
        for (const auto& [place, samples] : places) {
            const Place median = medianPlace(samples);
            rows.push_back({number,
                            {tag, tags + anchor, tags + anchors + number, slope, slope + 1 + anchor,
                             slope + 1 + anchors + number},
                            median.error_m,
                            median.distance_m});
            spreads[static_cast<std::size_t>(number)].push_back(median.spread_m);
        }
        ++number;
    }
    const Eigen::VectorXd unknowns = solveRows(rows, sds.cwiseAbs2().cwiseInverse(), m_settings.place_m);

    RangeBiases result;
    auto row = rows.begin();
    for (const auto& [pair, places] : m_samples) {
        RangeBias bias;
        bias.places = static_cast<int>(places.size());
        bias.noiseSd_m = std::max(medianOf(spreads[static_cast<std::size_t>(row->pair)]), kLeastNoise_m);
        std::vector<double> left;
        for (std::size_t i = 0; i < 6; ++i)
            (i < 3 ? bias.offset_m : bias.slope) += unknowns(row->columns[i]);
        for (; row != rows.end() && left.size() < places.size(); ++row)
            left.push_back(std::abs(row->error_m - row->predicted(unknowns)));
        // Few places say little about their own scatter: the prior counts as four of them.
        const double measured = kSdOfMad * medianOf(left);
        const double n = static_cast<double>(places.size());
        bias.sd_m =
            std::sqrt((4.0 * m_settings.place_m * m_settings.place_m + n * measured * measured) / (n + 4.0));
        result[pair] = bias;
    }
    return result;
}

} // namespace agv::estimation
