// SPDX-License-Identifier: GPL-3.0-or-later
// CPU time of the decoders: ns per reader line, robot frame and UWB report, median of several runs, fed as
// whole chunks and byte by byte, as the WeMos bridge sends at times.
#include "protocol/reader_stream.h"
#include "protocol/robot_frame.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace agv;
using namespace agv::protocol;

constexpr int runs = 15;
constexpr std::size_t itemsPerRun = 20'000;
/// A TCP segment's worth.
constexpr std::size_t chunkBytes = 1400;

struct Spread {
    double best_ns = 0.0;
    double median_ns = 0.0;
    double worst_ns = 0.0;
};

/// `work` handles itemsPerRun items. CPU time, because the machine may be busy with something else.
template<typename Work>
Spread measure(Work work)
{
    work();
    std::array<double, runs> ns{};
    for (double& run : ns) {
        const std::clock_t start = std::clock();
        work();
        run = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC /
              static_cast<double>(itemsPerRun);
    }
    std::ranges::sort(ns);
    return {ns.front(), ns[ns.size() / 2], ns.back()};
}

void print(const char* name, const Spread& spread, std::uint64_t decoded)
{
    std::printf("%-44s %8.1f %8.1f %8.1f   %llu decoded\n", name, spread.best_ns, spread.median_ns,
                spread.worst_ns, static_cast<unsigned long long>(decoded));
}

std::string readerText()
{
    std::string text;
    for (std::size_t i = 0; i < itemsPerRun; ++i)
        text += encodeReaderLine(CompleteRead{TagUid{0xE00401503A5BD000U + i % 0x1000U},
                                              static_cast<int>(i % 8), static_cast<int>(i % 8)}) +
                "\r";
    return text;
}

Bytes robotBytes(const RobotReport& report)
{
    Bytes bytes;
    const auto frame = encodeReportFrame(report);
    for (std::size_t i = 0; frame && i < itemsPerRun; ++i)
        bytes.insert(bytes.end(), frame->begin(), frame->end());
    return bytes;
}

/// Feeds a stream in chunks of n bytes; the sink counts, so that nothing can be left out.
template<typename Stream, typename Report, typename Bytes>
void benchStream(const char* name, const Bytes& bytes, std::size_t chunk)
{
    std::uint64_t decoded = 0;
    const Spread spread = measure([&] {
        Stream stream;
        decoded = 0;
        for (std::size_t i = 0; i < bytes.size(); i += chunk) {
            const std::size_t n = std::min(chunk, bytes.size() - i);
            stream.feed({bytes.data() + i, n}, [&decoded](const Report&) { ++decoded; });
        }
    });
    print(name, spread, decoded);
}

void benchSingleLines()
{
    const std::string line = "SCAN:+UID=E00401503A5BDAE4,+RSSI=7/6";
    std::uint64_t decoded = 0;
    const Spread spread = measure([&] {
        decoded = 0;
        for (std::size_t i = 0; i < itemsPerRun; ++i)
            decoded += decodeReaderLine(line).has_value() ? 1 : 0;
    });
    print("reader line, decoder alone", spread, decoded);
}

std::string trekText(std::size_t ranges)
{
    std::string text;
    TrekReport report;
    report.mask = static_cast<std::uint8_t>((1U << ranges) - 1U);
    report.rangeCount = static_cast<std::uint8_t>(ranges);
    for (std::size_t i = 0; i < itemsPerRun; ++i) {
        for (std::size_t k = 0; k < ranges; ++k)
            report.range_mm[k] = static_cast<std::int32_t>(1000 + 37 * k + i % 5000);
        report.tag = static_cast<std::int16_t>(i % 8);
        report.sequence = static_cast<std::int16_t>(i / 8 % 256);
        report.debug = static_cast<std::uint32_t>(i * 12);
        text += encodeTrekReport(report) + "\r\n";
    }
    return text;
}

/// Bytes to RangeMeasurements; the sum of the ranges is used, so that nothing can be left out.
void benchRanges(const char* name, const std::string& text, std::size_t chunk)
{
    std::uint64_t decoded = 0;
    double sum = 0.0;
    const Spread spread = measure([&] {
        TrekStream stream;
        TrekRanges ranges;
        decoded = 0;
        Time now{};
        for (std::size_t i = 0; i < text.size(); i += chunk) {
            now += std::chrono::milliseconds(12);
            stream.feed(std::string_view(text).substr(i, chunk), now, [&](const TrekReport& report) {
                for (const RangeMeasurement& range : ranges.read(report))
                    sum += range.range_m;
                ++decoded;
            });
        }
    });
    print(name, spread, sum > 0.0 ? decoded : 0);
}

} // namespace

int main()
{
    std::printf("%-44s %8s %8s %8s   ns of CPU each, %d runs\n", "", "best", "median", "worst", runs);
    benchSingleLines();
    const std::string text = readerText();
    benchStream<ReaderStream, ReaderReport>("reader line, stream in 1400-byte chunks", text, chunkBytes);
    benchStream<ReaderStream, ReaderReport>("reader line, stream byte by byte", text, 1);
    const Bytes sensors = robotBytes(SensorUpdate{});
    benchStream<ReportStream, RobotReport>("robot sensorUpdate, 1400-byte chunks", sensors, chunkBytes);
    benchStream<ReportStream, RobotReport>("robot sensorUpdate, byte by byte", sensors, 1);
    const Bytes segments = robotBytes(SegmentUpdate{1, 2, 0.1, 0.2});
    benchStream<ReportStream, RobotReport>("robot segmentUpdate, 1400-byte chunks", segments, chunkBytes);
    const std::string four = trekText(4);
    benchRanges("UWB report to ranges, whole lines", four, 65);
    benchRanges("UWB report to ranges, 64-byte transfers", four, 64);
    benchRanges("UWB report to ranges, 16-byte bursts", four, 16);
    benchRanges("UWB report to ranges, 1400-byte chunks", four, chunkBytes);
    benchRanges("UWB report to ranges, byte by byte", four, 1);
    benchRanges("UWB report of 8 ranges, 1400-byte chunks", trekText(8), chunkBytes);
    return 0;
}
