// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/scenes.h"

#include <algorithm>
#include <cmath>

namespace agv::scenes {
namespace {

constexpr double reach_m = 0.14;

std::vector<FloorTag> tagsNear(const PlantLayout& plant, Point2 p)
{
    std::vector<FloorTag> near;
    std::copy_if(plant.floorTags.begin(), plant.floorTags.end(), std::back_inserter(near),
                 [&](const FloorTag& tag) { return distance(tag.position, p) <= reach_m; });
    return near;
}

Point2 antennaAt(const TurnEstimate& estimate, double bearing)
{
    return estimate.pose.position +
           Point2{estimate.radius_m * std::cos(bearing), estimate.radius_m * std::sin(bearing)};
}

void addStops(TurnEstimate& estimate, int count)
{
    const PlantLayout plant = wholePlant();
    for (int i = 0; i < count; ++i) {
        StopReport stop;
        stop.antennaBearing = estimate.startPose.heading + radFromDeg(180.0) + i * estimate.step;
        stop.antenna = antennaAt(estimate, stop.antennaBearing);
        stop.antennaSd_m = 0.003;
        for (const FloorTag& tag : tagsNear(plant, stop.antenna)) {
            stop.expected.push_back(tag.uid);
            stop.seen.push_back(tag.uid);
        }
        estimate.stops.push_back(stop);
    }
    estimate.pose.heading = wrapAngle(estimate.startPose.heading + (count - 1) * estimate.step);
}

std::vector<StopRow> tableOf(const TurnEstimate& estimate)
{
    const PlantLayout plant = wholePlant();
    std::vector<StopRow> rows;
    for (std::size_t i = 0; i < estimate.stops.size(); ++i) {
        StopRow row{static_cast<int>(i + 1), {}, 0, true};
        for (const FloorTag& tag : tagsNear(plant, estimate.stops[i].antenna)) {
            const int rssi =
                rssiAt(plant.rssiTable, distance(tag.position, estimate.stops[i].antenna)).value_or(0);
            row.tags.emplace_back(tag.uid, rssi);
            row.reads += 5;
        }
        rows.push_back(row);
    }
    return rows;
}

LinkSnapshot link(std::string name, std::string address, LinkState state)
{
    LinkSnapshot link{std::move(name), std::move(address), state, {}, 0.0, {}, 0, 0, {}, {}};
    if (state == LinkState::Up) {
        link.messagesPerSecond = 21.4;
        link.dataAge_s = 0.1;
        link.received = 18234;
        link.dropped = 4;
        link.dropDetail = "3 incomplete, 1 garbled";
    }
    return link;
}

PlantSnapshot withLinks(LinkState state)
{
    PlantSnapshot snapshot;
    snapshot.listening = "127.0.0.1:2001 (TCP), 2000 (UDP)";
    for (int i = 1; i <= 4; ++i) {
        const std::string number = std::to_string(i);
        AgvSnapshot agv;
        agv.id = {i};
        agv.name = "AGV " + number;
        agv.readerLink = link("RFID reader " + number, "192.168.0.10" + number + ":8883", state);
        agv.robotLink = link("Robot " + number, "192.168.1.20" + number, state);
        if (state == LinkState::Up) {
            agv.robotLink.messagesPerSecond = 10.0;
            agv.battery = BatteryStatus{
                ChargingState::NotCharging, 15.9 - 0.4 * i, -0.8, 27, 2.6 - 0.55 * i, 2.7, false, false};
            agv.robotState = RobotState::Idle;
        }
        snapshot.agvs.push_back(agv);
    }
    return snapshot;
}

} // namespace

PlantLayout wholePlant()
{
    PlantLayout plant;
    plant.name = "Pipeless plant";
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    plant.tagRadius_m = 0.015;
    plant.floorTags = tagGrid(31, 41, 0.1, {0.0, 0.0}, {0xE00401503B000001});
    const double west = radFromDeg(-90.0);
    plant.stations = {{"Colour 1", StationKind::Colour, {{0.15, 2.9}, west}, 0.4, 0.3},
                      {"Colour 2", StationKind::Colour, {{0.15, 1.7}, west}, 0.4, 0.3},
                      {"Mixing", StationKind::Mixing, {{2.85, 2.9}, -west}, 0.6, 0.3},
                      {"Storage", StationKind::Storage, {{2.85, 1.5}, -west}, 0.8, 0.3},
                      {"Dock 1", StationKind::Charging, {{0.6, 3.9}, 0.0}, 0.34, 0.2},
                      {"Dock 2", StationKind::Charging, {{1.2, 3.9}, 0.0}, 0.34, 0.2},
                      {"Dock 3", StationKind::Charging, {{1.8, 3.9}, 0.0}, 0.34, 0.2},
                      {"Dock 4", StationKind::Charging, {{2.4, 3.9}, 0.0}, 0.34, 0.2}};
    plant.obstacles = {{"Pillar", {{1.95, 2.2}, {2.15, 2.2}, {2.15, 2.4}, {1.95, 2.4}}}};
    for (int i = 1; i <= 4; ++i) {
        AgvConfig agv;
        agv.id = {i};
        agv.name = "AGV " + std::to_string(i);
        plant.agvs.push_back(agv);
    }
    return plant;
}

std::shared_ptr<TurnEstimate> goodEstimate()
{
    auto estimate = std::make_shared<TurnEstimate>();
    estimate->valid = true;
    estimate->status = "ok";
    estimate->radius_m = 0.100;
    estimate->step = radFromDeg(43.1);
    estimate->stepSd = radFromDeg(0.2);
    estimate->startPose = {{1.204, 0.873}, radFromDeg(92.3 - 8 * 43.1)};
    estimate->pose.position = estimate->startPose.position;
    estimate->covariance = {1.2e-6, 4e-7, 0.0, 4e-7, 8e-7, 0.0, 0.0, 0.0, 3e-4};
    estimate->lastHeadingSd = radFromDeg(0.9);
    estimate->suggestedTurnTime_s = 1.125 * 45.0 / 43.1;
    estimate->suggestedTurnTimeSd_s = 0.005;
    addStops(*estimate, 9);
    return estimate;
}

PlantSnapshot idle()
{
    PlantSnapshot snapshot = withLinks(LinkState::Down);
    snapshot.simulated = true;
    return snapshot;
}

PlantSnapshot linksUp() { return withLinks(LinkState::Up); }

PlantSnapshot turning()
{
    PlantSnapshot snapshot = linksUp();
    AgvSnapshot& agv = snapshot.agvs[0];
    auto preview = std::make_shared<TurnEstimate>(*goodEstimate());
    preview->stops.resize(4);
    preview->pose.heading = wrapAngle(preview->startPose.heading + 3 * preview->step);
    for (double& c : preview->covariance)
        c *= 40.0;
    preview->lastHeadingSd = radFromDeg(4.0);
    agv.turn.phase = TurnPhase::Reading;
    agv.turn.stop = 4;
    agv.turn.stopCount = 9;
    agv.turn.progress = 0.39;
    agv.turn.timeLeft_s = 9.4;
    agv.turn.table = tableOf(*preview);
    agv.turn.table.back().done = false;
    agv.turn.preview = preview;
    agv.robotState = RobotState::DirectDriving;
    for (TagUid uid : preview->stops.back().seen)
        agv.recentReads.push_back({snapshot.time, uid, 3});
    snapshot.simulated = true;
    return snapshot;
}

PlantSnapshot finished()
{
    PlantSnapshot snapshot = linksUp();
    AgvSnapshot& agv = snapshot.agvs[0];
    const auto result = goodEstimate();
    agv.turn.phase = TurnPhase::Finished;
    agv.turn.stop = agv.turn.stopCount = 9;
    agv.turn.progress = 1.0;
    agv.turn.table = tableOf(*result);
    agv.turn.result = result;
    agv.pose = result->pose;
    agv.covariance = result->covariance;
    for (TagUid uid : result->stops.back().seen)
        agv.recentReads.push_back({snapshot.time, uid, 3});
    snapshot.agvs[1].pose = Pose2{{2.21, 3.05}, radFromDeg(-31.0)};
    snapshot.agvs[2].pose = Pose2{{0.74, 2.38}, radFromDeg(178.0)};
    return snapshot;
}

PlantSnapshot ambiguous()
{
    PlantSnapshot snapshot = finished();
    AgvSnapshot& agv = snapshot.agvs[0];
    auto result = std::make_shared<TurnEstimate>(*agv.turn.result);
    result->flags = {TurnFlag::Weak, TurnFlag::Ambiguous};
    for (double& c : result->covariance)
        c *= 400.0;
    result->lastHeadingSd = radFromDeg(7.0);
    result->alternative = AlternativePose{{{1.304, 0.947}, radFromDeg(-64.0)}, 1.3};
    StopReport& bad = result->stops[4];
    bad.missed.assign(bad.seen.begin(), bad.seen.begin() + 2);
    bad.seen.erase(bad.seen.begin(), bad.seen.begin() + 2);
    result->stops[6].unknown.push_back({0xE00401503A5BDAE4});
    agv.turn.result = result;
    snapshot.refusedPeers = {"192.168.1.77:50122"};
    return snapshot;
}

PlantSnapshot linkLost()
{
    PlantSnapshot snapshot = finished();
    AgvSnapshot& agv = snapshot.agvs[0];
    agv.turn = TurnSnapshot{};
    agv.turn.phase = TurnPhase::Aborted;
    agv.turn.stop = 5;
    agv.turn.stopCount = 9;
    agv.turn.progress = 0.5;
    agv.turn.message = "The connection to the robot was lost at stop 5. Check its power and the Wi-Fi.";
    agv.mayBeMoving = true;
    agv.robotLink.state = LinkState::Waiting;
    agv.robotLink.retryIn_s = 2.0;
    agv.robotLink.dataAge_s = 6.3;
    agv.robotLink.reason = "The robot closed the connection. Waiting for it to connect again.";
    agv.readerLink.state = LinkState::Silent;
    agv.readerLink.dataAge_s = 5.8;
    agv.readerLink.reason = "Connected, but no line for 5 s. Check the reader's power.";
    snapshot.agvs[3].readerLink.state = LinkState::Failed;
    snapshot.agvs[3].readerLink.reason = "The address is not known. Correct it in the plant file.";
    return snapshot;
}

} // namespace agv::scenes
