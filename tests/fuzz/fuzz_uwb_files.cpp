// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a file of UWB ranges in any format. Every range is finite and positive; problems name lines of the
// file; a table reads back the same after writing; a capture loses no byte.
#include "fuzz/fuzz_support.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"
#include "recording/range_file.h"
#include "recording/text_lines.h"

#include <chrono>
#include <cmath>

using namespace agv;
using namespace agv::fuzz;
using namespace agv::recording;

namespace {

std::vector<RangeMeasurement> decodeTrek(const SerialCapture& capture)
{
    std::vector<RangeMeasurement> ranges;
    protocol::TrekRanges reader(protocol::TrekRanges::TimeBase::DeviceClock);
    protocol::TrekStream stream;
    for (const SerialChunk& chunk : capture.chunks)
        stream.feed(chunk.bytes, Time{} + chunk.since, [&](const protocol::TrekReport& report) {
            const auto set = reader.read(report);
            ranges.insert(ranges.end(), set.begin(), set.end());
        });
    return ranges;
}

void checkTable(const RangeTable& table, int lines)
{
    require(table.extras.size() == table.ranges.size() * table.extraColumns.size(),
            "every range has its extra columns");
    for (const RangeMeasurement& range : table.ranges) {
        require(std::isfinite(range.time_s) && std::isfinite(range.range_m) && range.range_m > 0.0,
                "a range is finite and positive");
        require(range.tag >= 0 && range.anchor >= 0 && range.sequence >= -1, "ids are not negative");
        require(std::isfinite(range.reportPeriod_s) && range.reportPeriod_s >= 0.0,
                "a period is not negative");
    }
    require(table.problems.kept().size() <= table.problems.count(), "problems are counted");
    for (const FileProblem& problem : table.problems.kept())
        require(problem.line >= 1 && problem.line <= lines && !problem.reason.empty(),
                "a problem names a line and has a reason");
}

/// Without the extra columns, whose text may get an apostrophe against being taken for a formula.
void checkWriting(const RangeTable& table)
{
    RangeTable plain;
    plain.ranges = table.ranges;
    const auto again = readRangeCsv(writeRangeCsv(plain));
    require(again && again->ranges == plain.ranges && again->problems.empty(), "a table reads back the same");
}

void checkCapture(std::string_view text)
{
    const SerialCapture capture = readSerialCapture(text);
    std::string written;
    SerialCaptureWriter writer([&written](std::string_view line) { written += line; }, Time{});
    for (std::size_t i = 0; i < capture.chunks.size(); ++i)
        writer.bytes(capture.chunks[i].bytes, Time{} + std::chrono::milliseconds(i));
    const SerialCapture again = readSerialCapture(written);
    require(again.problems.empty() && again.chunks.size() == capture.chunks.size(), "a capture is readable");
    for (std::size_t i = 0; i < capture.chunks.size(); ++i)
        require(again.chunks[i].bytes == capture.chunks[i].bytes, "a capture loses no byte");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text = textOf({data, size});
    checkCapture(text);
    const auto file = parseRanges(text, decodeTrek);
    if (!file) {
        require(!file.error().detail.empty(), "an error says what is wrong");
        return 0;
    }
    require(!file->table.ranges.empty(), "a file of ranges has one");
    checkTable(file->table, static_cast<int>(linesOf(text).size()));
    checkWriting(file->table);
    for (const LoggedFix& fix : file->fixes)
        require(std::isfinite(fix.time_s + fix.position_m[0] + fix.position_m[1] + fix.position_m[2]),
                "a position is finite");
    return 0;
}
