// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/turn_solver.h"

#include "estimation/classic/classic_solver.h"
#include "estimation/fast/fast_solver.h"
#include "estimation/joint/joint_solver.h"

#include <chrono>
#include <cmath>

namespace agv::estimation {

namespace {

TurnEstimate solveFastTurn(const TurnRecord& record, const TurnContext& context, const TurnEvidence& evidence,
                           std::stop_token stop)
{
    const std::optional<TurnSolution> solution = solveFast(evidence, record, context.rssiTable, stop);
    if (!solution)
        return noPose(SolveMethod::Fast, "too_few_stops", record.stops.size());
    return toEstimate(*solution, evidence, record, context);
}

TurnEstimate solveJointTurn(const TurnRecord& record, const TurnContext& context,
                            const TurnEvidence& evidence, const SolveOptions& options)
{
    const std::optional<TurnSolution> solution = solveJoint(evidence, record, context, options);
    if (!solution)
        return noPose(SolveMethod::Auto, "no_solution", record.stops.size());
    return toEstimate(*solution, evidence, record, context);
}

bool finite(const TurnEstimate& estimate)
{
    double sum = estimate.startPose.position.x + estimate.startPose.position.y + estimate.startPose.heading +
                 estimate.pose.heading + estimate.step + estimate.stepSd + estimate.radius_m +
                 estimate.lastHeadingSd;
    for (const double c : estimate.covariance)
        sum += c;
    return std::isfinite(sum);
}

TurnEstimate solve(const TurnRecord& record, const TurnContext& context, const SolveOptions& options)
{
    if (options.method == SolveMethod::Classic)
        return solveClassic(record, context);
    const auto evidence = prepareEvidence(record, context);
    if (const auto* problem = std::get_if<std::string>(&evidence))
        return noPose(options.method, *problem, record.stops.size());
    const auto& usable = std::get<TurnEvidence>(evidence);
    if (options.stop.stop_requested())
        return noPose(options.method, "cancelled", record.stops.size());
    TurnEstimate estimate = options.method == SolveMethod::Fast
                                ? solveFastTurn(record, context, usable, options.stop)
                                : solveJointTurn(record, context, usable, options);
    if (options.stop.stop_requested())
        return noPose(options.method, "cancelled", record.stops.size());
    if (estimate.valid && !finite(estimate))
        return noPose(options.method, "not_finite", record.stops.size());
    return estimate;
}

} // namespace

TurnContext contextFor(const PlantLayout& plant, const AgvConfig& agv)
{
    TurnContext context;
    context.tags = plant.floorTags;
    context.rssiTable = plant.rssiTable;
    context.antenna = agv.antenna;
    return context;
}

TurnEstimate solveTurn(const TurnRecord& record, const TurnContext& context, const SolveOptions& options)
{
    const auto begin = std::chrono::steady_clock::now();
    TurnEstimate estimate = solve(record, context, options);
    estimate.method = options.method;
    estimate.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return estimate;
}

} // namespace agv::estimation
