// SPDX-License-Identifier: GPL-3.0-or-later
// Input: the emulator's side file. What is accepted is in its range; a field has the tags that the file says.
#include "fuzz/fuzz_support.h"
#include "recording/emulator_setup.h"

#include <cmath>

using namespace agv;
using namespace agv::fuzz;
using namespace agv::recording;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto setup = parseEmulatorSetup(textOf({data, size}));
    if (!setup) {
        require(!setup.error().detail.empty(), "a refusal has a reason");
        return 0;
    }
    require(setup->tags >= 1 && setup->length_m > 0.0, "tags and length are positive");
    require(std::isfinite(setup->startAngle) && std::isfinite(setup->start.x) &&
                std::isfinite(setup->start.y),
            "numbers are finite");
    if (const auto tags = fieldOf(*setup, TagUid{1}))
        require(tags->size() == static_cast<std::size_t>(setup->tags), "a field has the tags of the file");
    return 0;
}
