// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a table of true places. Every place is finite, of a line of the file, and has all other columns; a
// bad row changes no other row.
#include "fuzz/table_reader_properties.h"
#include "recording/truth_table.h"

#include <algorithm>
#include <cmath>

using namespace agv::fuzz;
using namespace agv::recording;

namespace {

bool isSamePlace(const TruePlace& a, const TruePlace& b)
{
    return a.line == b.line && a.time_s == b.time_s && a.tag == b.tag && a.x_m == b.x_m && a.y_m == b.y_m &&
           a.z_m == b.z_m && a.columns == b.columns;
}

bool isSame(const TruthTable& a, const TruthTable& b)
{
    return a.otherColumns == b.otherColumns && std::ranges::equal(a.places, b.places, isSamePlace);
}

void check(const TruthTable& truth, int lines)
{
    require(!truth.places.empty(), "a truth has a place");
    int line = 0;
    for (const TruePlace& place : truth.places) {
        require(place.line >= line && place.line <= lines, "places are in the order of the lines");
        line = place.line;
        require(std::isfinite(place.x_m) && std::isfinite(place.y_m) &&
                    std::isfinite(place.z_m.value_or(0.0)) && std::isfinite(place.time_s.value_or(0.0)),
                "a place and its time are finite");
        require(place.columns.size() == truth.otherColumns.size(), "a place has every other column");
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text = textOf({data, size});
    const int lines = static_cast<int>(linesOf(text).size());
    checkTableReader(text, readTruthCsv, [lines](const TruthTable& truth) { check(truth, lines); }, isSame);
    return 0;
}
