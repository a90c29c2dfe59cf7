// SPDX-License-Identifier: GPL-3.0-or-later
// Driving on a floor of tags 0.1 m apart: 3 x 4 m, 100 mm/s, wheels that are 5 % off, tags and antenna
// misplaced.
#include "estimation/error_metrics.h"
#include "estimation/fusion/floor_filter.h"
#include "estimation/uwb/uwb_vectors.h"

#include <gtest/gtest.h>

namespace agv::estimation {
namespace {

TagMap floorOf(int columns, int rows)
{
    PlantLayout plant;
    plant.floorTags = tagGrid(columns, rows, 0.1, {}, TagUid{1});
    return tagMapOf(plant);
}

FloorFilterSettings vehicleOf(const nlohmann::json& run, std::uint64_t seed)
{
    return {.track_m = 2.0 * metresFromMm(run.at("half_track_mm")),
            .antenna = {-metresFromMm(run.at("antenna_back_mm")), 0.0},
            .seed = seed};
}

Pose2 poseOf(const nlohmann::json& p)
{
    return {{metresFromMm(p.at(0)), metresFromMm(p.at(1))}, wrapAngle(radFromDeg(p.at(2)))};
}

/// sd 3 mm and 2.5 degrees: what an initialisation turn leaves.
constexpr PoseCovariance kAfterTurn{9e-6, 0, 0, 0, 9e-6, 0, 0, 0, 1.9e-3};

TEST(FloorFilter, DrivesARouteWithinTheGoals)
{
    for (int number = 0; number < 3; ++number) {
        const auto run = loadVector("plant_run_" + std::to_string(number) + ".json");
        FloorFilter filter(floorOf(31, 41), seedRssiTable(),
                           vehicleOf(run, static_cast<std::uint64_t>(number) + 1));
        filter.start(poseOf(run.at("truth").at(0)), kAfterTurn);
        ErrorSample places;
        ErrorSample headings;
        const double dt = run.at("dt");
        std::vector<FloorRead> reads;
        for (std::size_t k = 0; k < run.at("truth").size(); ++k) {
            const auto& wheels = run.at("wheel_mm_s").at(k);
            filter.predict(metresFromMm(wheels.at(0)), metresFromMm(wheels.at(1)), dt);
            reads.clear();
            for (const auto& r : run.at("reads").at(k))
                reads.push_back({TagUid{r.at(0).get<std::uint64_t>() + 1}, r.at(1).get<int>()});
            filter.update(reads);
            const PoseError error = errorOf(filter.pose(), poseOf(run.at("truth").at(k)));
            places.add(mmFromMetres(error.position_m));
            headings.add(degFromRad(error.heading));
        }
        std::printf("run %d: mean %.2f mm, p95 %.2f mm; heading mean %.2f, p95 %.2f degrees\n", number,
                    places.mean(), places.quantile(0.95), headings.mean(), headings.quantile(0.95));
        EXPECT_LE(places.mean(), 5.5);
        EXPECT_LE(places.quantile(0.95), 12.0);
        EXPECT_LE(headings.mean(), 1.3);
        EXPECT_LE(headings.quantile(0.95), 3.2);
        EXPECT_FALSE(filter.lost());
    }
}

TEST(FloorFilter, SaysThatItIsLostWhenTheTagsContradictIt)
{
    const auto run = loadVector("plant_run_0.json");
    FloorFilter filter(floorOf(31, 41), seedRssiTable(), vehicleOf(run, 1));
    filter.start({{2.5, 3.5}, 0.0}, kAfterTurn);
    std::vector<FloorRead> reads;
    for (std::size_t k = 0; k < 60; ++k) {
        filter.predict(0.1, 0.1, 0.1);
        reads.clear();
        for (const auto& r : run.at("reads").at(k))
            reads.push_back({TagUid{r.at(0).get<std::uint64_t>() + 1}, r.at(1).get<int>()});
        filter.update(reads);
    }
    EXPECT_TRUE(filter.lost());
}

TEST(FloorFilter, IgnoresUnknownTagsAndRubbish)
{
    FloorFilter filter(floorOf(11, 11), seedRssiTable());
    const std::vector<FloorRead> reads{{TagUid{99999}, 3}, {TagUid{5}, 9}};
    EXPECT_TRUE(filter.update(reads).empty());
    filter.start({{0.5, 0.5}, 0.0}, kAfterTurn);
    filter.predict(std::nan(""), 0.1, 0.1);
    filter.predict(0.1, 0.1, -1.0);
    const MeasurementRecords& records = filter.update(reads);
    ASSERT_EQ(records.size(), 2U);
    EXPECT_TRUE(records[0].rejected && !records[0].fused);
    EXPECT_TRUE(records[1].rejected && !records[1].fused);
    EXPECT_NEAR(filter.pose().position.x, 0.5, 0.002);
    EXPECT_FALSE(filter.lost());
}

TEST(FloorFilter, TheSameSeedGivesTheSameTrack)
{
    const auto run = [](std::uint64_t seed) {
        FloorFilter filter(floorOf(11, 11), seedRssiTable(), {.particles = 200, .seed = seed});
        filter.start({{0.5, 0.5}, 0.0}, kAfterTurn);
        const std::vector<FloorRead> reads{{TagUid{50}, 3}, {TagUid{51}, 4}};
        for (int k = 0; k < 10; ++k) {
            filter.predict(0.05, 0.05, 0.1);
            filter.update(reads);
        }
        return filter.pose();
    };
    EXPECT_EQ(run(1), run(1));
    EXPECT_FALSE(run(1) == run(2));
}

} // namespace
} // namespace agv::estimation
