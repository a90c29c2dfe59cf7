// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/turn_solution.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

/// Larger than these the pose is no base for driving; on 400 thinned turns every error above 20 mm or
/// 15 degrees had a larger sd (study, section A.3, "few reads").
constexpr double kWeakSd_m = 0.008;
constexpr double kWeakHeadingSd = radFromDeg(6.0);
constexpr double kReadsPerStop = 2.0; ///< fewer tags per stop than this: FewReads
constexpr int kFewestStopsWithReads = 4;
constexpr double kUneven = radFromDeg(4.0);
constexpr double kAmbiguousLogOdds = 4.6; ///< 1 : 100
constexpr double kPoorFitSds = 4.5;

Pose2 plantPose(const TurnEvidence& evidence, Point2 centre, double bearing)
{
    return {evidence.origin + centre, wrapAngle(bearing - evidence.antennaBearing)};
}

PoseCovariance withAntennaOffset(PoseCovariance covariance, double antennaSd_m, double radius_m)
{
    const double lateral = antennaSd_m / radius_m;
    covariance[8] += lateral * lateral;
    return covariance;
}

RssiTable scaled(RssiTable table, double scale)
{
    for (RssiStep& step : table)
        step.upperEdge *= scale;
    return table;
}

/// The noise as seen from the estimated antenna position, which is itself uncertain.
NoiseModel widened(NoiseModel noise, double antennaSd_m)
{
    noise.distanceSd_m = std::hypot(noise.distanceSd_m, antennaSd_m);
    return noise;
}

/// How far the log likelihood of the reads lies below its expectation, in standard deviations.
class FitTest {
public:
    void add(const OutcomeProbabilities& p, TagOutcome outcome, double weight)
    {
        double mean = 0.0;
        double square = 0.0;
        for (const double probability : p) {
            if (probability <= 0.0)
                continue;
            const double value = std::log(probability);
            mean += probability * value;
            square += probability * value * value;
        }
        const double w = std::min(weight, 1.0);
        m_excess += w * (mean - std::log(std::max(p[static_cast<std::size_t>(outcome)], 1e-12)));
        m_variance += w * w * (square - mean * mean);
    }
    double standardDeviationsBelow() const { return m_excess / std::sqrt(m_variance + 1.0); }

private:
    double m_excess = 0.0;
    double m_variance = 0.0;
};

double misfit(const TurnSolution& solution, const TurnEvidence& evidence, const RssiTable& table)
{
    FitTest test;
    for (std::size_t k = 0; k < evidence.stops.size(); ++k) {
        const Point2 antenna = solution.antennaAt(k);
        const RssiLikelihood likelihood(table, widened(solution.noise, solution.antennaSd_m[k]));
        for (const TagTerm& term : evidence.stops[k].terms) {
            const double d = distance(antenna, {term.x, term.y});
            if (term.outcome != kNotRead || d < 1.5 * table.front().upperEdge)
                test.add(likelihood.probabilities(d), term.outcome, term.weight);
        }
    }
    return test.standardDeviationsBelow();
}

std::vector<TurnFlag> flagsOf(const TurnSolution& solution, const TurnEvidence& evidence,
                              const TurnEstimate& estimate, const TurnRecord& record, double misfitSds)
{
    std::vector<TurnFlag> flags;
    const auto& c = estimate.covariance;
    if (std::sqrt(std::max(c[0], c[4])) > kWeakSd_m || std::sqrt(c[8]) > kWeakHeadingSd)
        flags.push_back(TurnFlag::Weak);
    if (solution.split || (solution.alternative && solution.alternative->logOdds < kAmbiguousLogOdds))
        flags.push_back(TurnFlag::Ambiguous);
    if (evidence.tagsRead < kReadsPerStop * static_cast<double>(evidence.stops.size()) ||
        evidence.stopsWithReads < kFewestStopsWithReads)
        flags.push_back(TurnFlag::FewReads);
    if (record.rotation && *record.rotation != solution.rotation)
        flags.push_back(TurnFlag::WrongRotation);
    if (solution.unevenness > kUneven)
        flags.push_back(TurnFlag::UnevenSteps);
    if (misfitSds > kPoorFitSds)
        flags.push_back(TurnFlag::PoorFit);
    if (!solution.converged)
        flags.push_back(TurnFlag::NotConverged);
    return flags;
}

StopReport reportOf(const TurnSolution& solution, const TurnEvidence& evidence, const TurnStop& stop,
                    std::size_t k, const RssiTable& table)
{
    StopReport report;
    const Point2 antenna = solution.antennaAt(k);
    report.antenna = evidence.origin + antenna;
    report.antennaBearing = wrapAngle(solution.bearings[k]);
    report.antennaSd_m = solution.antennaSd_m[k];
    report.unknown = evidence.stops[k].unknown;
    report.misplaced = evidence.stops[k].misplaced;
    const RssiLikelihood likelihood(table, widened(solution.noise, report.antennaSd_m));
    const double farthest = table.front().upperEdge + 4.0 * report.antennaSd_m + 0.05;
    for (const NearTag& tag : evidence.nearTags) {
        const double d = distance(antenna, tag.position);
        const bool seen = std::ranges::any_of(stop.reads, [&](const TagRead& r) { return r.uid == tag.uid; });
        const bool expected =
            d <= farthest && likelihood.probabilities(d)[static_cast<std::size_t>(kNotRead)] < 0.5;
        if (expected)
            report.expected.push_back(tag.uid);
        if (seen)
            (d <= farthest ? report.seen : report.misplaced).push_back(tag.uid);
        else if (expected && std::ranges::find(stop.unknownIfUnseen, tag.uid) == stop.unknownIfUnseen.end())
            report.missed.push_back(tag.uid);
    }
    return report;
}

void addTurnTime(const TurnRecord& record, TurnEstimate& estimate)
{
    if (record.kind != TurnKind::Timed || !record.turnTime_s || !std::isfinite(*record.turnTime_s) ||
        *record.turnTime_s <= 0.0 || estimate.step <= 0.0)
        return;
    estimate.suggestedTurnTime_s = *record.turnTime_s * record.nominalStep / estimate.step;
    estimate.suggestedTurnTimeSd_s = *estimate.suggestedTurnTime_s * estimate.stepSd / estimate.step;
}

} // namespace

Point2 TurnSolution::antennaAt(std::size_t stop) const
{
    const std::size_t last = bearings.size() - 1;
    const double share = last > 0 ? static_cast<double>(stop) / static_cast<double>(last) : 0.0;
    const Point2 arm{radius_m * std::cos(bearings[stop]), radius_m * std::sin(bearings[stop])};
    return centre + share * drift + arm;
}

TurnEstimate toEstimate(const TurnSolution& solution, const TurnEvidence& evidence, const TurnRecord& record,
                        const TurnContext& context)
{
    TurnEstimate estimate;
    estimate.valid = true;
    estimate.status = "ok";
    estimate.startPose = plantPose(evidence, solution.centre, solution.bearings.front());
    estimate.pose = plantPose(evidence, solution.centre + solution.drift, solution.bearings.back());
    const double antennaSd_m = std::clamp(context.antennaSd_m, 0.0, solution.radius_m);
    estimate.covariance = withAntennaOffset(solution.covariance, antennaSd_m, solution.radius_m);
    estimate.lastHeadingSd = std::hypot(solution.lastBearingSd, antennaSd_m / solution.radius_m);
    estimate.radius_m = solution.radius_m;
    estimate.rotation = solution.rotation;
    estimate.rotationLogOdds = solution.rotationLogOdds;
    estimate.step = solution.step;
    estimate.stepSd = solution.stepSd;
    addTurnTime(record, estimate);
    estimate.profile = solution.profile;
    estimate.logEvidence = solution.logEvidence;
    if (solution.alternative)
        estimate.alternative =
            AlternativePose{plantPose(evidence, solution.alternative->centre, solution.alternative->bearing),
                            solution.alternative->logOdds};
    const RssiTable table = scaled(context.rssiTable, solution.tableScale);
    estimate.flags = flagsOf(solution, evidence, estimate, record, misfit(solution, evidence, table));
    for (std::size_t k = 0; k < evidence.stops.size(); ++k)
        estimate.stops.push_back(reportOf(solution, evidence, record.stops[k], k, table));
    return estimate;
}

TurnEstimate noPose(SolveMethod method, std::string status, std::size_t stops)
{
    TurnEstimate estimate;
    estimate.method = method;
    estimate.status = std::move(status);
    if (estimate.status == "no_reads")
        estimate.flags.push_back(TurnFlag::NoReads);
    estimate.stops.resize(stops);
    return estimate;
}

} // namespace agv::estimation
