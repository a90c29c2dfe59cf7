// SPDX-License-Identifier: GPL-3.0-or-later
// CPU time of UWB fixes, trackers and fusion. Goals: a fix in space of four ranges with covariance 0.5
// microseconds, one fusion step 5 microseconds, 1,000 tags at 10 Hz a tenth of a core (10 microseconds a
// report).
#include "core/random.h"
#include "estimation/fusion/floor_filter.h"
#include "estimation/fusion/vehicle_fusion.h"
#include "estimation/uwb/linear_toa.h"
#include "estimation/uwb/range_ekf.h"
#include "estimation/uwb/range_particle_filter.h"
#include "estimation/uwb/robust_fix.h"
#include "estimation/uwb/static_position.h"
#include "estimation/uwb/two_step_toa.h"

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

namespace {

using namespace agv;
using namespace agv::estimation;

constexpr std::size_t kReports = 1024; ///< different ones, so that branches are not learnt by heart

/// Reports from tags all over the room of the thesis, 5 cm noise.
std::vector<std::array<AnchorRange, 4>> reports()
{
    const std::array<Eigen::Vector3d, 4> anchors{Eigen::Vector3d(0, 0, 2), {4, 0, 2}, {4, 2, 2}, {0, 2, 2.5}};
    SplitMix64 random(1);
    std::vector<std::array<AnchorRange, 4>> result(kReports);
    for (auto& report : result) {
        const Eigen::Vector3d tag(random.uniform(0.3, 3.7), random.uniform(0.2, 1.8),
                                  random.uniform(0.2, 1.2));
        for (std::size_t i = 0; i < 4; ++i)
            report[i] = {anchors[i], (tag - anchors[i]).norm() + 0.05 * random.normal(), 0.05,
                         static_cast<int>(i)};
    }
    return result;
}

template<typename Work>
void run(benchmark::State& state, Work work)
{
    const auto all = reports();
    std::size_t k = 0;
    for (auto _ : state)
        work(AnchorRanges(all[k++ % kReports]));
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}

template<typename Solve>
void runFix(benchmark::State& state, Solve solve)
{
    run(state, [&](AnchorRanges ranges) { benchmark::DoNotOptimize(solve(ranges)); });
}

void fixInSpace(benchmark::State& state)
{
    runFix(state, [](AnchorRanges r) { return fixFromRanges(r); });
}
void fixInSpaceBothSides(benchmark::State& state)
{
    runFix(state, [](AnchorRanges r) { return fixFromRanges(r, {.side = TagSide::Either}); });
}
void fixAtKnownHeight(benchmark::State& state)
{
    runFix(state, [](AnchorRanges r) { return fixFromRanges(r, {.height = TagHeight{0.7, 0.0}}); });
}
void linearInSpace(benchmark::State& state)
{
    runFix(state, [](AnchorRanges r) { return linearToa3d(r); });
}
void twoStepInSpace(benchmark::State& state)
{
    runFix(state, [](AnchorRanges r) { return twoStepToa(r); });
}
void robustFixOfFour(benchmark::State& state)
{
    runFix(state,
           [](AnchorRanges r) { return robustFix(r, {.height = TagHeight{0.7, 0.0}, .obstruction = {}}); });
}

void trackerReport(benchmark::State& state)
{
    RangeEkf filter({.height_m = 0.7, .obstruction = {}});
    filter.start({2.0, 1.0, 0.0, 0.0}, RangeEkf::Covariance::Identity());
    run(state, [&](AnchorRanges ranges) {
        filter.predict(0.1);
        benchmark::DoNotOptimize(&filter.update(ranges));
    });
}

/// Odometry, four ranges, a floor tag.
void fusionStep(benchmark::State& state)
{
    VehicleFusionSettings settings;
    settings.model.height_m = 0.7;
    VehicleFusion filter(settings);
    filter.start(Pose2{{2.0, 1.0}, 0.0});
    run(state, [&](AnchorRanges ranges) {
        filter.predict({0.001, 0.0, 0.001}, 0.1);
        filter.update(ranges);
        benchmark::DoNotOptimize(filter.updateFloorTag({2.0, 1.0}));
    });
}

void particleReport(benchmark::State& state)
{
    RangeParticleFilter filter({.height_m = 0.7});
    filter.start({2.0, 1.0});
    run(state, [&](AnchorRanges ranges) {
        filter.predict(0.1);
        benchmark::DoNotOptimize(&filter.update(ranges));
    });
}

void standingTagReport(benchmark::State& state)
{
    StaticPosition position({.height_m = 0.7, .obstruction = {}});
    run(state, [&](AnchorRanges ranges) {
        position.add(ranges);
        benchmark::DoNotOptimize(position.fix());
    });
}

void floorFilterStep(benchmark::State& state)
{
    PlantLayout plant;
    plant.floorTags = tagGrid(31, 41, 0.1, {}, TagUid{1});
    FloorFilter filter(tagMapOf(plant), seedRssiTable());
    filter.start({{1.0, 1.0}, 0.0}, {9e-6, 0, 0, 0, 9e-6, 0, 0, 0, 1e-3});
    // Tag at (0.9, 1.0), straight below the antenna.
    const std::array reads{FloorRead{TagUid{1 + 9 * 41 + 10}, 7}, FloorRead{TagUid{1 + 9 * 41 + 10}, 7},
                           FloorRead{TagUid{1 + 9 * 41 + 10}, 7}};
    for (auto _ : state) {
        filter.predict(0.0, 0.0, 0.1);
        benchmark::DoNotOptimize(&filter.update(reads));
    }
}

BENCHMARK(fixInSpace);
BENCHMARK(fixInSpaceBothSides);
BENCHMARK(fixAtKnownHeight);
BENCHMARK(linearInSpace);
BENCHMARK(twoStepInSpace);
BENCHMARK(robustFixOfFour);
BENCHMARK(trackerReport);
BENCHMARK(fusionStep);
BENCHMARK(particleReport);
BENCHMARK(standingTagReport);
BENCHMARK(floorFilterStep);

} // namespace

BENCHMARK_MAIN();
