// SPDX-License-Identifier: GPL-3.0-or-later
// CPU time from the bytes of a UWB unit to positions. Goals: 1,000,000 reports of four ranges a second on one
// core (1 microsecond a report), 1,000 tags at 10 Hz in a tenth of a core (0.1 s a second).
#include "bench/uwb_report_chain.h"
#include "estimation/uwb/range_fix.h"

#include <benchmark/benchmark.h>

namespace {

using namespace agv;

constexpr int kTags = 4;
constexpr int kRounds = 256;
/// What one read of a USB port or socket brings at most.
constexpr std::size_t kRead = 4096;

/// Feeds the same recording again and again, in reads, and counts the reports.
template<typename Feed>
void run(benchmark::State& state, Feed feed)
{
    const std::string bytes = chain::reportBytes(kTags, kRounds);
    Time now{};
    std::size_t at = 0;
    for (auto _ : state) {
        feed(std::string_view(bytes).substr(at, kRead), now);
        now += std::chrono::milliseconds(25);
        at = at + kRead < bytes.size() ? at + kRead : 0;
    }
}

void countReports(benchmark::State& state, std::size_t reports)
{
    state.SetItemsProcessed(static_cast<std::int64_t>(reports));
}

void bytesToReports(benchmark::State& state)
{
    protocol::TrekStream stream;
    std::size_t reports = 0;
    run(state, [&](std::string_view bytes, Time now) {
        stream.feed(bytes, now, [&](const protocol::TrekReport& report) {
            benchmark::DoNotOptimize(&report);
            ++reports;
        });
    });
    countReports(state, reports);
}

void bytesToRanges(benchmark::State& state)
{
    protocol::TrekStream stream;
    protocol::TrekRanges ranges;
    std::size_t reports = 0;
    run(state, [&](std::string_view bytes, Time now) {
        stream.feed(bytes, now, [&](const protocol::TrekReport& report) {
            benchmark::DoNotOptimize(ranges.read(report));
            ++reports;
        });
    });
    countReports(state, reports);
}

template<typename Fix>
void bytesToFix(benchmark::State& state, Fix fix)
{
    protocol::TrekStream stream;
    protocol::TrekRanges ranges;
    estimation::AnchorRangeList placed;
    std::size_t fixes = 0;
    run(state, [&](std::string_view bytes, Time now) {
        stream.feed(bytes, now, [&](const protocol::TrekReport& report) {
            chain::place(ranges.read(report), placed);
            const estimation::UwbFix found = fix(estimation::AnchorRanges{placed.data(), placed.size()});
            benchmark::DoNotOptimize(&found);
            fixes += found.ok() ? 1 : 0;
        });
    });
    countReports(state, fixes);
}

void bytesToFixAtKnownHeight(benchmark::State& state)
{
    bytesToFix(state, [](estimation::AnchorRanges ranges) {
        return estimation::fixFromRanges(ranges, {.height = estimation::TagHeight{chain::height_m, 0.0}});
    });
}

void bytesToFixInSpace(benchmark::State& state)
{
    bytesToFix(state, [](estimation::AnchorRanges ranges) { return estimation::fixFromRanges(ranges); });
}

void bytesToTracks(benchmark::State& state)
{
    chain::Tracks tracks(kTags);
    std::size_t positions = 0;
    run(state, [&](std::string_view bytes, Time now) { positions += tracks.feed(bytes, now); });
    countReports(state, positions);
}

/// One second of 1,000 tags: four units with 250 each. The time of an iteration is the share of a core.
void secondOfAThousandTags(benchmark::State& state)
{
    constexpr int units = 4;
    constexpr int tags = 250;
    constexpr int reportsPerSecond = 10;
    std::vector<chain::Tracks> tracks(units, chain::Tracks(tags));
    std::vector<std::string> bytes;
    for (int unit = 0; unit < units; ++unit)
        bytes.push_back(chain::reportBytes(tags, 1, static_cast<std::uint64_t>(unit)));
    Time now{};
    std::size_t positions = 0;
    for (auto _ : state) {
        for (int report = 0; report < reportsPerSecond; ++report) {
            now += std::chrono::milliseconds(100);
            for (std::size_t unit = 0; unit < units; ++unit)
                positions += tracks[unit].feed(bytes[unit], now);
        }
    }
    countReports(state, positions);
}

BENCHMARK(bytesToReports);
BENCHMARK(bytesToRanges);
BENCHMARK(bytesToFixAtKnownHeight);
BENCHMARK(bytesToFixInSpace);
BENCHMARK(bytesToTracks);
BENCHMARK(secondOfAThousandTags)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
