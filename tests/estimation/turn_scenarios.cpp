// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/turn_scenarios.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <stdexcept>

namespace agv::estimation::testing {

namespace {

constexpr double kPitch_mm = 100.0;
constexpr double kRadius_mm = 100.0;
using Row = std::vector<std::pair<int, int>>;

constexpr std::array<TurnScenario, 14> kScenarios{{
    {.name = "A0_clean"},
    {.name = "A1_noise_miss10", .offByOne = 0.4, .missed = 0.10},
    {.name = "A2_noise_miss30", .offByOne = 0.4, .missed = 0.30},
    {.name = "A3_step5", .stepError = 0.05},
    {.name = "A4_step20", .stepError = 0.20},
    {.name = "A5_step10_jit1_noise_miss10",
     .offByOne = 0.4,
     .missed = 0.10,
     .stepError = 0.10,
     .jitter_deg = 1.0},
    {.name = "A6_offset_tags", .offByOne = 0.4, .missed = 0.10, .antenna_mm = 2.0, .tag_mm = 1.5},
    {.name = "A7_all",
     .offByOne = 0.4,
     .missed = 0.20,
     .stepError = 0.20,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02},
    {.name = "A8_table_wrong",
     .offByOne = 0.4,
     .missed = 0.20,
     .stepError = 0.10,
     .jitter_deg = 1.0,
     .antenna_mm = 1.0,
     .tag_mm = 1.0,
     .tableScale = 0.03,
     .edge_mm = 2.0},
    {.name = "B0_3x3_clean", .tagsPerSide = 3},
    {.name = "B1_3x3_noise_miss10", .tagsPerSide = 3, .offByOne = 0.4, .missed = 0.10},
    {.name = "B5_3x3_step10",
     .tagsPerSide = 3,
     .offByOne = 0.4,
     .missed = 0.10,
     .stepError = 0.10,
     .jitter_deg = 1.0},
    {.name = "B7_3x3_all",
     .tagsPerSide = 3,
     .offByOne = 0.4,
     .missed = 0.20,
     .stepError = 0.20,
     .jitter_deg = 1.5,
     .antenna_mm = 2.0,
     .tag_mm = 1.5,
     .stale = 0.02},
    {.name = "A9_table_very_wrong",
     .offByOne = 0.6,
     .missed = 0.30,
     .stepError = 0.10,
     .jitter_deg = 1.0,
     .antenna_mm = 1.0,
     .tag_mm = 1.0,
     .tableScale = 0.08,
     .edge_mm = 5.0},
}};

Point2 nominalTag_mm(int index, int perSide)
{
    return {(index / perSide) * kPitch_mm, (index % perSide) * kPitch_mm};
}

RssiTable disturbedTable(const TurnScenario& scenario, SplitMix64& random)
{
    RssiTable table = seedRssiTable();
    if (scenario.edge_mm <= 0.0)
        return table;
    const double scale = 1.0 + scenario.tableScale * random.normal();
    std::vector<double> edges;
    for (const RssiStep& step : table)
        edges.push_back(mmFromMetres(step.upperEdge) * scale);
    for (double& edge : edges)
        edge += scenario.edge_mm * random.normal();
    std::sort(edges.begin(), edges.end(), std::greater<>());
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i].upperEdge = metresFromMm(std::max(edges[i], 1.0));
    return table;
}

/// The RSSI the reader reports for a tag, or nothing when the read fails.
std::optional<int> reported(const TurnScenario& scenario, int rssi, SplitMix64& random)
{
    if (scenario.missed > 0.0 && random.uniform() < scenario.missed)
        return std::nullopt;
    if (scenario.offByOne > 0.0) {
        const double u = random.uniform();
        if (u < scenario.offByOne / 2.0)
            return std::max(0, rssi - 1);
        if (u < scenario.offByOne)
            return std::min(7, rssi + 1);
    }
    return rssi;
}

void addStale(const TurnScenario& scenario, const Row& previous, Row& row, SplitMix64& random)
{
    if (scenario.stale <= 0.0)
        return;
    const Row fresh = row;
    for (const auto& read : previous) {
        const double u = random.uniform();
        const auto sameTag = [&](const auto& other) { return other.first == read.first; };
        if (u < scenario.stale && std::ranges::none_of(fresh, sameTag))
            row.insert(row.begin(), read);
    }
}

Row readStop(const TurnScenario& scenario, const std::vector<Point2>& tags, const RssiTable& table,
             Point2 antenna_mm, SplitMix64& random)
{
    Row row;
    for (std::size_t t = 0; t < tags.size(); ++t) {
        const auto rssi = rssiAt(table, metresFromMm(distance(tags[t], antenna_mm)));
        if (!rssi)
            continue;
        if (const auto read = reported(scenario, *rssi, random))
            row.emplace_back(static_cast<int>(t) + 1, *read);
    }
    return row;
}

} // namespace

std::span<const TurnScenario> studyScenarios() { return kScenarios; }

const TurnScenario& studyScenario(const std::string& name)
{
    const auto found =
        std::ranges::find_if(kScenarios, [&](const TurnScenario& s) { return s.name == name; });
    if (found == kScenarios.end())
        throw std::out_of_range("no scenario " + name);
    return *found;
}

TurnContext contextOf(const TurnScenario& scenario)
{
    TurnContext context;
    context.tags =
        tagGrid(scenario.tagsPerSide, scenario.tagsPerSide, metresFromMm(kPitch_mm), {}, TagUid{1});
    return context;
}

TurnRecord recordOf(const std::vector<Row>& rows, double nominalStep_deg)
{
    TurnRecord record;
    record.nominalStep = radFromDeg(nominalStep_deg);
    for (const Row& row : rows) {
        TurnStop stop;
        for (const auto& [tag, rssi] : row)
            stop.reads.push_back({Time{}, TagUid{static_cast<std::uint64_t>(tag)}, rssi});
        record.stops.push_back(std::move(stop));
    }
    return record;
}

SimulatedTurn simulateTurn(const TurnScenario& scenario, SplitMix64& random)
{
    const bool large = scenario.tagsPerSide > 3;
    const double low = large ? 300.0 : 80.0;
    const double high = large ? 700.0 : 120.0;
    const double x = random.uniform(low, high);
    const double y = random.uniform(low, high);
    const double bearing_deg = random.uniform(-180.0, 180.0);
    double step_deg = scenario.nominalStep_deg;
    if (scenario.stepError > 0.0)
        step_deg *= 1.0 + random.uniform(-scenario.stepError, scenario.stepError);
    double radial = 0.0;
    double lateral = 0.0;
    if (scenario.antenna_mm > 0.0) {
        radial = scenario.antenna_mm * random.normal();
        lateral = scenario.antenna_mm * random.normal();
    }
    const RssiTable table = disturbedTable(scenario, random);
    std::vector<Point2> tags;
    for (int t = 0; t < scenario.tagsPerSide * scenario.tagsPerSide; ++t) {
        tags.push_back(nominalTag_mm(t, scenario.tagsPerSide));
        if (scenario.tag_mm > 0.0) {
            tags.back().x += scenario.tag_mm * random.normal();
            tags.back().y += scenario.tag_mm * random.normal();
        }
    }
    std::vector<Row> rows;
    double angle_deg = bearing_deg;
    for (int k = 0; k < scenario.stops; ++k) {
        if (k > 0)
            angle_deg += scenario.direction * step_deg +
                         (scenario.jitter_deg > 0.0 ? scenario.jitter_deg * random.normal() : 0.0);
        const double a = radFromDeg(angle_deg);
        const Point2 antenna{x + (kRadius_mm + radial) * std::cos(a) - lateral * std::sin(a),
                             y + (kRadius_mm + radial) * std::sin(a) + lateral * std::cos(a)};
        Row row = readStop(scenario, tags, table, antenna, random);
        addStale(scenario, rows.empty() ? Row{} : rows.back(), row, random);
        rows.push_back(std::move(row));
    }
    SimulatedTurn turn;
    turn.record = recordOf(rows, scenario.nominalStep_deg);
    turn.truth.startPose = {{metresFromMm(x), metresFromMm(y)}, wrapAngle(radFromDeg(bearing_deg + 180.0))};
    turn.truth.bearing = radFromDeg(bearing_deg);
    turn.truth.lastBearing = radFromDeg(angle_deg);
    turn.truth.step = scenario.direction * radFromDeg(step_deg);
    return turn;
}

SimulatedTurn studyTurn(const TurnScenario& scenario, int index)
{
    const auto found = std::ranges::find_if(
        kScenarios, [&](const TurnScenario& s) { return std::string(s.name) == scenario.name; });
    const auto order = static_cast<std::uint64_t>(found - kScenarios.begin()) + 1;
    SplitMix64 random(1000003u * order + static_cast<std::uint64_t>(index));
    return simulateTurn(scenario, random);
}

std::vector<SimulatedTurn> loadTurns(const std::string& path)
{
    std::ifstream file(path);
    if (!file)
        throw std::runtime_error("cannot open " + path);
    std::vector<SimulatedTurn> turns;
    for (std::string line; std::getline(file, line);) {
        const auto json = nlohmann::json::parse(line);
        SimulatedTurn turn;
        turn.record = recordOf(json.at("rows").get<std::vector<Row>>(), 45.0);
        turn.truth.bearing = radFromDeg(json.at("bearing").get<double>());
        turn.truth.lastBearing = radFromDeg(json.at("last_bearing").get<double>());
        turn.truth.step = radFromDeg(json.at("step").get<double>());
        turn.truth.startPose = {
            {metresFromMm(json.at("x").get<double>()), metresFromMm(json.at("y").get<double>())},
            wrapAngle(radFromDeg(json.at("heading").get<double>()))};
        turns.push_back(std::move(turn));
    }
    return turns;
}

} // namespace agv::estimation::testing
