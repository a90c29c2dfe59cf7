// SPDX-License-Identifier: GPL-3.0-or-later
// A program of its own, because it counts every allocation.
#include "session/anchor_pairs.h"
#include "session/anchor_statistics.h"
#include "session/uwb_tag_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>

namespace {

std::size_t allocations = 0;

void* counted(std::size_t size)
{
    ++allocations;
    void* const memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

} // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

using namespace agv;
using namespace agv::session;

TEST(UwbFigures, AReportAllocatesNothingInSteadyState)
{
    const std::vector<UwbAnchor> anchors{{0, "A0", 0.0, 0.0, 2.0, true},
                                         {1, "A1", 3.0, 0.0, 2.0, true},
                                         {2, "A2", 3.0, 4.0, 2.0, true},
                                         {3, "A3", 0.0, 4.0, 2.5, true}};
    UwbTagTrack track({.id = 5, .label = {}, .agv = {}, .z_m = 0.3, .mount = {}}, anchors);
    AnchorStatistics statistics(anchors);
    AnchorPairs pairs;
    RateMeter rate;
    double now_s = 10.0;
    const auto feed = [&](int reports) {
        for (int i = 0; i < reports; ++i) {
            now_s += 0.1;
            const Time now(durationFromSeconds(now_s));
            protocol::RangeSet ranges;
            for (const UwbAnchor& anchor : anchors)
                ranges.add({.time_s = now_s,
                            .range_m = std::hypot(anchor.x - 1.0, anchor.y - 1.5, anchor.z - 0.3),
                            .tag = 5,
                            .anchor = anchor.id});
            rate.add(now);
            track.take(ranges, now_s);
            for (const RangeMeasurement& range : ranges)
                statistics.heard(range.anchor, now, now);
            statistics.add(track.shown());
            protocol::RangeSet between;
            between.add(
                {.time_s = now_s, .range_m = 3.0, .tag = 0, .anchor = 1, .kind = RangeKind::AnchorAnchor});
            pairs.add(between);
        }
    };
    feed(500);
    const std::size_t before = allocations;
    feed(2000);
    EXPECT_EQ(allocations, before);
    EXPECT_GT(before, 0U);
    EXPECT_EQ(statistics.snapshot(Time(durationFromSeconds(now_s)))[3].residual->count, 200);
}
