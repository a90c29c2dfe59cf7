// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/ids.h"
#include "core/uwb_settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace agv {

struct FloorTag {
    TagUid uid;
    Point2 position;
    int number = 0; ///< 1-based number within its field; column-major on a grid (seed, appendix A)
    friend bool operator==(const FloorTag&, const FloorTag&) = default;
};

/// One step of the RSSI-distance relation: distances in (next step's upperEdge, upperEdge] read as rssi.
struct RssiStep {
    double upperEdge = 0.0; ///< m
    int rssi = 0;           ///< 0..7
    friend bool operator==(const RssiStep&, const RssiStep&) = default;
};

/// RSSI as a step function of the distance antenna-tag, edges falling, upper edge inclusive; beyond the
/// first edge a tag is not read. The relation is not monotonic: there is a blind spot near 50 mm.
using RssiTable = std::vector<RssiStep>;

/// The table measured by the seed (chapter 6.2; exact edges from appendix A).
RssiTable seedRssiTable();

/// RSSI at a distance (m), or nothing when the tag is out of range.
std::optional<int> rssiAt(const RssiTable& table, double distance);

struct Endpoint {
    std::string host; ///< name or address
    std::uint16_t port = 0;
    friend bool operator==(const Endpoint&, const Endpoint&) = default;
};

/// "127.0.0.1:2001"
std::string toText(const Endpoint& endpoint);

/// Reads "host:port". BadInput names the part that is wrong.
Result<Endpoint> parseEndpoint(std::string_view text);

struct AgvConfig {
    RobotId id;
    std::string name;
    std::string robotHost;                  ///< address the robot connects from
    std::uint16_t robotPeerPort = 0;        ///< source port the robot connects from; 0: any (the real robots)
    Endpoint reader{"192.168.0.100", 8883}; ///< WeMos bridge of the RFID reader
    double radius_m = 0.165;
    double track_m = 0.2865;
    Point2 antenna{-0.100, 0.0};  ///< RFID antenna in the vehicle frame (x forward, y left), m
    double turnTime_s = 1.125;    ///< "sleeptime": time of a 45 degree turn at turnSpeed
    double turnSpeed_m_s = 0.100; ///< wheel speed while turning
    double maxSpeed_m_s = 0.500;
    friend bool operator==(const AgvConfig&, const AgvConfig&) = default;
};

enum class StationKind { Colour, Mixing, Storage, Charging, Other };

struct Station {
    std::string name;
    StationKind kind = StationKind::Other;
    Pose2 pose;           ///< centre and orientation
    double width_m = 0.3; ///< along the station's own x
    double depth_m = 0.3; ///< along the station's own y
    friend bool operator==(const Station&, const Station&) = default;
};

struct Obstacle {
    std::string name;
    std::vector<Point2> outline; ///< polygon, 3 points or more
    friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

struct UwbAnchor {
    int id = 0;
    std::string label;
    double x = 0.0, y = 0.0, z = 0.0; ///< m
    bool shown = true;
    friend bool operator==(const UwbAnchor&, const UwbAnchor&) = default;
};

/// Everything the console knows about the plant before anything moves.
struct PlantLayout {
    std::string name;
    Point2 origin; ///< south-west corner of the plant's rectangle; tags may lie west or south of (0, 0)
    double width_m = 0.0;     ///< along x, from the origin
    double height_m = 0.0;    ///< along y, from the origin
    double tagRadius_m = 0.0; ///< drawn size of a floor tag
    std::vector<FloorTag> floorTags;
    std::vector<Station> stations;
    std::vector<Obstacle> obstacles;
    std::vector<AgvConfig> agvs;
    RssiTable rssiTable = seedRssiTable();
    std::vector<UwbAnchor> anchors; ///< with none UWB is not used
    UwbSettings uwb;
    Endpoint robotListen{"127.0.0.1", 2001};
    std::uint16_t telemetryPort = 2000; ///< UDP, same address as robotListen
    friend bool operator==(const PlantLayout&, const PlantLayout&) = default;

    const AgvConfig* findAgv(RobotId id) const;
};

/// Position of each tag by its UID.
using TagMap = std::unordered_map<TagUid, Point2>;
TagMap tagMapOf(const PlantLayout& plant);

/// Tags on a rectangular grid, numbered column by column as in the seed: number = 1 + column * rows + row,
/// UID = firstUid + number - 1. `pitch` and `origin` in m.
std::vector<FloorTag> tagGrid(int columns, int rows, double pitch, Point2 origin, TagUid firstUid);

} // namespace agv
