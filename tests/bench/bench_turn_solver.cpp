// SPDX-License-Identifier: GPL-3.0-or-later
// Error statistics and run time of the turn solvers on the study's scenarios.
//   bench_turn_solver [--method auto|fast] [--files | --fresh SEED | --hard] [--turns N] [--scenario PREFIX]
//   [--worst]
#include "estimation/error_metrics.h"
#include "estimation/turn_scenarios.h"

#include <array>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>

namespace {

using namespace agv;
using namespace agv::estimation;
using namespace agv::estimation::testing;

struct Settings {
    SolveMethod method = SolveMethod::Auto;
    bool fresh = false;
    std::uint64_t seed = 1;
    int turns = 100;
    std::string scenario;
    bool worst = false;
    bool hard = false;
};

/// Harder and other turns than the study's; generated only.
constexpr std::array<TurnScenario, 16> kHardScenarios{{
    {.name = "H1_all_miss50",
     .offByOne = 0.4,
     .missed = 0.5,
     .stepError = 0.2,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02},
    {.name = "H2_all_miss70",
     .offByOne = 0.4,
     .missed = 0.7,
     .stepError = 0.2,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02},
    {.name = "H3_all_miss80",
     .offByOne = 0.4,
     .missed = 0.8,
     .stepError = 0.2,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02},
    {.name = "H4_all_miss90",
     .offByOne = 0.4,
     .missed = 0.9,
     .stepError = 0.2,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02},
    {.name = "H5_step35_jit3",
     .offByOne = 0.4,
     .missed = 0.2,
     .stepError = 0.35,
     .jitter_deg = 3.0,
     .antenna_mm = 2.0,
     .tag_mm = 1.5},
    {.name = "H6_antenna5_tags4",
     .offByOne = 0.4,
     .missed = 0.2,
     .stepError = 0.1,
     .jitter_deg = 1.0,
     .antenna_mm = 5.0,
     .tag_mm = 4.0},
    {.name = "H7_stale10_q06",
     .offByOne = 0.6,
     .missed = 0.2,
     .stepError = 0.1,
     .jitter_deg = 1.0,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.10},
    {.name = "H8_table_absurd",
     .offByOne = 0.6,
     .missed = 0.3,
     .stepError = 0.1,
     .jitter_deg = 1.0,
     .antenna_mm = 1.0,
     .tag_mm = 1.0,
     .tableScale = 0.12,
     .edge_mm = 8.0},
    {.name = "H9_table_scale_only",
     .offByOne = 0.2,
     .missed = 0.1,
     .stepError = 0.1,
     .jitter_deg = 0.5,
     .tableScale = 0.08,
     .edge_mm = 0.01},
    {.name = "K1_all_9_stops",
     .offByOne = 0.4,
     .missed = 0.2,
     .stepError = 0.2,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02,
     .stops = 9},
    {.name = "K2_all_13_stops",
     .offByOne = 0.4,
     .missed = 0.2,
     .stepError = 0.2,
     .jitter_deg = 1.22,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02,
     .stops = 13,
     .nominalStep_deg = 30.0},
    {.name = "K3_all_17_stops",
     .offByOne = 0.4,
     .missed = 0.2,
     .stepError = 0.2,
     .jitter_deg = 1.06,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02,
     .stops = 17,
     .nominalStep_deg = 22.5},
    {.name = "K4_all_clockwise",
     .offByOne = 0.4,
     .missed = 0.2,
     .stepError = 0.2,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02,
     .direction = -1},
    {.name = "K5_3x3_all_clockwise",
     .tagsPerSide = 3,
     .offByOne = 0.4,
     .missed = 0.2,
     .stepError = 0.2,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02,
     .direction = -1},
    {.name = "K6_3x3_miss50",
     .tagsPerSide = 3,
     .offByOne = 0.4,
     .missed = 0.5,
     .stepError = 0.2,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02},
    {.name = "K7_4_stops_clean", .stepError = 0.1, .jitter_deg = 0.5, .stops = 4},
}};

struct Summary {
    ErrorSample position_mm, heading_deg, step_deg, sd_mm, time_ms;
    int answered = 0, hits = 0, headingHits = 0, flaggedGood = 0, bad = 0, flaggedBad = 0, wrongDirection = 0;
};

double cpuMs() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void add(const SimulatedTurn& turn, const TurnEstimate& e, Summary& s, bool printWorst, int index)
{
    if (!e.valid) {
        std::printf("  turn %d: no answer (%s)\n", index, e.status.c_str());
        return;
    }
    ++s.answered;
    const PoseError error = errorOf(e.startPose, turn.truth.startPose);
    const double p = mmFromMetres(error.position_m);
    const double h = std::abs(degFromRad(error.heading));
    s.position_mm.add(p);
    s.heading_deg.add(h);
    s.step_deg.add(degFromRad(e.step - std::abs(turn.truth.step)));
    s.sd_mm.add(mmFromMetres(std::sqrt(e.covariance[0] + e.covariance[4])));
    s.hits += normalisedPositionError2(e.startPose, e.covariance, turn.truth.startPose) < kChiSquared2At95;
    s.headingHits += h < 1.96 * degFromRad(std::sqrt(e.covariance[8]));
    s.wrongDirection += signOf(e.rotation) * turn.truth.step < 0.0;
    const bool bad = p > 20.0 || h > 15.0;
    s.bad += bad;
    (bad ? s.flaggedBad : s.flaggedGood) += !e.flags.empty();
    if (printWorst && (bad || !e.flags.empty() || p > 10.0)) {
        std::printf("  turn %d: %.1f mm %.1f deg, sd %.1f mm %.1f deg, scale %s, flags", index, p, h,
                    mmFromMetres(std::sqrt(e.covariance[0] + e.covariance[4])),
                    degFromRad(std::sqrt(e.covariance[8])), e.profile.c_str());
        for (const TurnFlag flag : e.flags)
            std::printf(" %s", toText(flag));
        std::printf("\n");
    }
}

std::vector<SimulatedTurn> turnsOf(const TurnScenario& scenario, const Settings& settings)
{
    if (!settings.fresh)
        return loadTurns(std::string(AGV_TEST_DATA) + "/vectors/rfid_" + scenario.name + ".jsonl");
    std::vector<SimulatedTurn> turns;
    for (int i = 0; i < settings.turns; ++i) {
        SplitMix64 random(settings.seed * 0x100000001B3u + static_cast<std::uint64_t>(i));
        turns.push_back(simulateTurn(scenario, random));
    }
    return turns;
}

void run(const TurnScenario& scenario, const Settings& settings)
{
    const TurnContext context = contextOf(scenario);
    Summary s;
    int index = 0;
    for (const SimulatedTurn& turn : turnsOf(scenario, settings)) {
        if (index >= settings.turns)
            break;
        SolveOptions options;
        options.method = settings.method;
        const double begin = cpuMs();
        const TurnEstimate estimate = solveTurn(turn.record, context, options);
        s.time_ms.add(cpuMs() - begin);
        add(turn, estimate, s, settings.worst, index++);
    }
    std::printf(
        "%-28s %4d %5.2f %6.2f %6.1f %6.2f %6.2f %6.3f %6.3f %6.3f %7.2f %4d %3d/%-3d %4d %6.1f %6.1f\n",
        scenario.name, s.answered, s.position_mm.mean(), s.position_mm.quantile(0.95), s.position_mm.max(),
        s.heading_deg.mean(), s.heading_deg.quantile(0.95), s.step_deg.rms(),
        static_cast<double>(s.hits) / s.answered, static_cast<double>(s.headingHits) / s.answered,
        s.sd_mm.mean() / s.position_mm.rms(), s.flaggedGood, s.flaggedBad, s.bad, s.wrongDirection,
        s.time_ms.quantile(0.5), s.time_ms.quantile(0.95));
    std::fflush(stdout);
}

Settings parse(int argc, char** argv)
{
    Settings s;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto value = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
        if (argument == "--method")
            s.method = value() == "fast" ? SolveMethod::Fast : SolveMethod::Auto;
        else if (argument == "--fresh") {
            s.fresh = true;
            s.seed = std::stoull(value());
        } else if (argument == "--turns")
            s.turns = std::stoi(value());
        else if (argument == "--scenario")
            s.scenario = value();
        else if (argument == "--hard") {
            s.hard = true;
            s.fresh = true;
        } else if (argument == "--worst")
            s.worst = true;
    }
    return s;
}

} // namespace

int main(int argc, char** argv)
{
    const Settings settings = parse(argc, argv);
    std::printf("%-28s %4s %5s %6s %6s %6s %6s %6s %6s %6s %7s %4s %7s %4s %6s %6s\n", "scenario", "n", "pos",
                "p95", "max mm", "head", "p95deg", "step", "hitpos", "hithd", "sd/rms", "good", "flag/bad",
                "dir", "med ms", "p95 ms");
    const auto scenarios = settings.hard ? std::span<const TurnScenario>(kHardScenarios) : studyScenarios();
    for (const TurnScenario& scenario : scenarios)
        if (std::string(scenario.name).starts_with(settings.scenario))
            run(scenario, settings);
    return 0;
}
