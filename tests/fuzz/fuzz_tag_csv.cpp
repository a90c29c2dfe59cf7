// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a table of surveyed tags. What is refused is refused with its line; what is accepted is written and
// reads back as the same tags.
#include "core/tag_csv.h"
#include "fuzz/fuzz_support.h"

using namespace agv;
using namespace agv::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto tags = readTagCsv(textOf({data, size}), "f");
    if (!tags) {
        require(tags.error().detail.starts_with("f:"), "every mistake has a line");
        return 0;
    }
    const auto again = readTagCsv(writeTagCsv(*tags), "f");
    require(again && *again == *tags, "read(write(x)) is x");
    return 0;
}
