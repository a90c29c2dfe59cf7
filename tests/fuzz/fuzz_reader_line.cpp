// SPDX-License-Identifier: GPL-3.0-or-later
// Input: one line. What is decoded can be encoded and comes back; blanks around a line change nothing.
#include "fuzz/fuzz_support.h"
#include "protocol/reader_line.h"

#include <string>

using namespace agv::fuzz;
using namespace agv::protocol;

namespace {

struct InRange {
    bool operator()(const CompleteRead& read) const
    {
        return read.rssi >= 0 && read.rssi <= 7 && read.auxiliaryRssi >= -1 && read.auxiliaryRssi <= 7;
    }
    bool operator()(const IncompleteRead&) const { return true; }
    bool operator()(const ReaderOk&) const { return true; }
    bool operator()(const InventoryCount& count) const { return count.tags >= 0 && count.tags <= 9999; }
    bool operator()(const Rc522Read& read) const { return read.uid.value <= 0xFFFFFFFFU; }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view line = textOf({data, size});
    const auto report = decodeReaderLine(line);
    require(decodeReaderLine(" \t" + std::string(line) + " ") == report,
            "blanks around a line change nothing");
    if (!report) {
        require(report.error() != ReaderLineError::Overlong, "only a framer finds a line over-long");
        return 0;
    }
    require(std::visit(InRange{}, *report), "every field is in its range");
    require(decodeReaderLine(encodeReaderLine(*report)) == report, "decode(encode(x)) is x");
    return 0;
}
