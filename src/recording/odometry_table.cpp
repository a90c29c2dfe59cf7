// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/odometry_table.h"

#include "recording/csv_table.h"

#include <cmath>
#include <string>

namespace agv::recording {

namespace {

struct OdometryLayout {
    std::size_t time = 0;
    std::size_t first = 0;  ///< left wheel, or the vehicle's speed
    std::size_t second = 0; ///< right wheel, or the vehicle's turn rate
    bool wheels = false;
};

Result<OdometryLayout> odometryLayoutOf(const CsvTable& table, std::optional<double> track_m)
{
    const auto time = table.column("t_s");
    const auto left = table.column("v_left_mps");
    const auto right = table.column("v_right_mps");
    const auto speed = table.column("v_mps");
    const auto turn = table.column("omega_radps");
    const std::string line = std::to_string(table.headerLine()) + ": ";
    if (time && speed && turn)
        return OdometryLayout{*time, *speed, *turn, false};
    if (!time || !left || !right)
        return failure(ErrorCode::BadInput, line +
                                                "the header is not one of odometry; expected t_s,v_left_mps,"
                                                "v_right_mps or t_s,v_mps,omega_radps");
    if (!track_m)
        return failure(ErrorCode::BadInput,
                       line + "wheel speeds need the distance of the wheels; give it with --wheel-distance");
    return OdometryLayout{*time, *left, *right, true};
}

std::string takeRow(const CsvTable& table, const OdometryLayout& layout, double track_m,
                    OdometryTable& odometry)
{
    for (const std::size_t column : {layout.time, layout.first, layout.second})
        if (!table.number(column))
            return table.wrongNumber(column);
    const double time_s = *table.number(layout.time);
    const double first = *table.number(layout.first);
    const double second = *table.number(layout.second);
    if (!odometry.rows.empty() && time_s < odometry.rows.back().time_s)
        return "t_s: steps back; odometry must be in the order of time";
    const OdometryRow row = layout.wheels
                                ? OdometryRow{time_s, 0.5 * (first + second), (second - first) / track_m}
                                : OdometryRow{time_s, first, second};
    if (!std::isfinite(row.forward) || !std::isfinite(row.turn))
        return table.header()[layout.first] + ", " + table.header()[layout.second] +
               ": are beyond all measure (" + inQuotes(table.field(layout.first)) + ", " +
               inQuotes(table.field(layout.second)) + ")";
    odometry.rows.push_back(row);
    return {};
}

} // namespace

Result<OdometryTable> readOdometryCsv(std::string_view text, std::optional<double> track_m)
{
    auto table = CsvTable::open(text);
    if (!table)
        return std::unexpected(table.error());
    const auto layout = odometryLayoutOf(*table, track_m);
    if (!layout)
        return std::unexpected(layout.error());
    OdometryTable odometry;
    while (table->next()) {
        std::string reason = takeRow(*table, *layout, track_m.value_or(1.0), odometry);
        if (!reason.empty())
            odometry.problems.add(table->line(), std::move(reason));
    }
    if (odometry.rows.empty()) {
        const auto& kept = odometry.problems.kept();
        return failure(ErrorCode::BadInput,
                       kept.empty() ? "holds no row of odometry"
                                    : std::to_string(kept.front().line) + ": " + kept.front().reason);
    }
    return odometry;
}

} // namespace agv::recording
