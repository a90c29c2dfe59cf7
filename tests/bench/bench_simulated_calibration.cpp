// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrates every AGV of the example plant in a row, seed after seed, in virtual time over the simulated
// plant, and prints the errors of pose and sleeptime.
//   bench_simulated_calibration [--seeds N] [--first SEED] [--battery PERCENT] [--miss PERCENT]
//       [--table PERCENT] [--measured] [--stops 8|12|16] [--fast] [--small-field] [--no-slip] [--worst]
#include "core/plant_file.h"
#include "estimation/error_metrics.h"
#include "estimation/turn_solver.h"
#include "simulation/virtual_turn.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace agv;
using namespace agv::estimation;
using namespace agv::simulation;

struct Options {
    std::uint64_t seeds = 100;
    std::uint64_t first = 1;
    std::optional<double> battery;
    std::optional<double> miss;
    std::optional<double> table;
    TurnKind kind = TurnKind::Timed;
    int stops = 8;
    SolveMethod method = SolveMethod::Auto;
    std::string plant = "plant.json";
    bool worst = false;
    bool slip = true;
};

struct Row {
    ErrorSample position_mm, heading_deg, step_deg, sleeptime_ms, duration_s, solver_ms;
    int turns = 0, answered = 0, inside = 0, bad = 0, badUnflagged = 0, flagged = 0, wrongWay = 0;
};

void addTo(Row& row, const VirtualTurn& turn, const TurnEstimate& estimate)
{
    ++row.turns;
    row.duration_s.add(turn.duration_s);
    if (turn.end != TurnPhase::Finished || !estimate.valid)
        return;
    ++row.answered;
    const PoseError error = errorOf(estimate.pose, turn.last.pose);
    const double position_mm = mmFromMetres(error.position_m);
    const double heading_deg = degFromRad(error.heading);
    row.position_mm.add(position_mm);
    row.heading_deg.add(heading_deg);
    row.step_deg.add(degFromRad(estimate.step - turn.meanStep));
    row.solver_ms.add(1e3 * estimate.elapsed_s);
    row.wrongWay += estimate.rotation != Rotation::CounterClockwise;
    row.inside +=
        normalisedPositionError2(estimate.pose, estimate.covariance, turn.last.pose) < kChiSquared2At95;
    row.flagged += !estimate.flags.empty();
    const bool bad = position_mm > 20.0 || std::abs(heading_deg) > 15.0;
    row.bad += bad;
    row.badUnflagged += bad && estimate.flags.empty();
    if (estimate.suggestedTurnTime_s)
        row.sleeptime_ms.add(1e3 * (*estimate.suggestedTurnTime_s -
                                    *turn.record.turnTime_s * turn.record.nominalStep / turn.meanStep));
}

void print(const char* name, const Row& row)
{
    std::printf("| %-5s | %d/%d | %.1f / %.1f / %.1f | %.2f / %.2f / %.2f | %.2f | %.0f | %.0f %% | %d (%d) "
                "| %d | %d | "
                "%.1f / %.1f | %.0f |\n",
                name, row.answered, row.turns, row.position_mm.mean(), row.position_mm.quantile(0.95),
                row.position_mm.max(), row.heading_deg.mean(), row.heading_deg.quantile(0.95),
                row.heading_deg.max(), row.step_deg.mean(), row.sleeptime_ms.mean(),
                row.answered ? 100.0 * row.inside / row.answered : 0.0, row.bad, row.badUnflagged,
                row.flagged, row.wrongWay, row.duration_s.mean(), row.duration_s.max(),
                row.solver_ms.quantile(0.5));
}

Options optionsFrom(int count, char** arguments)
{
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string name = arguments[i];
        const auto number = [&] { return i + 1 < count ? std::strtod(arguments[++i], nullptr) : 0.0; };
        if (name == "--seeds")
            options.seeds = static_cast<std::uint64_t>(number());
        else if (name == "--first")
            options.first = static_cast<std::uint64_t>(number());
        else if (name == "--battery")
            options.battery = number() / 100.0;
        else if (name == "--miss")
            options.miss = number() / 100.0;
        else if (name == "--table")
            options.table = number() / 100.0;
        else if (name == "--stops")
            options.stops = static_cast<int>(number());
        else if (name == "--measured")
            options.kind = TurnKind::Measured;
        else if (name == "--fast")
            options.method = SolveMethod::Fast;
        else if (name == "--small-field")
            options.plant = "small-field.json";
        else if (name == "--worst")
            options.worst = true;
        else if (name == "--no-slip")
            options.slip = false;
    }
    return options;
}

} // namespace

int main(int count, char** arguments)
{
    const Options options = optionsFrom(count, arguments);
    const auto layout = readPlantFile(std::string(AGV_RESOURCES) + "/" + options.plant);
    if (!layout) {
        std::fprintf(stderr, "%s\n", layout.error().detail.c_str());
        return 1;
    }
    std::printf(
        "| AGV | answered | position mean / p95 / max, mm | heading mean / p95 / max, deg | step, deg | "
        "sleeptime, ms | inside 95 %% | bad (unflagged) | flagged | wrong way | turn mean / longest, s | "
        "solver, ms "
        "|\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    std::vector<Row> rows(layout->agvs.size());
    Row all;
    for (std::uint64_t seed = options.first; seed < options.first + options.seeds; ++seed) {
        PlantSettings settings;
        settings.seed = seed;
        settings.charge = options.battery;
        if (!options.slip)
            settings.drive.slipNoise_sqrtM = settings.drive.imbalanceSd = 0.0;
        auto plant = Plant::create(*layout, settings);
        if (!plant) {
            std::fprintf(stderr, "seed %llu: %s\n", static_cast<unsigned long long>(seed),
                         plant.error().detail.c_str());
            return 1;
        }
        if (options.miss)
            plant->setMissRate(*options.miss);
        if (options.table)
            plant->setTableError(*options.table);
        for (std::size_t i = 0; i < layout->agvs.size(); ++i) {
            const AgvConfig& agv = layout->agvs[i];
            TurnParameters parameters;
            parameters.kind = options.kind;
            parameters.stopsPerTurn = options.stops;
            parameters.turnTime_s = agv.turnTime_s;
            const VirtualTurn turn = driveTurn(*plant, agv.id, parameters);
            const TurnEstimate estimate = solveTurn(turn.record, contextFor(*layout, agv),
                                                    {.method = options.method, .seed = seed, .stop = {}});
            addTo(rows[i], turn, estimate);
            addTo(all, turn, estimate);
            const double error_mm = mmFromMetres(distance(estimate.pose.position, turn.last.pose.position));
            if (options.worst && (!estimate.valid || turn.end != TurnPhase::Finished || error_mm > 20.0))
                std::printf("  seed %llu, AGV %d: %s, %s, %.1f mm\n", static_cast<unsigned long long>(seed),
                            agv.id.number, turn.message.c_str(), estimate.status.c_str(), error_mm);
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        print(std::to_string(layout->agvs[i].id.number).c_str(), rows[i]);
    print("all", all);
    return 0;
}
