// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_file_writer.h"

#include "core/file_units.h"
#include "core/floor_tags_reader.h"
#include "core/ip_address.h"
#include "core/json_merge.h"
#include "core/plant_file_reader.h"
#include "core/uwb_section_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace agv {
namespace {

Json mm(double m) { return toThousandths(m); }

Json point(Point2 p) { return Json::array({mm(p.x), mm(p.y)}); }

const char* wordFor(StationKind kind)
{
    return std::find_if(stationKinds.begin(), stationKinds.end(),
                        [=](const auto& pair) { return pair.first == kind; })
        ->second;
}

template<typename Items, typename ToJson>
Json list(const Items& items, ToJson toJson)
{
    Json array = Json::array();
    for (const auto& item : items)
        array.push_back(toJson(item));
    return array;
}

Json toJson(const FloorTag& tag)
{
    return {{"uid", fullText(tag.uid)},
            {"x_mm", mm(tag.position.x)},
            {"y_mm", mm(tag.position.y)},
            {"number", tag.number}};
}

Json toJson(const TagGridSpec& grid)
{
    return {{"columns", grid.columns},
            {"rows", grid.rows},
            {"pitch_mm", mm(grid.pitch_m)},
            {"origin_mm", point(grid.origin)},
            {"first_uid", fullText(grid.firstUid)}};
}

Json toJson(const Station& station)
{
    return {{"name", station.name},
            {"kind", wordFor(station.kind)},
            {"x_mm", mm(station.pose.position.x)},
            {"y_mm", mm(station.pose.position.y)},
            {"heading_deg", toDegrees(station.pose.heading)},
            {"width_mm", mm(station.width_m)},
            {"depth_mm", mm(station.depth_m)}};
}

Json toJson(const Obstacle& obstacle)
{
    return {{"name", obstacle.name}, {"outline_mm", list(obstacle.outline, point)}};
}

Json toJson(const AgvConfig& agv)
{
    return {{"id", agv.id.number},
            {"name", agv.name},
            {"robot_host", agv.robotHost},
            {"robot_port", agv.robotPeerPort},
            {"reader", toText(agv.reader)},
            {"radius_mm", mm(agv.radius_m)},
            {"track_mm", mm(agv.track_m)},
            {"antenna_along_mm", mm(agv.antenna.x)},
            {"antenna_across_mm", mm(agv.antenna.y)},
            {"sleeptime_ms", toThousandths(agv.turnTime_s)},
            {"turn_speed_mm_s", toThousandths(agv.turnSpeed_m_s)},
            {"max_speed_mm_s", toThousandths(agv.maxSpeed_m_s)}};
}

Json toJson(const RssiStep& step) { return {{"upper_edge_mm", mm(step.upperEdge)}, {"rssi", step.rssi}}; }

Json toJson(const UwbAnchor& anchor)
{
    return {{"id", anchor.id},      {"label", anchor.label}, {"x_mm", mm(anchor.x)},
            {"y_mm", mm(anchor.y)}, {"z_mm", mm(anchor.z)},  {"shown", anchor.shown}};
}

Json toJson(const UwbTag& tag)
{
    return {{"id", tag.id},        {"label", tag.label},          {"agv", tag.agv ? tag.agv->number : 0},
            {"z_mm", mm(tag.z_m)}, {"along_mm", mm(tag.mount.x)}, {"across_mm", mm(tag.mount.y)}};
}

Json toJson(const RangeCorrection& correction)
{
    return {{"anchor", correction.anchor}, {"tag", correction.tag}, {"offset_mm", mm(correction.offset_m)}};
}

Json toJson(const UwbSettings& uwb)
{
    return {{"port", uwb.port.path},
            {"usb_id", uwb.port.usb ? toText(*uwb.port.usb) : std::string()},
            {"serial_number", uwb.port.serialNumber},
            {"dialect", uwb.dialect ? std::string(toText(*uwb.dialect)) : std::string(detectedDialect)},
            {"tag_height_mm", mm(uwb.tagHeight_m)},
            {"tags", list(uwb.tags, [](const UwbTag& tag) { return toJson(tag); })},
            {"corrections",
             list(uwb.corrections, [](const RangeCorrection& correction) { return toJson(correction); })}};
}

/// The grid that makes exactly the first tags, found from the tags alone.
std::optional<TagGridSpec> detectGrid(const std::vector<FloorTag>& tags)
{
    if (tags.size() < 4)
        return std::nullopt;
    const auto columnEnd = std::find_if(tags.begin(), tags.end(), [&](const FloorTag& tag) {
        return tag.position.x != tags.front().position.x;
    });
    const auto rows = columnEnd - tags.begin();
    if (rows < 2 || rows > 10'000)
        return std::nullopt;
    const double step = tags[1].position.y - tags[0].position.y;
    const double wholeMicrometres = std::round(step * 1e6) / 1e6;
    for (const double pitch : {step, wholeMicrometres}) {
        const auto columns = static_cast<int>(tags.size() / static_cast<std::size_t>(rows));
        const TagGridSpec grid{columns, static_cast<int>(rows), pitch, tags[0].position, tags[0].uid};
        if (expand(grid) == tags)
            return grid;
    }
    return std::nullopt;
}

bool startsWith(const std::vector<FloorTag>& tags, const std::vector<FloorTag>& start)
{
    return tags.size() >= start.size() && std::equal(start.begin(), start.end(), tags.begin());
}

Json floorTagsToJson(const PlantLayout& plant, const Json* original)
{
    Json json{{"radius_mm", mm(plant.tagRadius_m)}};
    auto grid = original == nullptr ? detectGrid(plant.floorTags) : gridOf(*original);
    std::size_t fromGrid = 0;
    if (grid) {
        const auto tags = expand(*grid);
        if (startsWith(plant.floorTags, tags)) {
            json["grid"] = toJson(*grid);
            fromGrid = tags.size();
        }
    }
    Json rest = Json::array();
    for (std::size_t i = fromGrid; i < plant.floorTags.size(); ++i)
        rest.push_back(toJson(plant.floorTags[i]));
    if (!rest.empty() || fromGrid == 0)
        json["list"] = std::move(rest);
    return json;
}

Json toJson(const PlantLayout& plant, const Json* original)
{
    const auto each = [](const auto& item) { return toJson(item); };
    return {{"format", plantFormat},
            {"version", plantVersion},
            {"name", plant.name},
            {"size",
             {{"origin_mm", point(plant.origin)},
              {"width_mm", mm(plant.width_m)},
              {"height_mm", mm(plant.height_m)}}},
            {"floor_tags", floorTagsToJson(plant, original)},
            {"stations", list(plant.stations, each)},
            {"obstacles", list(plant.obstacles, each)},
            {"agvs", list(plant.agvs, each)},
            {"rssi_table", list(plant.rssiTable, each)},
            {"anchors", list(plant.anchors, each)},
            {"uwb", toJson(plant.uwb)},
            {"listen", {{"robots", toText(plant.robotListen)}, {"telemetry_port", plant.telemetryPort}}}};
}

std::string numberIdentity(const Json& element)
{
    return element.contains("id") ? std::to_string(element["id"].get<long long>()) : "";
}

std::string correctionIdentity(const Json& element)
{
    return std::to_string(element["anchor"].get<int>()) + " " + std::to_string(element["tag"].get<int>());
}

std::string nameIdentity(const Json& element)
{
    const auto name = element.find("name");
    return name == element.end() ? "" : name->get<std::string>();
}

std::string uidIdentity(const Json& element)
{
    return fullText(parseTagUid(element["uid"].get_ref<const std::string&>()).value_or(TagUid{}));
}

Json defaultAgv(const Json& fresh, const std::string& console)
{
    AgvConfig agv;
    agv.name = "AGV " + numberIdentity(fresh);
    const auto robotHost = usualRobotHost(console, fresh["id"].get<int>());
    agv.robotHost = robotHost.value_or("");
    Json json = toJson(agv);
    if (!robotHost)
        json.erase("robot_host"); // has no default then
    return json;
}

Json defaultAnchor(const Json& fresh, std::size_t)
{
    UwbAnchor anchor;
    anchor.label = "A" + numberIdentity(fresh);
    Json json = toJson(anchor);
    for (const char* const required : {"id", "x_mm", "y_mm"})
        json.erase(required);
    return json;
}

Json defaultUwbTag(const Json& fresh, double height_m)
{
    UwbTag tag;
    tag.label = "T" + numberIdentity(fresh);
    tag.z_m = height_m;
    Json json = toJson(tag);
    json.erase("id"); // has no default
    return json;
}

Json defaultStation(const Json&, std::size_t)
{
    Json json = toJson(Station{});
    for (const char* const required : {"x_mm", "y_mm"})
        json.erase(required);
    return json;
}

/// Every list section in the shape of the original's.
void mergeLists(const Json& original, Json& fresh, std::size_t gridTags, const PlantLayout& layout)
{
    const auto merge = [&](const char* pointer, const IdentityOf& identity, const DefaultsOf& defaults) {
        const Json::json_pointer place(pointer);
        if (original.contains(place) && fresh.contains(place))
            fresh[place] = mergedList(original[place], fresh[place], identity, defaults);
    };
    const auto none = [](const Json&, std::size_t) { return Json::object(); };
    const auto unnamed = [](const Json&, std::size_t) { return Json{{"name", ""}}; };
    merge("/floor_tags/list", uidIdentity,
          [=](const Json&, std::size_t index) { return Json{{"number", gridTags + index + 1}}; });
    merge("/stations", nameIdentity, defaultStation);
    merge("/obstacles", nameIdentity, unnamed);
    merge("/agvs", numberIdentity,
          [&](const Json& agv, std::size_t) { return defaultAgv(agv, layout.robotListen.host); });
    merge("/rssi_table", [](const Json&) { return std::string(); }, none);
    merge("/anchors", numberIdentity, defaultAnchor);
    merge("/uwb/tags", numberIdentity,
          [&](const Json& tag, std::size_t) { return defaultUwbTag(tag, layout.uwb.tagHeight_m); });
    merge("/uwb/corrections", correctionIdentity, none);
}

/// The parts of "floor_tags" that the fresh tree no longer has; they are not unknown keys.
Json withoutStaleTags(Json original, const Json& fresh)
{
    for (const char* const key : {"grid", "list"}) {
        if (original.contains("floor_tags") && !fresh["floor_tags"].contains(key))
            original["floor_tags"].erase(key);
    }
    return original;
}

} // namespace

Json plantTree(const PlantLayout& layout, const Json* original)
{
    Json fresh = toJson(layout, original);
    if (original == nullptr)
        return fresh;
    const std::size_t listTags =
        fresh["floor_tags"].contains("list") ? fresh["floor_tags"]["list"].size() : 0;
    mergeLists(*original, fresh, layout.floorTags.size() - listTags, layout);
    Json defaults = toJson(PlantLayout{}, nullptr);
    defaults.erase("size"); // has no default
    defaults["size"] = {{"origin_mm", point({})}};
    return mergedObject(withoutStaleTags(*original, fresh), fresh, defaults);
}

} // namespace agv
