// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/survey_network.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <iterator>

namespace agv::estimation {
namespace {

constexpr int mostAdjustments = 100;
constexpr double settled_m = 1e-7;
constexpr double settledGain = 1e-7; ///< of chi squared, in a flat valley
constexpr double leastDistance_m = 1e-9;
constexpr double placesApart_m = 0.1;       ///< nearer ones are the same
constexpr std::ptrdiff_t mostFollowed = 64; ///< arrangements
/// An arrangement is no longer followed when its sum of squares is so many times what the best one has and
/// what its ranges make one expect. Much, because places are not adjusted to each other yet.
constexpr double hopeless = 100.0;
constexpr double flatWithinSds = 3.0;     ///< of the sum of three ranges
constexpr Eigen::Index freeMotions = 3;   ///< a network can be shifted and turned
constexpr double leastInformation = 1e-9; ///< 1/m^2; keeps matrices regular

/// Corner of a triangle above a base of its other two corners.
struct Apex {
    double along = 0.0; ///< from the first corner of the base
    double aside = 0.0; ///< >= 0; 0 when the sides do not meet
};

Apex apexOver(double base, double fromFirst, double fromSecond)
{
    const double along = (fromFirst * fromFirst + base * base - fromSecond * fromSecond) /
                         (2.0 * std::max(base, leastDistance_m));
    return {along, std::sqrt(std::max(0.0, fromFirst * fromFirst - along * along))};
}

double slant(const NetworkRange& range, const Eigen::Vector2d& apart)
{
    return std::max(std::hypot(apart.norm(), range.rise_m), leastDistance_m);
}

Eigen::Vector2d leftOf(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

} // namespace

double NetworkRange::floorDistance_m() const
{
    return std::sqrt(std::max(0.0, range_m * range_m - rise_m * rise_m));
}

void SurveyNetwork::add(const NetworkRange& range)
{
    m_ranges[std::minmax(range.first, range.second)] = range;
}

const NetworkRange* SurveyNetwork::between(int a, int b) const
{
    const auto found = m_ranges.find(std::minmax(a, b));
    return found == m_ranges.end() ? nullptr : &found->second;
}

TriangleStart SurveyNetwork::placeTriangle(double flattest)
{
    const std::set<int> ids = unplaced();
    TriangleStart start = TriangleStart::None;
    double largest = 0.0;
    for (const auto& [pair, base] : m_ranges) {
        for (auto id = ids.upper_bound(pair.second); id != ids.end(); ++id) {
            const NetworkRange* const one = between(pair.first, *id);
            const NetworkRange* const other = between(pair.second, *id);
            if (!one || !other)
                continue;
            const double a = other->floorDistance_m();
            const double b = one->floorDistance_m();
            const double c = base.floorDistance_m();
            const Apex apex = apexOver(c, b, a);
            const double longest = std::max({a, b, c});
            const double area = apex.aside * c;
            // The way round by the third corner must be longer than the errors of the ranges can make it.
            const double detour = a + b + c - 2.0 * longest;
            const double detourSd = std::hypot(base.sd_m, one->sd_m, other->sd_m);
            const bool isFlat = area < flattest * longest * longest || detour < flatWithinSds * detourSd;
            if (isFlat && start == TriangleStart::None)
                start = TriangleStart::Flat;
            if (isFlat || area <= largest)
                continue;
            start = TriangleStart::Placed;
            largest = area;
            m_places = {{pair.first, {0.0, 0.0}}, {pair.second, {c, 0.0}}, {*id, {apex.along, apex.aside}}};
        }
    }
    return start;
}

std::set<int> SurveyNetwork::unplaced() const
{
    std::set<int> ids;
    for (const auto& [pair, range] : m_ranges)
        for (const int id : {pair.first, pair.second})
            if (!m_places.contains(id))
                ids.insert(id);
    return ids;
}

std::vector<NetworkRange> SurveyNetwork::rangesToPlaced(int id) const
{
    std::vector<NetworkRange> ranges;
    for (const auto& [pair, range] : m_ranges)
        if ((pair.first == id || pair.second == id) && m_places.contains(range.otherThan(id)))
            ranges.push_back(range);
    return ranges;
}

std::pair<Eigen::Vector2d, Eigen::Vector2d> SurveyNetwork::placesFrom(const NetworkRange& one,
                                                                      const NetworkRange& other, int id) const
{
    const Eigen::Vector2d from = m_places.at(one.otherThan(id));
    const Eigen::Vector2d base = m_places.at(other.otherThan(id)) - from;
    const double length = std::max(base.norm(), leastDistance_m);
    const Apex apex = apexOver(length, one.floorDistance_m(), other.floorDistance_m());
    const Eigen::Vector2d foot = from + apex.along / length * base;
    const Eigen::Vector2d aside = apex.aside / length * leftOf(base);
    return {foot + aside, foot - aside};
}

double SurveyNetwork::misfit(const std::vector<NetworkRange>& ranges, int id,
                             const Eigen::Vector2d& place) const
{
    double sum = 0.0;
    for (const NetworkRange& range : ranges) {
        const double off =
            (range.range_m - slant(range, place - m_places.at(range.otherThan(id)))) / range.sd_m;
        sum += off * off;
    }
    return sum;
}

/// A few Gauss-Newton steps of one anchor alone, each taken only when it fits better.
Eigen::Vector2d SurveyNetwork::fitted(const std::vector<NetworkRange>& ranges, int id,
                                      Eigen::Vector2d place) const
{
    constexpr int steps = 10;
    for (int i = 0; i < steps; ++i) {
        Eigen::Matrix2d information = Eigen::Matrix2d::Identity() * leastInformation;
        Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
        for (const NetworkRange& range : ranges) {
            const Eigen::Vector2d apart = place - m_places.at(range.otherThan(id));
            const double d = slant(range, apart);
            const Eigen::Vector2d h = apart / d / range.sd_m;
            information += h * h.transpose();
            gradient += h * (range.range_m - d) / range.sd_m;
        }
        const Eigen::Vector2d next = place + information.ldlt().solve(gradient);
        if (!next.allFinite() || misfit(ranges, id, next) >= misfit(ranges, id, place))
            break;
        place = next;
    }
    return place;
}

/// Every two of the ranges give two places; of what becomes of them with all ranges the two best.
std::vector<Eigen::Vector2d> SurveyNetwork::likelyPlaces(const std::vector<NetworkRange>& ranges,
                                                         int id) const
{
    std::vector<Eigen::Vector2d> places;
    for (std::size_t i = 0; i < ranges.size(); ++i)
        for (std::size_t k = i + 1; k < ranges.size(); ++k) {
            const auto [left, right] = placesFrom(ranges[i], ranges[k], id);
            places.push_back(fitted(ranges, id, left));
            places.push_back(fitted(ranges, id, right));
        }
    std::ranges::sort(places, {}, [&](const Eigen::Vector2d& place) { return misfit(ranges, id, place); });
    const auto second = std::ranges::find_if(places, [&](const Eigen::Vector2d& place) {
        return (place - places.front()).norm() > placesApart_m;
    });
    if (second == places.end())
        return {places.front()};
    return {places.front(), *second};
}

std::vector<SurveyNetwork> SurveyNetwork::withNext() const
{
    int next = 0;
    std::vector<NetworkRange> ranges;
    for (const int id : unplaced())
        if (std::vector<NetworkRange> own = rangesToPlaced(id);
            own.size() > std::max<std::size_t>(ranges.size(), 1)) {
            next = id;
            ranges = std::move(own);
        }
    std::vector<SurveyNetwork> networks;
    if (ranges.empty())
        return networks;
    for (const Eigen::Vector2d& place : likelyPlaces(ranges, next)) {
        networks.push_back(*this);
        networks.back().m_places[next] = place;
    }
    return networks;
}

std::vector<NetworkRange> SurveyNetwork::placedRanges() const
{
    std::vector<NetworkRange> ranges;
    for (const auto& [pair, range] : m_ranges)
        if (m_places.contains(pair.first) && m_places.contains(pair.second))
            ranges.push_back(range);
    return ranges;
}

double SurveyNetwork::residualOf(const NetworkRange& range) const
{
    return range.range_m - slant(range, m_places.at(range.first) - m_places.at(range.second));
}

double SurveyNetwork::residual_m() const
{
    const std::vector<NetworkRange> ranges = placedRanges();
    double sum = 0.0;
    for (const NetworkRange& range : ranges)
        sum += residualOf(range) * residualOf(range);
    return ranges.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(ranges.size()));
}

int SurveyNetwork::redundancy() const
{
    return static_cast<int>(placedRanges().size()) - 2 * static_cast<int>(m_places.size()) +
           static_cast<int>(freeMotions);
}

double SurveyNetwork::chiSquared(const std::map<int, Eigen::Vector2d>& places) const
{
    double sum = 0.0;
    for (const NetworkRange& range : placedRanges()) {
        const double off =
            (range.range_m - slant(range, places.at(range.first) - places.at(range.second))) / range.sd_m;
        sum += off * off;
    }
    return sum;
}

void SurveyNetwork::normalEquations(Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const
{
    const auto size = 2 * static_cast<Eigen::Index>(m_places.size());
    information = Eigen::MatrixXd::Zero(size, size);
    gradient = Eigen::VectorXd::Zero(size);
    const auto rowOf = [this](int id) { return 2 * std::distance(m_places.begin(), m_places.find(id)); };
    for (const NetworkRange& range : placedRanges()) {
        const Eigen::Vector2d apart = m_places.at(range.first) - m_places.at(range.second);
        const double d = slant(range, apart);
        Eigen::VectorXd h = Eigen::VectorXd::Zero(size);
        h.segment<2>(rowOf(range.first)) = apart / d / range.sd_m;
        h.segment<2>(rowOf(range.second)) = -apart / d / range.sd_m;
        information += h * h.transpose();
        gradient += h * (range.range_m - d) / range.sd_m;
    }
}

/// Gauss-Newton with Levenberg's damping, which also holds the motions that no range sees.
void SurveyNetwork::adjust()
{
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
    double damping = 1e-6;
    for (int i = 0; i < mostAdjustments; ++i) {
        normalEquations(information, gradient);
        information.diagonal().array() += damping * information.diagonal().maxCoeff() + leastInformation;
        const Eigen::VectorXd step = information.ldlt().solve(gradient);
        if (!step.allFinite())
            return;
        std::map<int, Eigen::Vector2d> moved = m_places;
        Eigen::Index row = 0;
        for (auto& [id, place] : moved) {
            place += step.segment<2>(row);
            row += 2;
        }
        const double gain = chiSquared() - chiSquared(moved);
        if (gain >= 0.0) {
            m_places = std::move(moved);
            damping = std::max(damping * 0.1, 1e-9);
        } else {
            damping *= 10.0;
        }
        if (step.lpNorm<Eigen::Infinity>() < settled_m || (gain >= 0.0 && gain < settledGain))
            return;
    }
}

/// Of the network as a whole (inner constraints): the eigenvectors of the smallest eigenvalues are its free
/// motions and are left out. Larger residuals than the sds say make it larger.
Eigen::MatrixXd SurveyNetwork::covariance() const
{
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
    normalEquations(information, gradient);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information);
    const Eigen::Index seen = information.rows() - freeMotions;
    const Eigen::MatrixXd axes = eigen.eigenvectors().rightCols(seen);
    const Eigen::VectorXd variances =
        eigen.eigenvalues().tail(seen).cwiseMax(leastInformation).cwiseInverse();
    const int spare = redundancy();
    const double scale = spare > 0 ? std::max(1.0, chiSquared() / spare) : 1.0;
    return scale * axes * variances.asDiagonal() * axes.transpose();
}

std::vector<SurveyedAnchor> SurveyNetwork::inOwnFrame() const
{
    const Eigen::MatrixXd whole = covariance();
    auto place = m_places.begin();
    const Eigen::Vector2d origin = (place++)->second;
    const Eigen::Vector2d x = ((place++)->second - origin).normalized();
    const double side = leftOf(x).dot(place->second - origin) < 0.0 ? -1.0 : 1.0;
    std::vector<SurveyedAnchor> anchors;
    for (const auto& [id, at] : m_places) {
        const Eigen::Vector2d p = at - origin;
        const auto row = 2 * static_cast<Eigen::Index>(anchors.size());
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> own(whole.block<2, 2>(row, row));
        anchors.push_back({.id = id,
                           .position = {x.dot(p), side * leftOf(x).dot(p)},
                           .sd_m = std::sqrt(std::max(0.0, own.eigenvalues()(1)))});
    }
    return anchors;
}

std::vector<SurveyNetwork> arrangements(const SurveyNetwork& triangle)
{
    const auto likelihoodOrder = [](const SurveyNetwork& network) { return network.chiSquared(); };
    std::vector<SurveyNetwork> followed{triangle};
    // All have the same anchors placed, so all are continued by the same one.
    while (true) {
        std::vector<SurveyNetwork> next;
        for (const SurveyNetwork& network : followed)
            std::ranges::move(network.withNext(), std::back_inserter(next));
        if (next.empty())
            break;
        std::ranges::stable_sort(next, {}, likelihoodOrder);
        const double ranges = static_cast<double>(next.front().placedRanges().size());
        const double most = hopeless * (ranges + next.front().chiSquared());
        std::erase_if(next, [=](const SurveyNetwork& network) { return network.chiSquared() > most; });
        if (std::ssize(next) > mostFollowed)
            next.erase(next.begin() + mostFollowed, next.end());
        followed = std::move(next);
    }
    for (SurveyNetwork& network : followed)
        network.adjust();
    std::ranges::stable_sort(followed, {}, likelihoodOrder);
    return followed;
}

ArrangementDifference largestDifference(const SurveyNetwork& one, const SurveyNetwork& other)
{
    ArrangementDifference largest;
    for (auto a = one.places().begin(); a != one.places().end(); ++a)
        for (auto b = std::next(a); b != one.places().end(); ++b) {
            const double here = (a->second - b->second).norm();
            const double there = (other.places().at(a->first) - other.places().at(b->first)).norm();
            if (std::abs(here - there) > largest.metres)
                largest = {a->first, b->first, std::abs(here - there)};
        }
    return largest;
}

} // namespace agv::estimation
