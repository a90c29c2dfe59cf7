// SPDX-License-Identifier: GPL-3.0-or-later
// A program of its own, because it counts every allocation.
#include "protocol/trek_ranges.h"
#include "protocol/trek_samples.h"

#include <gtest/gtest.h>

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
using namespace agv::protocol;

TEST(TrekStream, allocatesNothingOnceItHasSeenAFewLines)
{
    std::string bytes;
    for (const std::string& line : samples::trekReports)
        bytes += line + "\r\n";
    bytes += std::string(300, 'z') + "\r\n" + std::string(1000, '\xff') + samples::trek + "\r\n";
    for (const std::size_t burst : {1U, 16U, 64U, 65U, 1400U}) {
        TrekStream stream;
        TrekRanges ranges;
        std::size_t reports = 0;
        Time now{};
        const auto feedAll = [&] {
            for (std::size_t i = 0; i < bytes.size(); i += burst)
                stream.feed(
                    std::string_view(bytes).substr(i, burst), now += std::chrono::milliseconds(1),
                    [&](const TrekReport& report) { reports += ranges.read(report).empty() ? 0 : 1; });
        };
        feedAll();
        const std::size_t before = allocations;
        for (int i = 0; i < 100; ++i)
            feedAll();
        EXPECT_EQ(allocations, before) << "in bursts of " << burst;
        EXPECT_EQ(reports, 101U * 8U) << "11 a round; not mr, and not the clones' lines, whose mask is 00";
    }
}
