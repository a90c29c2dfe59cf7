// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/turn_results.h"

#include "core/units.h"
#include "recording/csv_text.h"
#include "recording/number_text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <variant>
#include <vector>

namespace agv::recording {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// A value of either format; empty: there is none.
using Value = std::variant<std::monostate, double, std::string, std::vector<std::string>>;

struct Field {
    const char* name;
    Value value;
};

double mm2From(double m2) { return m2 * 1e6; }

Value optionalMs(const std::optional<double>& s) { return s ? Value(*s * 1e3) : Value(); }

Value flagsOf(const TurnEstimate& estimate)
{
    std::vector<std::string> flags;
    for (const TurnFlag flag : estimate.flags)
        flags.emplace_back(toText(flag));
    return flags;
}

/// The fields of a result, in the order of the columns.
std::vector<Field> resultFieldsOf(const TurnResult& result)
{
    const TurnEstimate& e = result.estimate;
    const auto ifValid = [&](double value) { return e.valid ? Value(value) : Value(); };
    const auto ifAlternative = [&](auto get) {
        return e.valid && e.alternative ? Value(get(*e.alternative)) : Value();
    };
    const auto sd = [](double variance) { return std::sqrt(variance); };
    return {
        {"id", result.id},
        {"status", e.status},
        {"x_mm", ifValid(mmFromMetres(e.startPose.position.x))},
        {"y_mm", ifValid(mmFromMetres(e.startPose.position.y))},
        {"heading_deg", ifValid(degFromRad(e.startPose.heading))},
        {"sd_x_mm", ifValid(mmFromMetres(sd(e.covariance[0])))},
        {"sd_y_mm", ifValid(mmFromMetres(sd(e.covariance[4])))},
        {"sd_heading_deg", ifValid(degFromRad(sd(e.covariance[8])))},
        {"cov_xx_mm2", ifValid(mm2From(e.covariance[0]))},
        {"cov_xy_mm2", ifValid(mm2From(e.covariance[1]))},
        {"cov_yy_mm2", ifValid(mm2From(e.covariance[4]))},
        {"direction", e.valid ? Value(std::string(toText(e.rotation))) : Value()},
        {"step_deg", ifValid(degFromRad(e.step))},
        {"step_sd_deg", ifValid(degFromRad(e.stepSd))},
        {"sleeptime_ms", e.valid ? optionalMs(e.suggestedTurnTime_s) : Value()},
        {"sleeptime_sd_ms",
         e.valid && e.suggestedTurnTime_s ? Value(e.suggestedTurnTimeSd_s * 1e3) : Value()},
        {"flags", flagsOf(e)},
        {"method", std::string(toText(e.method))},
        {"elapsed_ms", e.elapsed_s * 1e3},
        {"x_now_mm", ifValid(mmFromMetres(e.pose.position.x))},
        {"y_now_mm", ifValid(mmFromMetres(e.pose.position.y))},
        {"heading_now_deg", ifValid(degFromRad(e.pose.heading))},
        {"sd_heading_now_deg", ifValid(degFromRad(e.lastHeadingSd))},
        {"radius_mm", ifValid(mmFromMetres(e.radius_m))},
        {"profile", e.profile.empty() ? Value() : Value(e.profile)},
        {"alt_x_mm", ifAlternative([](const auto& a) { return mmFromMetres(a.pose.position.x); })},
        {"alt_y_mm", ifAlternative([](const auto& a) { return mmFromMetres(a.pose.position.y); })},
        {"alt_heading_deg", ifAlternative([](const auto& a) { return degFromRad(a.pose.heading); })},
        {"alt_log_odds", ifAlternative([](const auto& a) { return a.logOdds; })},
        {"problem", result.problem.empty() ? Value() : Value(result.problem)},
    };
}

std::string csvText(const Value& value)
{
    if (const auto* number = std::get_if<double>(&value))
        return numberText(*number);
    if (const auto* text = std::get_if<std::string>(&value))
        return csvField(*text);
    std::string joined;
    if (const auto* words = std::get_if<std::vector<std::string>>(&value)) {
        for (const std::string& word : *words)
            joined += (joined.empty() ? "" : ";") + word;
    }
    return csvField(joined);
}

OrderedJson jsonFrom(const Value& value)
{
    if (const auto* number = std::get_if<double>(&value))
        return std::isfinite(*number) ? OrderedJson(*number) : OrderedJson();
    if (const auto* text = std::get_if<std::string>(&value))
        return *text;
    if (const auto* words = std::get_if<std::vector<std::string>>(&value))
        return *words;
    return {};
}

OrderedJson uidsOf(const std::vector<TagUid>& tags)
{
    OrderedJson list = OrderedJson::array();
    for (const TagUid uid : tags)
        list.push_back(fullText(uid));
    return list;
}

OrderedJson stopsOf(const TurnEstimate& estimate)
{
    OrderedJson stops = OrderedJson::array();
    for (const StopReport& stop : estimate.stops) {
        const auto ifValid = [&](double value) { return estimate.valid ? jsonFrom(value) : OrderedJson(); };
        stops.push_back({{"antenna_x_mm", ifValid(mmFromMetres(stop.antenna.x))},
                         {"antenna_y_mm", ifValid(mmFromMetres(stop.antenna.y))},
                         {"antenna_bearing_deg", ifValid(degFromRad(stop.antennaBearing))},
                         {"antenna_sd_mm", ifValid(mmFromMetres(stop.antennaSd_m))},
                         {"seen", uidsOf(stop.seen)},
                         {"expected", uidsOf(stop.expected)},
                         {"missed", uidsOf(stop.missed)},
                         {"unknown", uidsOf(stop.unknown)},
                         {"misplaced", uidsOf(stop.misplaced)}});
    }
    return stops;
}

/// Rows and columns x_mm, y_mm, heading_deg.
OrderedJson covarianceOf(const TurnEstimate& estimate)
{
    if (!estimate.valid)
        return {};
    const std::array<double, 3> scale{mmFromMetres(1.0), mmFromMetres(1.0), degFromRad(1.0)};
    OrderedJson rows = OrderedJson::array();
    for (std::size_t row = 0; row < 3; ++row) {
        OrderedJson values = OrderedJson::array();
        for (std::size_t column = 0; column < 3; ++column)
            values.push_back(jsonFrom(estimate.covariance[3 * row + column] * scale[row] * scale[column]));
        rows.push_back(std::move(values));
    }
    return rows;
}

} // namespace

TurnResult unreadableTurn(std::string id, SolveMethod method, std::string problem)
{
    TurnResult result;
    result.id = std::move(id);
    result.estimate.method = method;
    result.estimate.status = "bad_input";
    result.problem = std::move(problem);
    return result;
}

std::string csvHeader()
{
    std::vector<std::string> names;
    for (const Field& field : resultFieldsOf({}))
        names.emplace_back(field.name);
    return csvLine(names);
}

std::string csvRow(const TurnResult& result)
{
    std::vector<std::string> texts;
    for (const Field& field : resultFieldsOf(result))
        texts.push_back(csvText(field.value));
    return csvLine(texts);
}

std::string jsonLine(const TurnResult& result)
{
    OrderedJson json = OrderedJson::object();
    for (const Field& field : resultFieldsOf(result))
        json[field.name] = jsonFrom(field.value);
    json["covariance"] = covarianceOf(result.estimate);
    json["stops"] = stopsOf(result.estimate);
    // Names of files need not be UTF-8; what is not becomes U+FFFD.
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

} // namespace agv::recording
