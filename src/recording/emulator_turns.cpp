// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/emulator_turns.h"

#include "core/units.h"
#include "recording/emulator_changes.h"
#include "recording/emulator_line.h"
#include "recording/turn_limits.h"

#include <algorithm>
#include <cmath>

namespace agv::recording {

namespace {

/// Angles are printed with at least six digits.
constexpr double angleTolerance_deg = 1e-3;

/// Lines of one turn, good and bad.
struct EmulatorTurn {
    int line = 0;
    std::vector<EmulatorReading> readings;  ///< angles never fall
    std::optional<TurnFileProblem> problem; ///< the first
};

std::vector<EmulatorTurn> splitIntoTurns(const std::vector<TextLine>& lines, const TagNumbers& numbers)
{
    std::vector<EmulatorTurn> turns;
    const auto current = [&](int line) -> EmulatorTurn& {
        if (turns.empty())
            turns.push_back({line, {}, {}});
        return turns.back();
    };
    for (const TextLine& line : lines) {
        const auto parsed = parseEmulatorLine(line.text, numbers);
        if (!parsed) {
            EmulatorTurn& turn = current(line.number);
            if (!turn.problem)
                turn.problem = TurnFileProblem{line.number, parsed.error()};
            continue;
        }
        if (!*parsed)
            continue;
        EmulatorReading reading = **parsed;
        reading.line = line.number;
        const EmulatorTurn& turn = current(line.number);
        if (!turn.readings.empty() && reading.angle_deg < turn.readings.back().angle_deg - angleTolerance_deg)
            turns.push_back({line.number, {}, {}});
        turns.back().readings.push_back(reading);
    }
    return turns;
}

/// Smallest difference of two angles; the default for a single stop.
double stepOf(const std::vector<EmulatorReading>& readings, double defaultStep_deg)
{
    double step = 0.0;
    for (std::size_t k = 1; k < readings.size(); ++k) {
        const double difference = readings[k].angle_deg - readings[k - 1].angle_deg;
        if (difference > angleTolerance_deg && (step == 0.0 || difference < step))
            step = difference;
    }
    return step > 0.0 ? step : defaultStep_deg;
}

std::expected<StopReadings, TurnFileProblem> readingsByStop(const std::vector<EmulatorReading>& readings,
                                                            double step_deg)
{
    StopReadings stops;
    for (const EmulatorReading& reading : readings) {
        const double steps = std::round(reading.angle_deg / step_deg);
        if (std::abs(steps * step_deg - reading.angle_deg) > angleTolerance_deg * std::max(1.0, steps))
            return std::unexpected(TurnFileProblem{
                reading.line,
                "the angle is no multiple of the turn's step, the smallest difference of its angles"});
        if (!(steps < static_cast<double>(mostStops)))
            return std::unexpected(
                TurnFileProblem{reading.line, "more than " + std::to_string(mostStops) + " stops"});
        const auto stop = static_cast<std::size_t>(steps);
        if (stop >= stops.size())
            stops.resize(stop + 1);
        if (stops[stop].size() >= mostReadsPerStop)
            return std::unexpected(TurnFileProblem{reading.line, "too many readings at one stop"});
        stops[stop].emplace_back(reading.tag, reading.rssi);
    }
    return stops;
}

std::vector<TurnStop> stopsFromAllReadings(const StopReadings& readings)
{
    std::vector<TurnStop> stops(readings.size());
    for (std::size_t stop = 0; stop < readings.size(); ++stop) {
        for (const auto& [uid, rssi] : readings[stop])
            stops[stop].reads.push_back({Time{}, uid, rssi});
    }
    return stops;
}

std::expected<TurnRecord, TurnFileProblem> recordOf(const EmulatorTurn& turn, const TurnFileOptions& options)
{
    if (turn.problem)
        return std::unexpected(*turn.problem);
    const double step_deg = stepOf(turn.readings, degFromRad(options.nominalStep));
    if (!isStep(radFromDeg(step_deg)))
        return std::unexpected(
            TurnFileProblem{turn.line, "the angles differ by less than 1 or more than 180 degrees"});
    const auto readings = readingsByStop(turn.readings, step_deg);
    if (!readings)
        return std::unexpected(readings.error());
    TurnRecord record;
    record.nominalStep = radFromDeg(step_deg);
    record.turnTime_s = options.turnTime_s;
    record.stops = canBeChangesOnly(*readings) ? stopsFromChanges(*readings, options.tags)
                                               : stopsFromAllReadings(*readings);
    return record;
}

} // namespace

bool looksLikeEmulatorLine(std::string_view line)
{
    const std::vector<std::string_view> tokens = tokensOf(withoutLiteralReturn(line));
    if (tokens.size() < 2 || !parseNumber(tokens[0]))
        return false;
    return tokens[1].starts_with("SCAN:") || (tokens.size() == 3 && parseInteger(tokens[2]).has_value());
}

std::vector<RecordedTurn> readEmulatorTurns(const std::vector<TextLine>& lines,
                                            const TurnFileOptions& options)
{
    const TagNumbers numbers(options.tags);
    std::vector<RecordedTurn> turns;
    for (const EmulatorTurn& turn : splitIntoTurns(lines, numbers))
        turns.push_back({turn.line, recordOf(turn, options)});
    return turns;
}

} // namespace agv::recording
