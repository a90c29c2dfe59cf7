// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "recording/run_reader.h"
#include "recording/run_writer.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <string>
#include <utility>
#include <vector>

namespace agv::recording::test {

inline std::uint64_t below(SplitMix64& random, std::uint64_t limit) { return random.next() % limit; }

/// A folder that is gone at the end of the test.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "agv-run-XXXXXX").string();
        m_path = ::mkdtemp(pattern.data());
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

inline constexpr std::int64_t startUtc_us = 1'773'761'405'123'000; // 2026-03-17T15:30:05.123Z
inline constexpr Time startTime = Time{} + std::chrono::hours(100);

inline ClockPair clocksAt(Duration since) { return {startTime + since, startUtc_us + since.count() / 1000}; }

inline PlantLayout smallPlant()
{
    PlantLayout plant;
    plant.name = "test";
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    return plant;
}

inline RunInfo operatorsRun()
{
    RunInfo info;
    info.software = "agv-console test";
    info.startedBy = "operator";
    info.note = "loose tag on \"AGV 2\"";
    info.plantName = "test";
    info.agvs = {1, 2};
    info.solver = "auto";
    return info;
}

inline Result<RunWriter> newRun(const std::filesystem::path& runs)
{
    return RunWriter::create(runs, operatorsRun(), smallPlant(), clocksAt({}));
}

/// A row of any kind with any values.
inline RunRow randomRow(SplitMix64& random, Time time)
{
    const auto whole = [&](int limit) {
        return static_cast<int>(below(random, static_cast<std::uint64_t>(limit)));
    };
    const auto length = [&] { return random.uniform(-20.0, 20.0); };
    const RobotId agv{1 + whole(4)};
    const PoseCovariance covariance{1e-6, 1e-7, 0.0, 1e-7, 4e-6, -1e-7, 0.0, -1e-7, 1e-5};
    const Pose2 pose{{length(), length()}, random.uniform(-3.1, 3.1)};
    const double measured_s = secondsFrom(time.time_since_epoch()) - 0.1;
    switch (whole(static_cast<int>(runTableCount))) {
    case 0:
        return TagReadRow{agv, {time, TagUid{random.next()}, whole(8)}};
    case 1:
        return RangeRow{time,
                        {.time_s = measured_s,
                         .range_m = 0.001 * whole(20'000),
                         .tag = whole(8),
                         .anchor = whole(4),
                         .sequence = whole(257) - 1},
                        whole(2) == 0 ? std::nullopt : std::optional(length()),
                        whole(2) == 0};
    case 2:
        return TagPositionRow{time, measured_s, whole(8), {length(), length()}, {1e-4, 2e-5, 1e-4}};
    case 3:
        return PoseRow{time, agv, pose, covariance, PoseHealth::Tracked};
    case 4:
        return WheelCommandRow{time, agv, {0.001 * whole(500), -0.001 * whole(500)}};
    case 5:
        return RobotStateRow{time, agv, static_cast<RobotState>(whole(9))};
    case 6:
        return BatteryRow{time, agv, {ChargingState::Waiting, 14.321, -0.75, 31, 2.1, 3.0, false, true}};
    case 7:
        return TurnStepRow{time, agv, static_cast<TurnPhase>(whole(8)), 1 + whole(9)};
    case 8:
        return TurnResultRow{time, agv, TurnPhase::Finished, pose, covariance, "ok, \"sure\"\r\nof it"};
    case 9:
        return EventRow{time, {0, EventLevel::Warning, "AGV 1", "=1+1; größer"}};
    default:
        return OperatorActionRow{time, "start turn", whole(2) == 0 ? std::nullopt : std::optional(agv), ""};
    }
}

/// Half a second of anything.
inline RunBatch randomBatch(SplitMix64& random, Time from, int rows)
{
    RunBatch batch;
    for (int i = 0; i < rows; ++i) {
        const Time time = from + std::chrono::microseconds(500'000 / rows * i);
        batch.rows.push_back(randomRow(random, time));
        std::string bytes(below(random, 40), '\0');
        for (char& byte : bytes)
            byte = static_cast<char>(below(random, 256));
        batch.chunks.push_back({time, below(random, 2) == 0 ? "reader 1" : "uwb", bytes});
    }
    const Duration since = from - startTime + std::chrono::milliseconds(500);
    batch.clocks = clocksAt(since);
    return batch;
}

/// A row as the run holds it, with texts of its own.
struct StoredRow {
    std::int64_t t_ns = 0;
    std::vector<std::variant<std::monostate, std::int64_t, std::string>> cells;
    friend bool operator==(const StoredRow&, const StoredRow&) = default;
};

inline StoredRow stored(std::int64_t t_ns, std::span<const RunCell> cells)
{
    StoredRow row{t_ns, {}};
    for (const RunCell& cell : cells) {
        if (const auto* text = std::get_if<std::string_view>(&cell))
            row.cells.emplace_back(std::string(*text));
        else if (const auto* number = std::get_if<std::int64_t>(&cell))
            row.cells.emplace_back(*number);
        else
            row.cells.emplace_back();
    }
    return row;
}

inline StoredRow stored(const RunRow& row)
{
    const RunCells cells = cellsOf(row);
    return stored(Duration(cells.time - startTime).count(), {cells.cells.data(), cells.count});
}

inline Result<std::vector<StoredRow>> rowsOf(RunReader& run, std::size_t table)
{
    std::vector<StoredRow> rows;
    const Result<void> read = run.rows(table, [&](const RunReader::Row& row) {
        rows.push_back(stored(row.t_ns, row.cells));
        return true;
    });
    if (!read)
        return std::unexpected(read.error());
    return rows;
}

inline Result<std::vector<RunChunk>> chunksOf(RunReader& run)
{
    std::vector<RunChunk> chunks;
    const Result<void> read = run.chunks([&](const RunChunk& chunk) {
        chunks.push_back(chunk);
        return true;
    });
    if (!read)
        return std::unexpected(read.error());
    return chunks;
}

} // namespace agv::recording::test
