// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant.h"

#include "simulation/start_poses.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace agv::simulation {
namespace {

// Streams split off the plant's seed; robot i uses firstRobot + 2 i and the next one.
enum Stream : std::uint64_t { Poses, Floor, Faults, FirstRobot = 16 };

} // namespace

Result<Plant> Plant::create(PlantLayout layout, const PlantSettings& settings, Time start)
{
    const SplitMix64 random(settings.seed);
    SplitMix64 poseRandom = random.split(Stream::Poses);
    auto poses = randomStartPoses(layout, poseRandom);
    if (!poses)
        return std::unexpected(poses.error());
    return Plant(std::move(layout), settings, *poses, random, start);
}

Plant::Plant(PlantLayout layout, const PlantSettings& settings, const std::vector<Pose2>& poses,
             SplitMix64 random, Time start)
    : m_layout(std::move(layout)),
      m_collisions(m_layout),
      m_floor(m_layout.floorTags, settings.reader.tagErrorSd_m, random.split(Stream::Floor)),
      m_random(random.split(Stream::Faults)),
      m_start(start),
      m_now(start)
{
    for (std::size_t i = 0; i < m_layout.agvs.size(); ++i) {
        const AgvConfig& config = m_layout.agvs[i];
        SplitMix64 own = random.split(Stream::FirstRobot + 2 * i);
        const Point2 error{settings.reader.antennaErrorSd_m * own.normal(),
                           settings.reader.antennaErrorSd_m * own.normal()};
        m_agvs.push_back({Robot(config, settings, poses[i], own.split(0)),
                          RfidReader(settings.reader, m_layout.rssiTable,
                                     random.split(Stream::FirstRobot + 2 * i + 1), start),
                          config.antenna + error});
    }
}

void Plant::advance(Time now)
{
    while (m_now + step <= now)
        stepOnce();
}

void Plant::stepOnce()
{
    m_now += step;
    for (std::size_t i = 0; i < m_agvs.size(); ++i) {
        Agv& agv = m_agvs[i];
        agv.robot.step(secondsFrom(step), m_now - m_start, m_layout,
                       [this, i](Point2 centre) { return clearance(i, centre); });
        agv.reader.step(m_now, fromVehicleFrame(agv.robot.pose(), agv.antenna + agv.shift), m_floor);
    }
}

double Plant::clearance(std::size_t self, Point2 centre) const
{
    const double radius = m_layout.agvs[self].radius_m;
    double nearest = m_collisions.clearance(centre, radius);
    for (std::size_t i = 0; i < m_agvs.size(); ++i)
        if (i != self)
            nearest = std::min(nearest, distance(centre, m_agvs[i].robot.pose().position) - radius -
                                            m_layout.agvs[i].radius_m);
    return nearest;
}

Plant::Agv* Plant::find(RobotId robot)
{
    const auto found =
        std::ranges::find_if(m_agvs, [=](const Agv& agv) { return agv.robot.config().id == robot; });
    return found == m_agvs.end() ? nullptr : &*found;
}

void Plant::receive(RobotId robot, std::span<const std::uint8_t> bytes)
{
    if (Agv* agv = find(robot))
        agv->robot.receive(bytes);
}

void Plant::consoleConnected(RobotId robot)
{
    if (Agv* agv = find(robot))
        agv->robot.consoleConnected();
}

protocol::Bytes Plant::takeRobotFrames(RobotId robot)
{
    Agv* agv = find(robot);
    return agv ? agv->robot.takeFrames() : protocol::Bytes{};
}

std::vector<protocol::Bytes> Plant::takeRobotDatagrams(RobotId robot)
{
    Agv* agv = find(robot);
    return agv ? agv->robot.takeDatagrams() : std::vector<protocol::Bytes>{};
}

std::string Plant::takeReaderBytes(RobotId robot)
{
    Agv* agv = find(robot);
    return agv ? agv->reader.takeBytes() : std::string{};
}

bool Plant::takeBump(RobotId robot)
{
    Agv* agv = find(robot);
    return agv && agv->robot.takeBump();
}

RobotTruth Plant::truthOf(const Agv& agv)
{
    const Robot& robot = agv.robot;
    return {robot.config().id, robot.pose(),      fromVehicleFrame(robot.pose(), agv.antenna + agv.shift),
            robot.speeds(),    robot.commanded(), robot.state(),
            robot.charge(),    robot.isCharging()};
}

std::vector<RobotTruth> Plant::truth() const
{
    std::vector<RobotTruth> all;
    for (const Agv& agv : m_agvs)
        all.push_back(truthOf(agv));
    return all;
}

std::optional<RobotTruth> Plant::truth(RobotId robot) const
{
    for (const Agv& agv : m_agvs)
        if (agv.robot.config().id == robot)
            return truthOf(agv);
    return std::nullopt;
}

void Plant::setCharge(RobotId robot, double charge)
{
    if (Agv* agv = find(robot))
        agv->robot.setCharge(charge);
}

void Plant::shiftAntenna(RobotId robot, Point2 offset_m)
{
    if (Agv* agv = find(robot))
        agv->shift = offset_m;
}

void Plant::setTableError(double share)
{
    for (Agv& agv : m_agvs)
        agv.reader.setTableError(share);
}

void Plant::setMissRate(double share)
{
    for (Agv& agv : m_agvs)
        agv.reader.setMissRate(share);
}

void Plant::setSlip(RobotId robot, double share)
{
    if (Agv* agv = find(robot))
        agv->robot.setSlip(share);
}

void Plant::failRobot(RobotId robot)
{
    if (Agv* agv = find(robot))
        agv->robot.fail();
}

void Plant::printGarbage(RobotId reader, std::size_t count)
{
    if (Agv* agv = find(reader))
        agv->reader.printGarbage(count);
}

Result<void> Plant::checkPlace(RobotId robot, Point2 centre) const
{
    const AgvConfig* const config = m_layout.findAgv(robot);
    if (!config)
        return failure(ErrorCode::NotFound, "the plant has no robot " + std::to_string(robot.number));
    const std::string place = "place: robot " + std::to_string(robot.number);
    if (!m_collisions.holds(centre, config->radius_m))
        return failure(ErrorCode::BadInput,
                       place + " would stand beyond the edge of the plant; its centre must be " +
                           std::to_string(std::lround(mmFromMetres(config->radius_m))) +
                           " mm or more from it");
    for (const RobotTruth& other : truth()) {
        const AgvConfig* const otherConfig = m_layout.findAgv(other.id);
        if (other.id != robot && otherConfig &&
            distance(other.pose.position, centre) < config->radius_m + otherConfig->radius_m)
            return failure(ErrorCode::BadInput, place + " would stand on AGV " +
                                                    std::to_string(other.id.number) +
                                                    "; choose another place or move that AGV first");
    }
    return {};
}

void Plant::placeRobot(RobotId robot, const Pose2& pose)
{
    if (Agv* agv = find(robot))
        agv->robot.place(pose);
}

void Plant::restore()
{
    m_floor.restore();
    for (Agv& agv : m_agvs) {
        agv.reader.restore();
        agv.robot.restore();
        agv.shift = {};
    }
}

} // namespace agv::simulation
