// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/classic_solver.h"

#include "estimation/classic/circle_geometry.h"
#include "estimation/classic/classic_covariance.h"
#include "estimation/classic/classic_reports.h"
#include "estimation/classic/stop_antenna.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace agv::estimation {

namespace {

constexpr double pi = std::numbers::pi;

/// Two lines that cross at a smaller angle fix their crossing too badly; half of the smallest step (22.5
/// degrees) of a turn.
const double leastCrossingSine = std::sin(radFromDeg(11.25));

/// What an operator's command weighs against the antennas: wrong once in a hundred turns.
const double commandLogOdds = std::log(99.0);

/// Share of the nominal step by which the real one may differ (standard deviation); the study's section A.3.
constexpr double unmeasuredStepShare = 0.12;

/// Half a turn in steps, when it is a whole number of them.
std::optional<std::size_t> stepsOfHalfTurn(double nominalStep)
{
    constexpr double mostSteps = 360.0;
    if (!(nominalStep > pi / mostSteps) || !(nominalStep <= pi))
        return std::nullopt;
    const double steps = std::round(pi / nominalStep);
    if (std::abs(steps * nominalStep - pi) > 1e-3 * pi)
        return std::nullopt;
    return static_cast<std::size_t>(steps);
}

std::vector<std::optional<Point2>> antennasOf(const TurnRecord& record, const TurnContext& context,
                                              const TagMap& positions)
{
    std::vector<std::optional<Point2>> antennas;
    antennas.reserve(record.stops.size());
    for (const TurnStop& stop : record.stops) {
        const std::vector<TagAtStop> tags = tagsAtStop(stop, positions);
        antennas.push_back(antennaFromShape(tags, tagPitch(tags, context.tags), context.rssiTable));
    }
    return antennas;
}

/// The four antennas that the pose is built from.
struct Construction {
    std::size_t firstStop = 0;
    std::array<Point2, 4> antennas; ///< at stops a, a + half, b, b + half
    Point2 centre;
};

bool crossWell(const std::array<Point2, 4>& antennas)
{
    const Point2 a = antennas[1] - antennas[0];
    const Point2 b = antennas[3] - antennas[2];
    return std::abs(a.x * b.y - a.y * b.x) >= leastCrossingSine * std::hypot(a.x, a.y) * std::hypot(b.x, b.y);
}

/// Step 3: the first two pairs, in order of time, whose lines cross well.
std::expected<Construction, const char*> construct(const std::vector<std::optional<Point2>>& antennas,
                                                   std::size_t half)
{
    std::vector<std::size_t> pairs;
    for (std::size_t stop = 0; stop + half < antennas.size(); ++stop) {
        if (antennas[stop] && antennas[stop + half])
            pairs.push_back(stop);
    }
    bool distinctLines = false;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (std::size_t j = i + 1; j < pairs.size(); ++j) {
            const std::size_t a = pairs[i];
            const std::size_t b = pairs[j];
            if ((b - a) % half == 0)
                continue; // the same line again, half a turn later
            distinctLines = true;
            const std::array<Point2, 4> four{*antennas[a], *antennas[a + half], *antennas[b],
                                             *antennas[b + half]};
            const auto centre = intersectLines(four[0], four[1], four[2], four[3]);
            if (centre && crossWell(four))
                return Construction{a, four, *centre};
        }
    }
    return std::unexpected(distinctLines ? "parallel" : "no_solution");
}

/// Bearing of each antenna that is known, rad.
std::vector<StopBearing> bearingsAbout(Point2 centre, const std::vector<std::optional<Point2>>& antennas)
{
    std::vector<StopBearing> bearings;
    for (std::size_t stop = 0; stop < antennas.size(); ++stop) {
        if (!antennas[stop])
            continue;
        const Point2 arm = *antennas[stop] - centre;
        bearings.push_back({static_cast<double>(stop), std::atan2(arm.y, arm.x), std::hypot(arm.x, arm.y)});
    }
    return bearings;
}

/// Log odds of counter-clockwise against clockwise from the bearings of successive known antennas, each of
/// standard deviation `bearingSd` (rad).
double counterClockwiseLogOdds(const std::vector<StopBearing>& bearings, double nominalStep, double bearingSd)
{
    const double concentration = 1.0 / (2.0 * bearingSd * bearingSd);
    double logOdds = 0.0;
    for (std::size_t k = 1; k < bearings.size(); ++k) {
        const double turned = bearings[k].bearing - bearings[k - 1].bearing;
        const double nominal = nominalStep * (bearings[k].stop - bearings[k - 1].stop);
        logOdds += concentration * (std::cos(turned - nominal) - std::cos(turned + nominal));
    }
    return logOdds;
}

void addPoses(TurnEstimate& estimate, const TurnRecord& record, const TurnContext& context,
              const Construction& construction, const std::vector<StopBearing>& bearings)
{
    const int sign = signOf(estimate.rotation);
    const double mounting = std::atan2(context.antenna.y, context.antenna.x);
    const Point2 arm = construction.antennas[0] - construction.centre;
    const double bearingAtStart =
        std::atan2(arm.y, arm.x) - sign * record.nominalStep * static_cast<double>(construction.firstStop);
    estimate.startPose = {construction.centre, wrapAngle(bearingAtStart - mounting)};

    const auto lastStop = static_cast<double>(record.stops.size() - 1);
    const bool lastIsMeasured = bearings.back().stop == lastStop;
    const double lastHeading = lastIsMeasured ? bearings.back().bearing - mounting
                                              : estimate.startPose.heading + sign * lastStop * estimate.step;
    estimate.pose = {construction.centre, wrapAngle(lastHeading)};
    const double headingSd = std::sqrt(estimate.covariance[8]);
    estimate.lastHeadingSd = lastIsMeasured ? headingSd : std::hypot(headingSd, lastStop * estimate.stepSd);
}

void addFlags(TurnEstimate& estimate, const TurnRecord& record, std::size_t usableStops, double scatter_m,
              double expectedRadius_m)
{
    constexpr double weakPositionSd_m = 0.030;
    const double weakHeadingSd = radFromDeg(15.0);
    constexpr double poorScatter_m = 0.035;
    constexpr double poorRadiusShare = 0.4;

    const double positionSd = std::sqrt(std::max(estimate.covariance[0], estimate.covariance[4]));
    if (positionSd > weakPositionSd_m || std::sqrt(estimate.covariance[8]) > weakHeadingSd)
        estimate.flags.push_back(TurnFlag::Weak);
    if (2 * usableStops < record.stops.size())
        estimate.flags.push_back(TurnFlag::FewReads);
    if (record.rotation && *record.rotation != estimate.rotation)
        estimate.flags.push_back(TurnFlag::WrongRotation);
    if (scatter_m > poorScatter_m ||
        std::abs(estimate.radius_m - expectedRadius_m) > poorRadiusShare * expectedRadius_m)
        estimate.flags.push_back(TurnFlag::PoorFit);
}

TurnEstimate failed(const char* status, const TurnRecord& record, const TagMap& positions)
{
    TurnEstimate estimate;
    estimate.status = status;
    estimate.stops = reportsWithoutPose(record, positions);
    return estimate;
}

TurnEstimate solve(const TurnRecord& record, const TurnContext& context)
{
    TagMap positions;
    for (const FloorTag& tag : context.tags)
        positions.emplace(tag.uid, tag.position);

    const bool anyRead = std::ranges::any_of(record.stops, [&](const TurnStop& stop) {
        return std::ranges::any_of(stop.reads,
                                   [&](const TagRead& read) { return positions.contains(read.uid); });
    });
    if (!anyRead) {
        TurnEstimate estimate = failed("no_reads", record, positions);
        estimate.flags = {TurnFlag::NoReads};
        return estimate;
    }
    const auto half = stepsOfHalfTurn(record.nominalStep);
    if (!half)
        return failed("bad_step", record, positions);
    const std::vector<std::optional<Point2>> antennas = antennasOf(record, context, positions);
    const auto construction = construct(antennas, *half);
    if (!construction)
        return failed(construction.error(), record, positions);

    TurnEstimate estimate;
    estimate.valid = true;
    estimate.status = "ok";
    const std::vector<StopBearing> bearings = bearingsAbout(construction->centre, antennas);
    const double radius = meanRadius(bearings);
    const double scatter = antennaScatter(bearings);
    const double bearingSd = scatter / std::max(radius, scatter);
    estimate.radius_m = radius;

    double logOdds = counterClockwiseLogOdds(bearings, record.nominalStep, bearingSd);
    if (record.rotation)
        logOdds += signOf(*record.rotation) * commandLogOdds;
    estimate.rotation = logOdds >= 0.0 ? Rotation::CounterClockwise : Rotation::Clockwise;
    estimate.rotationLogOdds = std::abs(logOdds);

    estimate.step = record.nominalStep;
    estimate.stepSd = unmeasuredStepShare * record.nominalStep;
    const double armLength = std::hypot(context.antenna.x, context.antenna.y);
    const double mountingSd = armLength > 0.0 ? context.antennaSd_m / armLength : pi;
    estimate.covariance = classicCovariance(construction->antennas, scatter, mountingSd);
    addPoses(estimate, record, context, *construction, bearings);
    addFlags(estimate, record, bearings.size(), scatter, armLength);
    estimate.stops = reportsAround(estimate, record, context, positions, antennas, scatter);
    return estimate;
}

} // namespace

TurnEstimate solveClassic(const TurnRecord& record, const TurnContext& context)
{
    const auto start = std::chrono::steady_clock::now();
    TurnEstimate estimate = solve(record, context);
    estimate.method = SolveMethod::Classic;
    estimate.elapsed_s = secondsFrom(std::chrono::steady_clock::now() - start);
    return estimate;
}

} // namespace agv::estimation
