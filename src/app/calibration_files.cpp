// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/calibration_files.h"

#include "app/verdict_text.h"
#include "core/text_file.h"
#include "core/units.h"
#include "recording/table_turns.h"
#include "recording/turn_results.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryFile>

#include <cstdio>
#include <system_error>

namespace agv::app {
namespace {

std::string nameOf(const CalibrationOutcome& outcome, const char* what)
{
    return "agv" + std::to_string(outcome.robot) + what;
}

std::string captureName(const CalibrationOutcome& outcome) { return nameOf(outcome, "-capture.txt"); }

/// What was read of one AGV.
Result<void> writeRecordings(const std::filesystem::path& folder, const CalibrationOutcome& outcome)
{
    if (outcome.capture.empty())
        return {};
    if (Result<void> written = writeTextFile(folder / captureName(outcome), outcome.capture); !written)
        return written;
    return writeTextFile(folder / nameOf(outcome, "-table.csv"), recording::tableText(outcome.turn.table));
}

recording::TurnResult resultOf(const CalibrationOutcome& outcome, SolveMethod method)
{
    const std::string id = captureName(outcome) + ":1";
    if (outcome.turn.result && outcome.problem.empty())
        return {id, *outcome.turn.result, {}};
    return recording::unreadableTurn(id, method, outcome.problem);
}

QJsonObject truthObject(const CalibrationOutcome& outcome)
{
    const TruePose& truth = *outcome.truth;
    QJsonObject object{{"robot", outcome.robot},
                       {"x_mm", mmFromMetres(truth.pose.position.x)},
                       {"y_mm", mmFromMetres(truth.pose.position.y)},
                       {"heading_now_deg", degFromRad(truth.pose.heading)},
                       {"charge_percent", truth.charge_percent}};
    if (outcome.turn.result && outcome.turn.result->valid) {
        const PoseError error = errorOf(*outcome.turn.result, truth);
        object["error_mm"] = mmFromMetres(error.position_m);
        object["error_deg"] = degFromRad(error.heading);
    }
    return object;
}

} // namespace

Result<void> prepareFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return failure(ErrorCode::Io, folder.string() + " cannot be made: " + error.message());
    // Not result.csv itself: an older result stays until there is a new one.
    QTemporaryFile probe(QString::fromStdString((folder / "probe-XXXXXX").string()));
    if (probe.open())
        return {};
    return failure(ErrorCode::Io,
                   folder.string() + " cannot be written to: " + probe.errorString().toStdString());
}

Result<void> writeCalibration(const std::filesystem::path& folder,
                              const std::vector<CalibrationOutcome>& outcomes, SolveMethod method)
{
    std::string csv = recording::csvHeader();
    std::string json;
    QJsonArray truths;
    for (const CalibrationOutcome& outcome : outcomes) {
        const recording::TurnResult result = resultOf(outcome, method);
        csv += recording::csvRow(result);
        std::string line = recording::jsonLine(result);
        while (line.ends_with('\n'))
            line.pop_back();
        json += (json.empty() ? "[\n" : ",\n") + line;
        if (outcome.truth)
            truths.append(truthObject(outcome));
        if (Result<void> written = writeRecordings(folder, outcome); !written)
            return written;
    }
    if (Result<void> written = writeTextFile(folder / "result.csv", csv); !written)
        return written;
    if (Result<void> written =
            writeTextFile(folder / "result.json", json + (json.empty() ? "[]\n" : "\n]\n"));
        !written)
        return written;
    if (truths.isEmpty())
        return {};
    return writeTextFile(folder / "truth.json", QJsonDocument(truths).toJson().toStdString());
}

PoseError errorOf(const TurnEstimate& estimate, const TruePose& truth)
{
    return {distance(estimate.pose.position, truth.pose.position),
            wrapAngle(estimate.pose.heading - truth.pose.heading)};
}

std::string truthText(const CalibrationOutcome& outcome)
{
    if (!outcome.truth)
        return {};
    const Pose2& pose = outcome.truth->pose;
    std::string text = "  Simulated truth: " + thousands(mmFromMetres(pose.position.x)) + " mm, " +
                       thousands(mmFromMetres(pose.position.y)) + " mm, facing " +
                       thousands(degFromRad(pose.heading)) + " degrees";
    if (!outcome.turn.result || !outcome.turn.result->valid)
        return text;
    const PoseError error = errorOf(*outcome.turn.result, *outcome.truth);
    char errorText[80];
    std::snprintf(errorText, sizeof errorText, "; error %.1f mm, %.1f degrees",
                  mmFromMetres(error.position_m), std::abs(degFromRad(error.heading)));
    return text + errorText;
}

} // namespace agv::app
