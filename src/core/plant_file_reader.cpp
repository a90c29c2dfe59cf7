// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plant_file_reader.h"

#include "core/floor_tags_reader.h"
#include "core/ip_address.h"
#include "core/plant_file_parts.h"
#include "core/turn.h"
#include "core/units.h"
#include "core/uwb_section_reader.h"

#include <algorithm>
#include <limits>
#include <map>

namespace agv {
namespace {

// In the units of the file; docs/plant-file.md lists them.
constexpr NumberRange sizeRange{100, 1e6};
constexpr NumberRange stationSizeRange{1, 100'000};
constexpr NumberRange radiusRange{10, 2000};
constexpr NumberRange trackRange{50, 2000};
constexpr NumberRange antennaRange{-2000, 2000};
constexpr NumberRange sleeptimeRange{leastSleeptime_ms, mostSleeptime_ms};
constexpr NumberRange turnSpeedRange{mmFromMetres(leastTurnSpeed), mmFromMetres(mostTurnSpeed)};
constexpr NumberRange speedRange{1, 500}; // of the robot link's directDrive
constexpr NumberRange edgeRange{0.1, 10'000};

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

/// Host and port of "host:port".
Endpoint readEndpoint(JsonFields& fields, std::string_view key, const Endpoint& fallback, int leastPort)
{
    const Json* const json = fields.find(key);
    if (json == nullptr)
        return fallback;
    const auto endpoint = json->is_string() ? parseEndpoint(json->get_ref<const std::string&>())
                                            : failure(ErrorCode::BadInput, {});
    if (endpoint && endpoint->port >= leastPort)
        return *endpoint;
    fields.error(key, "must be \"address:port\" with a port from " + std::to_string(leastPort) +
                          " to 65535, such as " + quoted(toText(fallback)) + " (is " + describe(*json) + ")");
    return fallback;
}

class PlantReader {
public:
    PlantReader(const Json& root, JsonFindings& findings) : m_root(root), m_findings(findings) {}

    PlantLayout read()
    {
        JsonFields fields(m_root, "", m_findings);
        if (!readHeader(fields))
            return m_plant;
        m_plant.name = fields.text("name", m_plant.name);
        readSize(fields);
        readListen(fields); // before the AGVs: the usual addresses of robots follow from it
        FloorTagReader(m_area, m_findings).read(fields, m_plant);
        readEach(fields, "stations", m_findings, [this](JsonFields& item) { readStation(item); });
        readEach(fields, "obstacles", m_findings, [this](JsonFields& item) { readObstacle(item); });
        readEach(fields, "agvs", m_findings, [this](JsonFields& item) { readAgv(item); });
        readRssiTable(fields);
        readEach(fields, "anchors", m_findings, [this](JsonFields& item) { readAnchor(item); });
        UwbSectionReader(m_findings).read(fields, m_plant);
        fields.finish();
        return std::move(m_plant);
    }

private:
    /// False when the rest cannot be understood.
    bool readHeader(JsonFields& fields)
    {
        if (!m_root.is_object())
            return false;
        const Json* const format =
            fields.find("format", "\"format\": \"agv-plant\"; without it this is no plant file");
        if (format == nullptr)
            return false;
        if (*format != plantFormat) {
            fields.error("format",
                         "must be \"agv-plant\" (is " + describe(*format) + "); this is no plant file");
            return false;
        }
        const int version = fields.integer("version", 1, std::numeric_limits<int>::max(), std::nullopt);
        if (!m_findings.errors.empty())
            return false;
        if (version > plantVersion) {
            fields.error("version", "the file has version " + std::to_string(version) +
                                        " and was made by a newer console; this one reads version " +
                                        std::to_string(plantVersion) + ". Update the console");
            return false;
        }
        return true;
    }

    /// Remembers where a name, number or address was first used.
    template<typename Value>
    void requireNew(std::map<Value, std::string>& used, const Value& value, const std::string& pointer,
                    const std::string& what)
    {
        const auto [first, isNew] = used.emplace(value, pointer);
        if (!isNew)
            m_findings.errors.push_back({pointer, what + " is already used by " + first->second});
    }

    void readSize(JsonFields& parent)
    {
        const Json* const json = parent.find("size", "\"size\": {\"width_mm\": 3000, \"height_mm\": 4000}");
        if (json == nullptr)
            return;
        JsonFields size(*json, parent.pointerTo("size"), m_findings);
        const std::size_t before = m_findings.errors.size();
        m_plant.origin = readPoint(size, "origin_mm");
        m_plant.width_m = size.thousandths("width_mm", sizeRange, std::nullopt);
        m_plant.height_m = size.thousandths("height_mm", sizeRange, std::nullopt);
        if (before == m_findings.errors.size())
            m_area = {m_plant.origin, m_plant.width_m, m_plant.height_m};
        size.finish();
    }

    void readStation(JsonFields& fields)
    {
        Station station;
        station.name = fields.text("name", station.name);
        station.kind = readKind(fields);
        const std::size_t before = m_findings.errors.size();
        station.pose.position = readPosition(fields);
        if (m_findings.errors.size() == before)
            m_area.requireInside(station.pose.position, fields.pointer(), "the station", m_findings);
        station.pose.heading = fields.degrees("heading_deg", station.pose.heading);
        station.width_m = fields.thousandths("width_mm", stationSizeRange, station.width_m);
        station.depth_m = fields.thousandths("depth_mm", stationSizeRange, station.depth_m);
        m_plant.stations.push_back(std::move(station));
    }

    StationKind readKind(JsonFields& fields)
    {
        const std::string word = fields.text("kind", "other");
        const auto found = std::find_if(stationKinds.begin(), stationKinds.end(),
                                        [&](const auto& kind) { return word == kind.second; });
        if (found != stationKinds.end())
            return found->first;
        fields.error("kind", "must be \"colour\", \"mixing\", \"storage\", \"charging\" or \"other\" (is " +
                                 describe(*fields.find("kind")) + ")");
        return StationKind::Other;
    }

    void readObstacle(JsonFields& fields)
    {
        Obstacle obstacle;
        obstacle.name = fields.text("name", obstacle.name);
        const Json* const outline =
            fields.find("outline_mm", "the corners of the polygon: \"outline_mm\": [[x, y], [x, y], [x, y]]");
        if (outline != nullptr && (!outline->is_array() || outline->size() < 3)) {
            const std::string is = outline->is_array() ? std::to_string(outline->size()) : describe(*outline);
            fields.error("outline_mm", "must have 3 points [x, y] or more (is " + is + ")");
        } else if (outline != nullptr) {
            for (std::size_t i = 0; i < outline->size(); ++i)
                obstacle.outline.push_back(readPoint(
                    (*outline)[i], fields.pointerTo("outline_mm") + "/" + std::to_string(i), m_findings));
        }
        m_plant.obstacles.push_back(std::move(obstacle));
    }

    void readAgv(JsonFields& fields)
    {
        AgvConfig agv;
        agv.id.number = fields.integer("id", 1, highestAgv, std::nullopt);
        agv.name = fields.text("name", "AGV " + std::to_string(agv.id.number));
        agv.robotHost = fields.text("robot_host", usualRobotHost(m_plant.robotListen.host, agv.id.number));
        agv.robotPeerPort =
            static_cast<std::uint16_t>(fields.integer("robot_port", 0, 65535, agv.robotPeerPort));
        agv.reader = readEndpoint(fields, "reader", agv.reader, 1);
        agv.radius_m = fields.thousandths("radius_mm", radiusRange, agv.radius_m);
        agv.track_m = fields.thousandths("track_mm", trackRange, agv.track_m);
        agv.antenna.x = fields.thousandths("antenna_along_mm", antennaRange, agv.antenna.x);
        agv.antenna.y = fields.thousandths("antenna_across_mm", antennaRange, agv.antenna.y);
        agv.turnTime_s = fields.thousandths("sleeptime_ms", sleeptimeRange, agv.turnTime_s);
        agv.turnSpeed_m_s = fields.thousandths("turn_speed_mm_s", turnSpeedRange, agv.turnSpeed_m_s);
        agv.maxSpeed_m_s = fields.thousandths("max_speed_mm_s", speedRange, agv.maxSpeed_m_s);
        if (m_findings.errors.empty())
            checkAgv(agv, fields);
        m_plant.agvs.push_back(std::move(agv));
    }

    void checkAgv(const AgvConfig& agv, JsonFields& fields)
    {
        if (!isIpAddress(agv.robotHost))
            fields.error("robot_host", "must be the address the robot connects from, in numbers such as "
                                       "\"192.168.1.2\" (is " +
                                           describe(*fields.find("robot_host")) + ")");
        requireNew(m_usedAgvs, agv.id.number, fields.pointerTo("id"),
                   "AGV number " + std::to_string(agv.id.number));
        requireNew(m_usedReaders, toText(agv.reader), fields.pointerTo("reader"),
                   "the reader address " + toText(agv.reader));
        for (std::size_t i = 0; i < m_plant.agvs.size(); ++i) {
            const AgvConfig& other = m_plant.agvs[i];
            const bool samePort = agv.robotPeerPort == other.robotPeerPort || agv.robotPeerPort == 0 ||
                                  other.robotPeerPort == 0;
            if (agv.robotHost == other.robotHost && samePort)
                fields.error("robot_host",
                             "the robot address " + agv.robotHost + " is already used by /agvs/" +
                                 std::to_string(i) +
                                 "/robot_host; the console could not tell the two robots apart");
        }
        if (agv.turnSpeed_m_s > agv.maxSpeed_m_s)
            fields.error(fields.has("turn_speed_mm_s") ? "turn_speed_mm_s" : "max_speed_mm_s",
                         "the turn speed must not be above the greatest speed");
    }

    void readRssiTable(JsonFields& parent)
    {
        const Json* const json = parent.array("rssi_table");
        if (json == nullptr)
            return;
        if (json->empty())
            parent.error("rssi_table",
                         "must have one step or more; leave the key out for the built-in table");
        m_plant.rssiTable.clear();
        readEach(parent, "rssi_table", m_findings, [this](JsonFields& fields) {
            RssiStep step;
            const std::size_t before = m_findings.errors.size();
            step.upperEdge = fields.thousandths("upper_edge_mm", edgeRange, std::nullopt);
            step.rssi = fields.integer("rssi", 0, 7, std::nullopt);
            const bool isKnown = m_findings.errors.size() == before;
            if (isKnown && !m_plant.rssiTable.empty() && step.upperEdge >= m_plant.rssiTable.back().upperEdge)
                fields.error("upper_edge_mm",
                             "must be below the edge before it; the steps go from far to near");
            m_plant.rssiTable.push_back(step);
        });
    }

    void readAnchor(JsonFields& fields)
    {
        UwbAnchor anchor;
        anchor.id = fields.integer("id", 0, 255, std::nullopt);
        anchor.label = fields.text("label", "A" + std::to_string(anchor.id));
        const Point2 position = readPosition(fields);
        anchor.x = position.x;
        anchor.y = position.y;
        anchor.z = fields.thousandths("z_mm", coordinateRange, anchor.z);
        anchor.shown = fields.boolean("shown", anchor.shown);
        requireNew(m_usedAnchors, anchor.id, fields.pointerTo("id"),
                   "anchor number " + std::to_string(anchor.id));
        m_plant.anchors.push_back(std::move(anchor));
    }

    void readListen(JsonFields& parent)
    {
        const Json* const json = parent.object("listen");
        if (json == nullptr)
            return;
        JsonFields fields(*json, parent.pointerTo("listen"), m_findings);
        m_plant.robotListen = readEndpoint(fields, "robots", m_plant.robotListen, 0);
        if (!isIpAddress(m_plant.robotListen.host))
            fields.error("robots", "must begin with an address of this computer in numbers, such as "
                                   "127.0.0.1, or 0.0.0.0 for all (is " +
                                       describe(*fields.find("robots")) + ")");
        m_plant.telemetryPort =
            static_cast<std::uint16_t>(fields.integer("telemetry_port", 0, 65535, m_plant.telemetryPort));
        fields.finish();
    }

    const Json& m_root;
    JsonFindings& m_findings;
    PlantLayout m_plant;
    PlantArea m_area;
    std::map<int, std::string> m_usedAgvs;
    std::map<int, std::string> m_usedAnchors;
    std::map<std::string, std::string> m_usedReaders;
};

} // namespace

PlantLayout readPlant(const Json& root, JsonFindings& findings) { return PlantReader(root, findings).read(); }

} // namespace agv
