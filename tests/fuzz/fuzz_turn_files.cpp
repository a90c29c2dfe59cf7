// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a file of turns in any format. Every turn read keeps to the limits of turn_limits.h and is the same
// after writing and reading it again as JSON; every problem names a line of the file; the classic solver ends
// with a status, and with finite numbers where it has a pose.
#include "estimation/classic/classic_solver.h"
#include "fuzz/fuzz_support.h"
#include "protocol/reader_line.h"
#include "recording/json_turns.h"
#include "recording/text_lines.h"
#include "recording/turn_file.h"
#include "recording/turn_limits.h"
#include "recording/turn_results.h"

#include <cmath>

using namespace agv;
using namespace agv::fuzz;
using namespace agv::recording;

namespace {

TurnFileOptions smallPlant()
{
    TurnFileOptions options;
    options.tags = tagGrid(11, 11, 0.1, {0.0, 0.0}, TagUid{0xE004015000000001});
    options.nominalStep = radFromDeg(45.0);
    options.turnTime_s = 1.125;
    options.decodeReaderLine = [](std::string_view line) -> std::optional<ReaderLineRead> {
        const auto report = protocol::decodeReaderLine(line);
        const auto* read = report ? std::get_if<protocol::CompleteRead>(&*report) : nullptr;
        return read ? std::optional(ReaderLineRead{read->uid, read->rssi}) : std::nullopt;
    };
    return options;
}

bool sameTags(const TurnRecord& a, const TurnRecord& b)
{
    return std::ranges::equal(a.stops, b.stops, [](const TurnStop& x, const TurnStop& y) {
        return x.unknownIfUnseen == y.unknownIfUnseen &&
               std::ranges::equal(x.reads, y.reads, [](const TagRead& p, const TagRead& q) {
                   return p.uid == q.uid && p.rssi == q.rssi;
               });
    });
}

void checkRecord(const TurnRecord& record, const TurnFileOptions& options)
{
    require(!record.stops.empty() && record.stops.size() <= mostStops, "1 to 361 stops");
    require(isStep(record.nominalStep), "the step is in its range");
    require(!record.turnTime_s || isTurnTime_s(*record.turnTime_s), "the sleeptime is in its range");
    for (const TurnStop& stop : record.stops) {
        require(stop.reads.size() <= mostReadsPerStop, "the reads of a stop are limited");
        for (const TagRead& read : stop.reads)
            require(read.rssi >= leastRssi && read.rssi <= mostRssi, "RSSI 0 to 7");
    }
    const auto again = parseTurns(toJsonLine(record), options);
    require(again && again->turns.size() == 1 && again->turns[0].record.has_value(),
            "a written turn is readable");
    require(sameTags(*again->turns[0].record, record), "a written turn reads back the same");
}

void checkClassic(const TurnRecord& record, const estimation::TurnContext& context)
{
    const TurnEstimate estimate = estimation::solveClassic(record, context);
    require(!estimate.status.empty() && estimate.valid == (estimate.status == "ok"),
            "a status says how it went");
    if (estimate.valid) {
        double sum = estimate.startPose.position.x + estimate.startPose.position.y +
                     estimate.startPose.heading + estimate.pose.heading + estimate.lastHeadingSd;
        for (const double c : estimate.covariance)
            sum += c;
        require(std::isfinite(sum), "a pose is finite");
    }
    require(csvRow({"f:1", estimate, ""}).ends_with("\r\n"), "a row can be written");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const TurnFileOptions options = smallPlant();
    static const estimation::TurnContext context{options.tags, seedRssiTable(), {-0.1, 0.0}, 0.002};
    const std::string_view text = textOf({data, size});
    const auto file = parseTurns(text, options);
    if (!file)
        return 0;
    const auto lines = static_cast<int>(linesOf(text).size());
    std::size_t solved = 0;
    for (const RecordedTurn& turn : file->turns) {
        require(turn.line >= 1 && turn.line <= lines, "a turn begins at a line of the file");
        if (!turn.record) {
            require(turn.record.error().line >= turn.line && turn.record.error().line <= lines,
                    "a problem names a line of its turn");
            require(!turn.record.error().reason.empty(), "a problem has a reason");
            continue;
        }
        checkRecord(*turn.record, options);
        if (solved++ < 4)
            checkClassic(*turn.record, context);
    }
    return 0;
}
