// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a table of floor tags read, or of their places. Every row has tags in hexadecimal or a finite
// position, never both, and none is before another; a bad row changes no other row.
#include "fuzz/table_reader_properties.h"
#include "recording/floor_read_table.h"

#include <algorithm>
#include <cmath>

using namespace agv::fuzz;
using namespace agv::recording;

namespace {

constexpr std::size_t mostDigits = 16;

bool isUid(std::string_view uid)
{
    return !uid.empty() && uid.size() <= mostDigits &&
           uid.find_first_not_of("0123456789ABCDEF") == std::string_view::npos;
}

void checkReads(const FloorReadTable& reads)
{
    require(!reads.rows.empty(), "a table of reads has one");
    double before_s = reads.rows.front().time_s;
    const bool arePositions = reads.rows.front().x_m.has_value();
    for (const FloorReadRow& row : reads.rows) {
        require(std::isfinite(row.time_s) && row.time_s >= before_s, "times are finite and rise");
        before_s = row.time_s;
        require(row.x_m.has_value() == row.y_m.has_value() && row.x_m.has_value() == arePositions,
                "all rows are positions or none is");
        require(row.uids.empty() == arePositions, "a row has tags or a position");
        require(std::isfinite(row.x_m.value_or(0.0)) && std::isfinite(row.y_m.value_or(0.0)),
                "a position is finite");
        require(std::ranges::all_of(row.uids, isUid), "a tag is up to 16 capital hexadecimal digits");
    }
}

bool areSameReads(const FloorReadTable& a, const FloorReadTable& b)
{
    return std::ranges::equal(a.rows, b.rows, [](const FloorReadRow& x, const FloorReadRow& y) {
        return x.line == y.line && x.time_s == y.time_s && x.uids == y.uids && x.x_m == y.x_m &&
               x.y_m == y.y_m;
    });
}

void checkPlaces(const TagPlaceTable& places)
{
    require(!places.tags.empty(), "a table of places has one");
    for (const TagPlace& tag : places.tags) {
        require(isUid(tag.uid), "a tag is up to 16 capital hexadecimal digits");
        require(std::isfinite(tag.x_m) && std::isfinite(tag.y_m), "a place is finite");
    }
}

bool areSamePlaces(const TagPlaceTable& a, const TagPlaceTable& b)
{
    return std::ranges::equal(a.tags, b.tags, [](const TagPlace& x, const TagPlace& y) {
        return x.uid == y.uid && x.x_m == y.x_m && x.y_m == y.y_m;
    });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text = textOf({data, size});
    checkTableReader(text, readFloorReadCsv, checkReads, areSameReads);
    checkTableReader(text, readTagPlaceCsv, checkPlaces, areSamePlaces);
    return 0;
}
