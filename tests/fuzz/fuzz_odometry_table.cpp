// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a table of wheel odometry. Every row is finite and none is before another; wheel speeds need the
// distance of the wheels; a bad row changes no other row.
#include "fuzz/table_reader_properties.h"
#include "recording/odometry_table.h"

#include <cmath>
#include <optional>

using namespace agv::fuzz;
using namespace agv::recording;

namespace {

void check(const OdometryTable& odometry)
{
    require(!odometry.rows.empty(), "odometry has a row");
    double before_s = odometry.rows.front().time_s;
    for (const OdometryRow& row : odometry.rows) {
        require(std::isfinite(row.time_s) && std::isfinite(row.forward) && std::isfinite(row.turn),
                "a row is finite");
        require(row.time_s >= before_s, "times rise");
        before_s = row.time_s;
    }
}

bool isSame(const OdometryTable& a, const OdometryTable& b) { return a.rows == b.rows; }

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text = textOf({data, size});
    const auto readWith = [](std::optional<double> track_m) {
        return [track_m](std::string_view table) { return readOdometryCsv(table, track_m); };
    };
    checkTableReader(text, readWith(0.157), check, isSame);
    checkTableReader(text, readWith(std::nullopt), check, isSame);
    return 0;
}
