// SPDX-License-Identifier: GPL-3.0-or-later
// What recording a run costs: processor time at 10,000 messages a second, megabytes an hour at the load of a
// plant, rows a second of the CSV export. Batches of half a second, as the session hands them over.
// Usage: bench_recording [FOLDER]; without one a folder of its own under the system's for temporary files.
// Exit status 1 when a limit is missed.
#include "core/random.h"
#include "recording/run_csv.h"
#include "recording/run_writer.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <stdlib.h>
#include <string>

namespace agv::recording {
namespace {

using namespace std::chrono_literals;

constexpr Time begin = Time{} + 100h;

double processorTime_s()
{
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

ClockPair clocksAt(Time time)
{
    return {time, 1'773'761'405'000'000 + Duration(time - begin).count() / 1000};
}

RunWriter newRun(const std::filesystem::path& runs)
{
    RunInfo info;
    info.software = "bench_recording";
    PlantLayout plant;
    plant.name = "bench";
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    auto writer = RunWriter::create(runs, info, plant, clocksAt(begin));
    if (!writer) {
        std::fprintf(stderr, "%s\n", writer.error().detail.c_str());
        std::exit(1);
    }
    return std::move(*writer);
}

void append(RunWriter& writer, RunBatch& batch, Time now)
{
    batch.clocks = clocksAt(now);
    if (const Result<void> result = writer.append(batch); !result) {
        std::fprintf(stderr, "%s\n", result.error().detail.c_str());
        std::exit(1);
    }
    batch = {};
}

/// A line of a UWB unit with four ranges, and its rows.
class UwbSource {
public:
    void report(RunBatch& batch, Time now, int tag, bool withRawLine)
    {
        std::array<int, 4> mm{};
        for (std::size_t k = 0; k < mm.size(); ++k)
            mm[k] = 1000 + 400 * static_cast<int>(k) + static_cast<int>(m_random.next() % 60);
        batch.chunks.push_back({now, "uwb", line("mc", mm, tag, now)});
        if (withRawLine)
            batch.chunks.push_back({now + 200us, "uwb", line("mr", mm, tag, now)});
        const double measured_s = secondsFrom(now.time_since_epoch()) - 0.1;
        for (std::size_t k = 0; k < mm.size(); ++k)
            batch.rows.push_back(RangeRow{now,
                                          {.time_s = measured_s,
                                           .range_m = 1e-3 * mm[k],
                                           .tag = tag,
                                           .anchor = static_cast<int>(k),
                                           .sequence = m_sequence & 0xff},
                                          0.05 * m_random.normal(),
                                          false});
        batch.rows.push_back(TagPositionRow{now,
                                            measured_s,
                                            tag,
                                            {1.5 + 0.01 * m_random.normal(), 2.0 + 0.01 * m_random.normal()},
                                            {4e-4, 1e-5, 4e-4}});
    }

private:
    std::string line(const char* kind, const std::array<int, 4>& mm, int tag, Time now)
    {
        std::array<char, 96> text{};
        const int length = std::snprintf(
            text.data(), text.size(), "%s 0f %08x %08x %08x %08x %04x %02x %08x a%d:0\r\n", kind,
            static_cast<unsigned>(mm[0]), static_cast<unsigned>(mm[1]), static_cast<unsigned>(mm[2]),
            static_cast<unsigned>(mm[3]), static_cast<unsigned>(m_sequence & 0xffff),
            static_cast<unsigned>(m_sequence & 0xff),
            static_cast<unsigned>(now.time_since_epoch() / 1ms) & 0xffffffU, tag);
        ++m_sequence;
        return {text.data(), static_cast<std::size_t>(length)};
    }

    SplitMix64 m_random{1};
    int m_sequence = 0;
};

void readTag(RunBatch& batch, SplitMix64& random, Time now, int agv)
{
    const TagUid uid{0xE00401503A5BD000ULL + random.next() % 9};
    const int rssi = static_cast<int>(random.next() % 8);
    batch.chunks.push_back({now, "reader " + std::to_string(agv),
                            "SCAN:+UID=" + fullText(uid) + ",+RSSI=" + std::to_string(rssi) + "/0\r\n"});
    batch.rows.push_back(TagReadRow{RobotId{agv}, {now, uid, rssi}});
}

bool verdict(const char* what, double value, const char* unit, double limit, bool isMost)
{
    const bool good = isMost ? value <= limit : value >= limit;
    std::printf("%-52s %10.2f %-8s %s %g%s\n", what, value, unit, isMost ? "at most" : "at least", limit,
                good ? "" : "   MISSED");
    return good;
}

/// 10,000 messages a second, half of them tag reads, half UWB reports of four ranges.
bool benchSpeed(const std::filesystem::path& runs)
{
    constexpr int seconds = 20;
    constexpr int perBatch = 5000;
    RunWriter writer = newRun(runs);
    SplitMix64 random(2);
    UwbSource uwb;
    double writing_s = 0.0;
    RunBatch batch;
    Time now = begin;
    for (int k = 0; k < seconds * 2; ++k) {
        for (int i = 0; i < perBatch / 2; ++i) {
            now += 200us;
            readTag(batch, random, now, 1 + i % 4);
            uwb.report(batch, now, i % 8, false);
        }
        const double before_s = processorTime_s();
        append(writer, batch, now);
        writing_s += processorTime_s() - before_s;
    }
    return verdict("10,000 messages/s (30,000 rows/s): processor", 100.0 * writing_s / seconds, "% a core",
                   15.0, true);
}

/// An hour of four AGVs: 33 tag reads a second each, four UWB tags at 10 Hz with both kinds of lines and four
/// anchors, poses at 10 Hz, wheel commands and battery once a second. Nobody stands still.
std::filesystem::path benchHour(const std::filesystem::path& runs, bool& good)
{
    RunWriter writer = newRun(runs);
    SplitMix64 random(3);
    UwbSource uwb;
    RunBatch batch;
    Time now = begin;
    for (int step = 0; step < 3600 * 100; ++step) {
        now += 10ms;
        for (int agv = 1; agv <= 4; ++agv) {
            if (step % 3 == 0)
                readTag(batch, random, now, agv);
            if (step % 10 == agv) {
                uwb.report(batch, now, agv, true);
                const double way = 1e-3 * step;
                batch.rows.push_back(PoseRow{now,
                                             RobotId{agv},
                                             {{1.0 + 0.1 * way, 2.0 - 0.1 * way}, 1e-2 * way},
                                             {1e-6, 1e-7, 2e-7, 1e-7, 4e-6, -1e-7, 2e-7, -1e-7, 1e-5},
                                             PoseHealth::Tracked});
            }
            if (step % 100 == agv) {
                batch.rows.push_back(WheelCommandRow{now, RobotId{agv}, {0.1, -0.1}});
                batch.rows.push_back(BatteryRow{now, RobotId{agv}, {ChargingState::NotCharging, 14.3, -0.7}});
            }
        }
        if (step % 50 == 49)
            append(writer, batch, now);
    }
    append(writer, batch, now);
    static_cast<void>(writer.finish(0));
    good &= verdict("one hour at plant load: size", 1e-6 * static_cast<double>(writer.bytesOnDisk()), "MB",
                    60.0, true);
    return writer.folder();
}

bool benchExport(const std::filesystem::path& run, const std::filesystem::path& out)
{
    auto reader = RunReader::open(run);
    const auto before = std::chrono::steady_clock::now();
    const auto done = reader ? exportCsv(*reader, out) : Result<CsvExport>();
    const double took_s = secondsFrom(std::chrono::steady_clock::now() - before);
    if (!done)
        return false;
    std::printf("export of %llu rows took %.2f s\n", static_cast<unsigned long long>(done->rows), took_s);
    return verdict("CSV export", 1e-3 * static_cast<double>(done->rows) / took_s, "krows/s", 500.0, false);
}

} // namespace
} // namespace agv::recording

int main(int argc, char** argv)
{
    using namespace agv::recording;
    std::string pattern = (std::filesystem::temp_directory_path() / "agv-bench-XXXXXX").string();
    if (argc > 1)
        pattern = std::string(argv[1]) + "/agv-bench-XXXXXX";
    if (!::mkdtemp(pattern.data())) {
        std::perror(pattern.c_str());
        return 1;
    }
    const std::filesystem::path folder = pattern;
    bool good = benchSpeed(folder);
    const std::filesystem::path hour = benchHour(folder, good);
    good &= benchExport(hour, folder / "csv");
    std::filesystem::remove_all(folder);
    return good ? 0 : 1;
}
