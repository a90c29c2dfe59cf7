// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/anchor_watch.h"

#include "estimation/uwb/range_fix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <limits>
#include <utility>

namespace agv::estimation {
namespace {

constexpr std::size_t rangesToWatch = 4; ///< three give a place, the fourth can contradict it
/// Reports that follow each other, and places near each other, have much of their errors in common: so many
/// reports count as one.
constexpr double reportsOfOneError = 16.0;
/// Least share of the ranges that are too long, or too short, by half the median or more.
constexpr double mostAlike = 0.7;
/// Where an anchor went is not said when it is less certain.
constexpr double mostMoveSd_m = 0.25;
/// Cauchy's weights fall from this many sds on.
constexpr double cauchySds = 2.0;

Eigen::Vector3d seenFrom(const AnchorRange& range, const Eigen::Vector2d& place, double height_m)
{
    return Eigen::Vector3d(place.x(), place.y(), height_m) - range.anchor;
}

struct PlaceOfOthers {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    bool isGood = false;
};

/// Gauss-Newton from a near start with Huber's weights, all ranges but those of one anchor.
PlaceOfOthers placeWithout(const AnchorRangeList& ranges, int without, double height_m, double sd_m,
                           Eigen::Vector2d place)
{
    constexpr int steps = 8;
    constexpr double huberSds = 1.5;
    constexpr double mostStep_m = 1.0;
    constexpr double settled_m = 1e-4;
    constexpr double leastInformation = 0.02; ///< of the worst direction, over that of one range head on
    PlaceOfOthers result;
    for (int i = 0; i < steps; ++i) {
        Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        for (const AnchorRange& range : ranges) {
            if (range.index == without)
                continue;
            const Eigen::Vector3d apart = seenFrom(range, place, height_m);
            const double d = std::max(apart.norm(), kLeastDistance_m);
            const double off = (range.range_m - d) / sd_m;
            const double weight = std::min(1.0, huberSds / std::max(std::abs(off), kLeastDistance_m));
            const Eigen::Vector2d h = apart.head<2>() / d;
            information += weight * h * h.transpose();
            gradient += weight * h * (range.range_m - d);
        }
        // A trace of what the ranges leave open keeps the step finite.
        const double least = 0.5 * (information.trace() - std::hypot(information(0, 0) - information(1, 1),
                                                                     2.0 * information(0, 1)));
        if (!(least > leastInformation))
            return result;
        Eigen::Vector2d step = information.inverse() * gradient;
        if (step.norm() > mostStep_m)
            step *= mostStep_m / step.norm();
        place += step;
        if (step.norm() < settled_m || i + 1 == steps) {
            result = {.place = place, .covariance = sd_m * sd_m * information.inverse(), .isGood = true};
            break;
        }
    }
    return result;
}

double median(std::vector<double>& values)
{
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

std::string toText(const AnchorDoubt& doubt)
{
    const std::string amount = std::to_string(std::lround(mmFromMetres(doubt.amount_m))) + " mm";
    switch (doubt.kind) {
    case AnchorDoubtKind::Moved:
        break;
    case AnchorDoubtKind::TooLong:
        return "Ranges are " + amount + " too long: the anchor may have been moved or be hidden; look at it";
    case AnchorDoubtKind::TooShort:
        return "Ranges are " + amount +
               " too short: the anchor may have been moved; measure it again or calibrate its ranges";
    }
    return "Ranges fit a place " + amount +
           " from the one in the list: measure the anchor again or restore it";
}

AnchorWatch::AnchorWatch(const AnchorWatchSettings& settings) : m_settings(settings)
{
    const auto most = static_cast<std::size_t>(m_settings.mostReports);
    m_reports.reserve(most);
    m_sights.reserve(most);
    m_residuals_m.reserve(most);
}

void AnchorWatch::clear()
{
    m_reports.clear();
    m_next = 0;
    m_lastOfTag_s.clear();
    m_candidate.reset();
    m_doubt.reset();
}

void AnchorWatch::add(int tag, AnchorRanges ranges, double height_m, double time_s)
{
    if (ranges.size() < rangesToWatch || ranges.size() > std::size_t{kMaxAnchors})
        return;
    const auto [last, isFirst] = m_lastOfTag_s.try_emplace(tag, time_s);
    if (!isFirst && std::abs(time_s - last->second) < m_settings.sampleEvery_s)
        return;
    last->second = time_s;
    const UwbFix fix = fixFromRanges(ranges, {.height = TagHeight{height_m, 0.0}});
    if (!fix.ok())
        return;
    Report report;
    report.time_s = time_s;
    report.height_m = height_m;
    report.place = fix.position.head<2>();
    for (const AnchorRange& range : ranges)
        report.ranges.add(range);
    if (m_reports.size() < static_cast<std::size_t>(m_settings.mostReports))
        m_reports.push_back(report);
    else
        m_reports[m_next++ % m_reports.size()] = report;
    if (std::abs(time_s - m_decided_s) >= m_settings.decideEvery_s)
        decide(time_s);
}

void AnchorWatch::decide(double now_s)
{
    m_decided_s = now_s;
    m_now_s = now_s;
    confirm(candidate(), now_s);
}

/// A decision counts when it has been the same for a while, and until it has been another for as long as a
/// decision takes.
void AnchorWatch::confirm(std::optional<AnchorDoubt> candidate, double now_s)
{
    const auto isSame = [](const std::optional<AnchorDoubt>& a, const std::optional<AnchorDoubt>& b) {
        return a.has_value() == b.has_value() && (!a || (a->index == b->index && a->kind == b->kind));
    };
    if (!isSame(candidate, m_candidate))
        m_candidateSince_s = now_s;
    m_candidate = candidate;
    const double lasted_s = now_s - m_candidateSince_s;
    const bool isOfTime = candidate && candidate->kind != AnchorDoubtKind::Moved;
    if (lasted_s >= (isOfTime ? m_settings.hidden_s : m_settings.moved_s))
        m_doubt = candidate;
}

double AnchorWatch::capped(double residual, double variance) const
{
    return std::min(residual * residual / variance, m_settings.gateSds * m_settings.gateSds);
}

double AnchorWatch::costOf(const Report& report, const Eigen::Vector2d& place, int without) const
{
    double cost = 0.0;
    for (const AnchorRange& range : report.ranges)
        if (range.index != without)
            cost += capped(range.range_m - seenFrom(range, place, report.height_m).norm(),
                           m_settings.sd_m * m_settings.sd_m);
    return cost;
}

std::optional<AnchorDoubt> AnchorWatch::candidate()
{
    std::array<int, kMaxAnchors> counts{};
    double listedCost = 0.0;
    for (const Report& report : m_reports) {
        if (m_now_s - report.time_s > m_settings.window_s)
            continue;
        listedCost += costOf(report, report.place, -1);
        for (const AnchorRange& range : report.ranges)
            ++counts.at(static_cast<std::size_t>(range.index));
    }
    Hypothesis best;
    best.cost = std::numeric_limits<double>::max();
    double next = std::numeric_limits<double>::max();
    for (int index = 0; index < kMaxAnchors; ++index) {
        if (counts[static_cast<std::size_t>(index)] < m_settings.reportsNeeded)
            continue;
        const Hypothesis hypothesis = tryAnchor(index);
        next = std::min(next, std::max(hypothesis.cost, best.cost));
        if (hypothesis.cost < best.cost)
            best = hypothesis;
    }
    if (best.index < 0 || best.cost > m_settings.explained * listedCost ||
        next < m_settings.clearer * best.cost)
        return std::nullopt;
    return judge(best);
}

std::optional<AnchorDoubt> AnchorWatch::judge(const Hypothesis& hypothesis) const
{
    const Eigen::Vector2d& move = hypothesis.moved.move;
    const Eigen::Matrix2d& covariance = hypothesis.moved.moveCovariance;
    const double sds = std::sqrt(std::max(0.0, move.dot(covariance.inverse() * move)));
    const double worstSd_m = std::sqrt(covariance.trace());
    if (move.norm() >= m_settings.leastMove_m && sds >= m_settings.significantSds &&
        worstSd_m <= mostMoveSd_m && hypothesis.moved.cost <= m_settings.explained * hypothesis.hidden.cost)
        return AnchorDoubt{.index = hypothesis.index,
                           .kind = AnchorDoubtKind::Moved,
                           .amount_m = move.norm(),
                           .displacement = {move.x(), move.y()}};
    const double leastBias_m =
        std::max(m_settings.leastBias_m, m_settings.significantSds * hypothesis.residualSd_m);
    if (std::abs(hypothesis.residual_m) < leastBias_m || hypothesis.alike < mostAlike)
        return std::nullopt;
    return AnchorDoubt{.index = hypothesis.index,
                       .kind =
                           hypothesis.residual_m > 0.0 ? AnchorDoubtKind::TooLong : AnchorDoubtKind::TooShort,
                       .amount_m = std::abs(hypothesis.residual_m),
                       .displacement = {}};
}

AnchorWatch::Hypothesis AnchorWatch::tryAnchor(int index)
{
    Hypothesis hypothesis;
    hypothesis.index = index;
    m_sights.clear();
    m_residuals_m.clear();
    const double noise = m_settings.sd_m * m_settings.sd_m;
    for (const Report& report : m_reports) {
        if (m_now_s - report.time_s > m_settings.window_s)
            continue;
        const auto own = std::ranges::find(report.ranges, index, &AnchorRange::index);
        const PlaceOfOthers others =
            own == report.ranges.end()
                ? PlaceOfOthers{}
                : placeWithout(report.ranges, index, report.height_m, m_settings.sd_m, report.place);
        if (!others.isGood) {
            hypothesis.cost += costOf(report, report.place, -1);
            continue;
        }
        hypothesis.cost += costOf(report, others.place, index);
        Sight sight{.fromAnchor = seenFrom(*own, others.place, report.height_m), .range_m = own->range_m};
        const double d = std::max(sight.fromAnchor.norm(), kLeastDistance_m);
        const Eigen::Vector2d h = sight.fromAnchor.head<2>() / d;
        sight.variance = noise + h.dot(others.covariance * h);
        m_sights.push_back(sight);
        m_residuals_m.push_back(sight.range_m - d);
    }
    if (m_sights.empty())
        return hypothesis;
    hypothesis.hidden = fitted(false);
    hypothesis.moved = fitted(true);
    hypothesis.cost += std::min(hypothesis.hidden.cost, hypothesis.moved.cost);
    hypothesis.residual_m = median(m_residuals_m);
    double variance = 0.0;
    for (const Sight& sight : m_sights)
        variance += sight.variance / static_cast<double>(m_sights.size());
    hypothesis.residualSd_m = std::sqrt(variance);
    const auto alike = std::ranges::count_if(m_residuals_m, [half = 0.5 * hypothesis.residual_m](double off) {
        return half > 0.0 ? off >= half : off <= half;
    });
    hypothesis.alike = static_cast<double>(alike) / static_cast<double>(m_residuals_m.size());
    return hypothesis;
}

/// Iterated least squares of (b, d) with b as small as delays are, or of any b alone.
AnchorWatch::Fit AnchorWatch::fitted(bool mayMove) const
{
    constexpr int steps = 20;
    constexpr double unknownSd_m = 1e3;
    constexpr double settled_m = 1e-5;
    Fit fit;
    const double biasSd_m = mayMove ? m_settings.delaySd_m : unknownSd_m;
    const Eigen::Vector3d prior(reportsOfOneError / (biasSd_m * biasSd_m), 1.0 / (unknownSd_m * unknownSd_m),
                                1.0 / (unknownSd_m * unknownSd_m));
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    const auto residualOf = [&](const Sight& sight, Eigen::Vector3d& h) {
        Eigen::Vector3d apart = sight.fromAnchor;
        apart.head<2>() -= fit.move;
        const double d = std::max(apart.norm(), kLeastDistance_m);
        h << 1.0, mayMove ? -apart.x() / d : 0.0, mayMove ? -apart.y() / d : 0.0;
        return sight.range_m - d - fit.bias_m;
    };
    Eigen::Vector3d h;
    for (int i = 0; i < steps; ++i) {
        Eigen::Matrix3d information = prior.asDiagonal();
        Eigen::Vector3d gradient(-prior(0) * fit.bias_m, -prior(1) * fit.move.x(), -prior(2) * fit.move.y());
        for (const Sight& sight : m_sights) {
            const double off = residualOf(sight, h);
            // Cauchy's weight: what is far off hardly counts, yet pulls while everything is far off.
            const double weight = 1.0 / (sight.variance + off * off / (cauchySds * cauchySds));
            information += weight * h * h.transpose();
            gradient += weight * h * off;
        }
        covariance = information.inverse();
        const Eigen::Vector3d step = covariance * gradient;
        if (!step.allFinite())
            break;
        fit.bias_m += step(0);
        fit.move += step.tail<2>();
        if (step.norm() < settled_m)
            break;
    }
    fit.moveCovariance = reportsOfOneError * covariance.bottomRightCorner<2, 2>();
    for (const Sight& sight : m_sights)
        fit.cost += capped(residualOf(sight, h), sight.variance);
    return fit;
}

} // namespace agv::estimation
