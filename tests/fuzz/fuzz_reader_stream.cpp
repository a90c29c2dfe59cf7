// SPDX-License-Identifier: GPL-3.0-or-later
// Input: u16 seed of the split, stream. Any split gives the same reports and counts; nothing is lost
// uncounted.
#include "fuzz/fuzz_support.h"
#include "protocol/reader_stream.h"

#include <chrono>
#include <string>
#include <vector>

using namespace agv::fuzz;
using namespace agv::protocol;
using namespace std::chrono_literals;
using Reports = std::vector<ReaderReport>;

namespace {

Reports reportsInPieces(ReaderStream& stream, Input bytes, std::uint16_t seed)
{
    Reports reports;
    agv::Time now{};
    agv::Time latest{};
    feedInPieces(bytes, seed, [&](Input piece) {
        now += 1ms;
        stream.feed(textOf(piece), now, [&](const ReaderReport& report, agv::Time firstByte) {
            require(firstByte >= latest && firstByte <= now && firstByte > agv::Time{},
                    "times follow the stream");
            latest = firstByte;
            reports.push_back(report);
        });
    });
    return reports;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Input bytes(data, size);
    const auto seed = take<std::uint16_t>(bytes);

    ReaderStream whole;
    Reports expected;
    whole.feed(textOf(bytes), [&expected](const ReaderReport& report) { expected.push_back(report); });
    ReaderStream split;
    require(reportsInPieces(split, bytes, seed) == expected, "the reports do not depend on the split");
    const auto counts = whole.counts();
    require(split.counts() == counts, "the counts do not depend on the split");
    require(counts.complete + counts.incomplete + counts.other == expected.size(), "every report is counted");
    require(dropDetail(counts).empty() == (counts.droppedTotal() == 0), "what was dropped has words");

    std::string again;
    for (const ReaderReport& report : expected)
        again += encodeReaderLine(report) + "<\\r>";
    ReaderStream second;
    Reports decoded;
    second.feed(again, [&decoded](const ReaderReport& report) { decoded.push_back(report); });
    require(decoded == expected && second.counts().droppedTotal() == 0, "decode(encode(x)) is x");
    return 0;
}
