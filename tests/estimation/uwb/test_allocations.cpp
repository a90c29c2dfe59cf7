// SPDX-License-Identifier: GPL-3.0-or-later
// In steady state no report allocates: fixes, trackers and fusion work in memory of their own.
#include "bench/uwb_report_chain.h"
#include "estimation/fusion/vehicle_fusion.h"
#include "estimation/uwb/range_ekf.h"
#include "estimation/uwb/range_particle_filter.h"
#include "estimation/uwb/robust_fix.h"
#include "estimation/uwb/uwb_vectors.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};

} // namespace

// Not inlined: where only one of a pair is, GCC takes the other for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    ++allocations;
    if (void* memory = std::malloc(size == 0 ? 1 : size))
        return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace agv::estimation {
namespace {

template<typename Work>
long allocationsOf(Work work)
{
    const long before = allocations;
    for (int k = 0; k < 100; ++k)
        work();
    return allocations - before;
}

TEST(Allocations, AreNotMadeByReports)
{
    const auto ranges = rangesFrom(thesisAnchors(), exactRanges(thesisAnchors(), {1.5, 1.0, 0.3}), 0.05);
    EXPECT_EQ(allocationsOf([&] { fixFromRanges(ranges, {.side = TagSide::Either}); }), 0);
    EXPECT_EQ(allocationsOf([&] { robustFix(ranges, {.height = TagHeight{0.3}}); }), 0);
    RangeEkf ekf({.height_m = 0.3, .obstruction = {}});
    ASSERT_TRUE(ekf.start(ranges));
    EXPECT_EQ(allocationsOf([&] {
                  ekf.predict(0.1);
                  ekf.update(ranges);
              }),
              0);
    RangeParticleFilter particles({.particles = 100, .height_m = 0.3});
    ASSERT_TRUE(particles.start(ranges));
    EXPECT_EQ(allocationsOf([&] {
                  particles.predict(0.1);
                  particles.update(ranges);
              }),
              0);
    VehicleFusion fusion;
    fusion.start(Pose2{{1.5, 1.0}, 0.0});
    EXPECT_EQ(allocationsOf([&] {
                  fusion.predict({0.01, 0.0, 0.01}, 0.1);
                  fusion.update(ranges);
                  fusion.updateFloorTag({1.5, 1.0});
              }),
              0);
}

TEST(Allocations, AreNotMadeFromTheBytesOfAUnitToThePositionsOfItsTags)
{
    constexpr int tags = 3;
    constexpr int rounds = 50;
    const std::string bytes = chain::reportBytes(tags, rounds);
    const std::size_t length = bytes.size() / (tags * rounds);
    for (const std::size_t read : {std::size_t{1}, length - 1, length, std::size_t{1000}}) {
        chain::Tracks tracks(tags);
        Time now{};
        std::size_t positions = 0;
        const auto feedAll = [&] {
            for (std::size_t at = 0; at < bytes.size(); at += read)
                positions += tracks.feed(std::string_view(bytes).substr(at, read),
                                         now += std::chrono::microseconds(400 * read));
        };
        feedAll();
        EXPECT_EQ(allocationsOf(feedAll), 0) << "in reads of " << read;
        EXPECT_EQ(positions, 101U * tags * rounds) << "in reads of " << read;
    }
}

} // namespace
} // namespace agv::estimation
