// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/json_turns.h"

#include "recording/tag_numbers.h"
#include "recording/turn_limits.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace agv::recording {

namespace {

using Json = nlohmann::json;

/// Thrown inside this file only, and turned into a TurnFileProblem at the line.
struct Refusal {
    std::string reason;
};

/// A value for a message; lists and objects by kind only, they may be endless.
std::string shown(const Json& json)
{
    if (json.is_structured())
        return json.is_array() ? "a list" : "an object";
    return inQuotes(json.dump(-1, ' ', true, Json::error_handler_t::replace));
}

TagUid tagFrom(const Json& json, const TagNumbers& numbers)
{
    if (json.is_number_integer() && json >= 1 && json <= std::numeric_limits<int>::max())
        return numbers.uidOf(json.get<int>());
    if (json.is_string()) {
        if (const auto uid = numbers.parse(json.get_ref<const std::string&>()))
            return *uid;
    }
    throw Refusal{shown(json) + " is not a tag; expected a number from 1 or the 16 digits of a UID"};
}

TagRead readFrom(const Json& json, const TagNumbers& numbers)
{
    if (!json.is_array() || json.size() < 2 || json.size() > 3)
        throw Refusal{"a read must be [tag, rssi] or [tag, rssi, time_ms]"};
    TagRead read;
    read.uid = tagFrom(json[0], numbers);
    if (!json[1].is_number_integer() || json[1] < leastRssi || json[1] > mostRssi)
        throw Refusal{"RSSI " + shown(json[1]) + " is not a whole number from 0 to 7"};
    read.rssi = json[1].get<int>();
    if (json.size() == 3) {
        if (!json[2].is_number() || !isTime_s(json[2].get<double>() * 1e-3))
            throw Refusal{"the time of a read must be a number of milliseconds"};
        read.time = Time{} + durationFromSeconds(json[2].get<double>() * 1e-3);
    }
    return read;
}

TurnStop stopFrom(const Json& json, const TagNumbers& numbers)
{
    if (!json.is_array() || json.size() > mostReadsPerStop)
        throw Refusal{"each entry of 'rows' must be a list of reads"};
    TurnStop stop;
    for (const Json& read : json)
        stop.reads.push_back(readFrom(read, numbers));
    return stop;
}

void addUnknown(TurnRecord& record, const Json& json, const TagNumbers& numbers)
{
    if (!json.is_array() || json.size() != record.stops.size())
        throw Refusal{"'unknown' must have one list of tags for each stop"};
    for (std::size_t stop = 0; stop < json.size(); ++stop) {
        if (!json[stop].is_array())
            throw Refusal{"'unknown' must have one list of tags for each stop"};
        for (const Json& tag : json[stop])
            record.stops[stop].unknownIfUnseen.push_back(tagFrom(tag, numbers));
    }
}

void addParameters(TurnRecord& record, const Json& json)
{
    if (const auto step = json.find("step_deg"); step != json.end()) {
        if (!step->is_number() || !isStep(radFromDeg(step->get<double>())))
            throw Refusal{"'step_deg' must be a number from 1 to 180"};
        record.nominalStep = radFromDeg(step->get<double>());
    }
    if (const auto time = json.find("turn_time_ms"); time != json.end()) {
        if (!time->is_null() && (!time->is_number() || !isTurnTime_s(time->get<double>() * 1e-3)))
            throw Refusal{"'turn_time_ms' must be a number over 0, or null"};
        record.turnTime_s = time->is_null() ? std::nullopt : std::optional(time->get<double>() * 1e-3);
    }
    if (const auto rotation = json.find("rotation"); rotation != json.end() && !rotation->is_null()) {
        record.rotation =
            rotation->is_string() ? parseRotation(rotation->get_ref<const std::string&>()) : std::nullopt;
        if (!record.rotation)
            throw Refusal{"'rotation' must be \"ccw\" or \"cw\""};
    }
    if (const auto kind = json.find("kind"); kind != json.end()) {
        const auto parsed =
            kind->is_string() ? parseTurnKind(kind->get_ref<const std::string&>()) : std::nullopt;
        if (!parsed)
            throw Refusal{"'kind' must be \"timed\" or \"measured\""};
        record.kind = *parsed;
    }
}

TurnRecord turnFrom(std::string_view text, const TurnFileOptions& options, const TagNumbers& numbers)
{
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw Refusal{"not a JSON object: stopped at byte " + std::to_string(error.byte)};
    } catch (const Json::exception&) {
        throw Refusal{"not a JSON object: a number is out of range"};
    }
    const auto rows = json.is_object() ? json.find("rows") : json.end();
    if (rows == json.end() || !rows->is_array() || rows->empty())
        throw Refusal{"not a turn: expected a JSON object with a list 'rows'"};
    if (rows->size() > mostStops)
        throw Refusal{"more than " + std::to_string(mostStops) + " stops"};
    TurnRecord record;
    record.nominalStep = options.nominalStep;
    record.turnTime_s = options.turnTime_s;
    for (const Json& row : *rows)
        record.stops.push_back(stopFrom(row, numbers));
    if (const auto unknown = json.find("unknown"); unknown != json.end())
        addUnknown(record, *unknown, numbers);
    addParameters(record, json);
    return record;
}

/// The clock of a written turn begins here: the reads of a file need not stand in the order of their times.
Time earliestRead(const TurnRecord& record)
{
    Time earliest = Time::max();
    for (const TurnStop& stop : record.stops) {
        for (const TagRead& read : stop.reads)
            earliest = std::min(earliest, read.time);
    }
    return earliest;
}

} // namespace

std::vector<RecordedTurn> readJsonTurns(const std::vector<TextLine>& lines, const TurnFileOptions& options)
{
    const TagNumbers numbers(options.tags);
    std::vector<RecordedTurn> turns;
    for (const TextLine& line : lines) {
        if (trimmed(line.text).empty())
            continue;
        try {
            turns.push_back({line.number, turnFrom(line.text, options, numbers)});
        } catch (const Refusal& refusal) {
            turns.push_back({line.number, std::unexpected(TurnFileProblem{line.number, refusal.reason})});
        }
    }
    return turns;
}

std::string toJsonLine(const TurnRecord& record)
{
    const Time first = earliestRead(record);
    Json rows = Json::array();
    Json unknown = Json::array();
    for (const TurnStop& stop : record.stops) {
        Json reads = Json::array();
        for (const TagRead& read : stop.reads)
            reads.push_back({fullText(read.uid), read.rssi, secondsFrom(read.time - first) * 1e3});
        rows.push_back(std::move(reads));
        Json tags = Json::array();
        for (const TagUid uid : stop.unknownIfUnseen)
            tags.push_back(fullText(uid));
        unknown.push_back(std::move(tags));
    }
    const Json json{{"rows", std::move(rows)},
                    {"unknown", std::move(unknown)},
                    {"step_deg", degFromRad(record.nominalStep)},
                    {"turn_time_ms", record.turnTime_s ? Json(*record.turnTime_s * 1e3) : Json()},
                    {"rotation", record.rotation ? Json(agv::toText(*record.rotation)) : Json()},
                    {"kind", toText(record.kind)}};
    return json.dump();
}

} // namespace agv::recording
