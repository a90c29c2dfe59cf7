// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/turn_results.h"

#include "core/units.h"
#include "recording/csv_text.h"
#include "recording/number_text.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace agv::recording {
namespace {

TurnResult solved()
{
    TurnResult result;
    result.id = "turns.jsonl:3";
    TurnEstimate& e = result.estimate;
    e.valid = true;
    e.status = "ok";
    e.startPose = {{0.0924, 0.0962}, radFromDeg(-1.5)};
    e.pose = {{0.0974, 0.0912}, radFromDeg(30.0)};
    e.covariance = {16e-6, 2e-6, 0, 2e-6, 25e-6, 0, 0, 0, radFromDeg(4.0) * radFromDeg(4.0)};
    e.rotation = Rotation::Clockwise;
    e.step = radFromDeg(42.5);
    e.stepSd = radFromDeg(1.5);
    e.suggestedTurnTime_s = 1.19125;
    e.suggestedTurnTimeSd_s = 0.05;
    e.flags = {TurnFlag::Weak, TurnFlag::Ambiguous};
    e.elapsed_s = 0.0125;
    e.radius_m = 0.1;
    e.profile = "wide";
    e.alternative = AlternativePose{{{0.2, 0.3}, radFromDeg(90.0)}, 2.5};
    StopReport stop;
    stop.antenna = {0.01, 0.02};
    stop.seen = {TagUid{0xE004000000000001}};
    stop.missed = {TagUid{0xE004000000000002}};
    e.stops = {stop};
    return result;
}

std::string rowOf(const std::string& line, std::size_t column)
{
    std::vector<std::string> cells{""};
    for (const char c : line) {
        if (c == ',')
            cells.emplace_back();
        else
            cells.back() += c;
    }
    return cells.at(column);
}

TEST(TurnResults, everyRowHasTheColumnsOfTheHeader)
{
    const std::string header = csvHeader();
    EXPECT_TRUE(
        header.starts_with("id,status,x_mm,y_mm,heading_deg,sd_x_mm,sd_y_mm,sd_heading_deg,cov_xx_mm2,"
                           "cov_xy_mm2,cov_yy_mm2,direction,step_deg,step_sd_deg,sleeptime_ms,"
                           "sleeptime_sd_ms,flags,method,elapsed_ms,x_now_mm,y_now_mm,heading_now_deg,"))
        << header;
    EXPECT_TRUE(header.ends_with("problem\r\n"));
    EXPECT_EQ(
        csvRow(solved()),
        "turns.jsonl:3,ok,92.4,96.2,-1.5,4,5,4,16,2,25,cw,42.5,1.5,1191.25,50,\"weak;ambiguous\",auto,12.5,"
        "97.4,91.2,30,0,100,wide,200,300,90,2.5,\r\n");
    for (const std::string& row : {csvRow({}), csvRow(unreadableTurn("a:1", SolveMethod::Fast, "bad"))})
        EXPECT_EQ(std::ranges::count(row, ','), std::ranges::count(header, ',')) << row;
}

TEST(TurnResults, aTurnWithoutAPoseHasNoNumbersButItsStatus)
{
    TurnResult result = solved();
    result.estimate.valid = false;
    result.estimate.status = "no_reads";
    const std::string row = csvRow(result);
    EXPECT_EQ(rowOf(row, 1), "no_reads");
    for (std::size_t column = 2; column < 16; ++column)
        EXPECT_EQ(rowOf(row, column), "") << column;
    const auto json = nlohmann::json::parse(jsonLine(result));
    EXPECT_TRUE(json["x_mm"].is_null());
    EXPECT_TRUE(json["covariance"].is_null());
    EXPECT_TRUE(json["stops"][0]["antenna_x_mm"].is_null());
    EXPECT_EQ(json["stops"][0]["seen"].size(), 1U);
}

TEST(TurnResults, unreadableTurnsSayWhy)
{
    const TurnResult result = unreadableTurn("a.csv:2", SolveMethod::Classic, "line 3: RSSI, 9");
    EXPECT_TRUE(csvRow(result).starts_with("a.csv:2,bad_input,,"));
    EXPECT_TRUE(csvRow(result).ends_with("\"line 3: RSSI, 9\"\r\n"));
    EXPECT_EQ(nlohmann::json::parse(jsonLine(result))["problem"], "line 3: RSSI, 9");
}

TEST(TurnResults, jsonLinesHoldTheSameValuesAndTheStops)
{
    const std::string line = jsonLine(solved());
    EXPECT_EQ(std::ranges::count(line, '\n'), 1);
    const auto json = nlohmann::json::parse(line);
    EXPECT_EQ(json["id"], "turns.jsonl:3");
    EXPECT_NEAR(json["x_mm"].get<double>(), 92.4, 1e-9);
    EXPECT_EQ(json["direction"], "cw");
    EXPECT_EQ(json["flags"], nlohmann::json({"weak", "ambiguous"}));
    EXPECT_NEAR(json["covariance"][2][2].get<double>(), 16.0, 1e-9);
    EXPECT_NEAR(json["covariance"][0][1].get<double>(), 2.0, 1e-9);
    EXPECT_NEAR(json["stops"][0]["antenna_x_mm"].get<double>(), 10.0, 1e-9);
    EXPECT_EQ(json["stops"][0]["missed"], nlohmann::json({"E004000000000002"}));
    EXPECT_TRUE(json["problem"].is_null());
}

TEST(TurnResults, namesThatAreNotUtf8GiveValidJson)
{
    TurnResult result = solved();
    result.id = "\xFF.csv:1";
    EXPECT_TRUE(nlohmann::json::accept(jsonLine(result)));
}

TEST(CsvText, quotesAndDefusesFormulas)
{
    EXPECT_EQ(csvField("plain"), "plain");
    EXPECT_EQ(csvField("a,b"), "\"a,b\"");
    EXPECT_EQ(csvField("say \"x\""), "\"say \"\"x\"\"\"");
    EXPECT_EQ(csvField("a\nb"), "\"a\nb\"");
    EXPECT_EQ(csvField("=1+1"), "'=1+1");
    EXPECT_EQ(csvField("@x,y"), "\"'@x,y\"");
    EXPECT_EQ(csvField("-2.csv:1"), "'-2.csv:1");
    EXPECT_EQ(csvField(""), "");
}

TEST(NumberText, isShortExactAndNeverNotANumber)
{
    EXPECT_EQ(numberText(92.4), "92.4");
    EXPECT_EQ(numberText(-0.0), "0");
    EXPECT_EQ(numberText(1234567.875), "1234567.875");
    EXPECT_EQ(numberText(1.0 / 3.0), "0.3333333333");
    EXPECT_EQ(numberText(std::nan("")), "");
    EXPECT_EQ(numberText(std::numeric_limits<double>::infinity()), "");
}

} // namespace
} // namespace agv::recording
