// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a plant file. What is refused is refused with a place; what is accepted can be written, from nothing
// or over the original, and reads back as the same layout; writing it a second time changes nothing.
#include "core/plant_file.h"
#include "fuzz/fuzz_support.h"

#include <string>

using namespace agv;
using namespace agv::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto document = PlantDocument::fromText(textOf({data, size}), "f");
    if (!document) {
        require(document.error().code == ErrorCode::BadInput, "a bad text is bad input");
        require(document.error().detail.starts_with("f:"), "every mistake has a place");
        return 0;
    }
    const auto fresh = plantText(document->layout());
    require(fresh && readPlantText(*fresh, "f") == document->layout(), "read(write(x)) is x");
    const auto merged = plantText(document->layout(), &*document);
    require(merged.has_value(), "an accepted layout can be written over its original");
    const auto again = PlantDocument::fromText(*merged, "f");
    require(again && again->layout() == document->layout(), "read(write(x, original)) is x");
    require(again->warnings().size() == document->warnings().size(), "unknown keys are kept");
    const auto second = plantText(again->layout(), &*again);
    require(second && *second == *merged, "the second writing changes nothing");
    return 0;
}
