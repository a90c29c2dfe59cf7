// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a settings file of DecaRangeRTLS, or a table of anchors. What is read keeps to its limits, and reads
// back the same after writing; problems name lines of the file.
#include "fuzz/fuzz_support.h"
#include "recording/anchor_csv.h"
#include "recording/trek_config.h"

#include <algorithm>
#include <cmath>

using namespace agv;
using namespace agv::fuzz;
using namespace agv::recording;

namespace {

void checkProblems(const FileProblems& problems, std::string_view text)
{
    const auto lines = 1 + std::ranges::count(text, '\n');
    for (const FileProblem& problem : problems.kept())
        require(problem.line >= 1 && problem.line <= lines && !problem.reason.empty(),
                "a problem names a line and has a reason");
}

void checkAnchors(const std::vector<UwbAnchor>& anchors)
{
    for (const UwbAnchor& anchor : anchors) {
        require(anchor.id >= 0 && anchor.id <= 255, "an id is 0 to 255");
        require(std::abs(anchor.x) <= 1e3 && std::abs(anchor.y) <= 1e3 && std::abs(anchor.z) <= 1e3,
                "an anchor is within 1 km");
    }
}

bool samePlaces(const std::vector<UwbAnchor>& a, const std::vector<UwbAnchor>& b)
{
    return std::ranges::equal(a, b, [](const UwbAnchor& p, const UwbAnchor& q) {
        return p.id == q.id && p.x == q.x && p.y == q.y && p.z == q.z && p.shown == q.shown;
    });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text = textOf({data, size});
    if (const auto config = readTrekAnchorConfig(text)) {
        checkProblems(config->problems, text);
        checkAnchors(config->anchors);
        const auto again = readTrekAnchorConfig(writeTrekAnchorConfig(config->anchors, config->corrections));
        require(config->anchors.empty() || (again && samePlaces(again->anchors, config->anchors) &&
                                            again->corrections.size() == config->corrections.size()),
                "written anchors read back the same");
    }
    if (const auto config = readTrekTagConfig(text)) {
        checkProblems(config->problems, text);
        require(std::isfinite(config->drawnSize_m) && config->history >= 0, "settings are in their range");
        const auto again = readTrekTagConfig(writeTrekTagConfig(*config));
        require(again && again->tags.size() == config->tags.size(), "written tags read back the same");
    }
    if (const auto anchors = readAnchorCsv(text)) {
        checkAnchors(*anchors);
        const auto again = readAnchorCsv(writeAnchorCsv(*anchors));
        require(again && samePlaces(*again, *anchors), "a written table reads back the same");
    }
    return 0;
}
