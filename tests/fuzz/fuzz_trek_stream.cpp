// SPDX-License-Identifier: GPL-3.0-or-later
// Input: u16 seed of the split, stream of a UWB unit. Any split gives the same reports, counts and dialect;
// times follow the stream; what was decoded survives encoding; ranges are finite and positive.
#include "fuzz/fuzz_support.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"

#include <cmath>
#include <string>
#include <vector>

using namespace agv::fuzz;
using namespace agv::protocol;
using Reports = std::vector<TrekReport>;

namespace {

Reports reportsInPieces(TrekStream& stream, Input bytes, std::uint16_t seed)
{
    Reports reports;
    agv::Time now{};
    agv::Time latest{};
    feedInPieces(bytes, seed, [&](Input piece) {
        now += std::chrono::milliseconds(1);
        stream.feed(textOf(piece), now, [&](const TrekReport& report) {
            require(report.firstByte >= latest && report.firstByte <= now && report.firstByte > agv::Time{},
                    "times follow the stream");
            latest = report.firstByte;
            reports.push_back(report);
            reports.back().firstByte = agv::Time{};
        });
    });
    return reports;
}

void checkRanges(TrekRanges& ranges, const TrekReport& report)
{
    for (const agv::RangeMeasurement& range : ranges.read(report)) {
        require(std::isfinite(range.time_s), "a time is finite");
        require(std::isfinite(range.range_m) && range.range_m > 0.0, "a range is positive");
        require(range.anchor >= 0 && range.anchor <= 255 && range.tag >= 0 && range.tag <= 255,
                "ids are in their range");
    }
}

void checkEncoding(const TrekReport& report)
{
    TrekReport expected = report;
    // These depend on more than the line.
    expected.usable = 0;
    TrekReport again;
    const std::string line = encodeTrekReport(report);
    const auto length = decodeTrekReport(line, again);
    require(length && *length == line.size(), "an encoded report is readable");
    if (report.kind != TrekLineKind::Imu)
        expected.deviceTime_ms = -1;
    require(again == expected, "decode(encode(x)) is x");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Input bytes(data, size);
    const auto seed = take<std::uint16_t>(bytes);

    TrekStream whole;
    Reports expected;
    TrekRanges ranges;
    whole.feed(textOf(bytes), agv::Time{}, [&](const TrekReport& report) {
        expected.push_back(report);
        checkRanges(ranges, report);
        checkEncoding(report);
    });
    TrekStream split;
    require(reportsInPieces(split, bytes, seed) == expected, "the reports do not depend on the split");
    require(split.counts() == whole.counts(), "the counts do not depend on the split");
    require(split.dialect().dialect() == whole.dialect().dialect(), "nor does the dialect");
    require(whole.counts().reports == expected.size(), "every report is counted");
    const bool nothingDropped = whole.counts().damaged() + whole.counts().skipped() == 0;
    require(dropDetail(whole.counts()).empty() == nothingDropped, "what was dropped has words");
    return 0;
}
