// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/robot.h"

#include "simulation/docking.h"

#include <chrono>
#include <utility>

namespace agv::simulation {
namespace {

using namespace std::chrono_literals;

constexpr Duration statePeriod = 500ms;
constexpr Duration sensorPeriod = 1s;
constexpr Duration progressPeriod = 100ms;

double initialCharge(const PlantSettings& settings, SplitMix64& random)
{
    const double drawn = random.uniform(0.4, 1.0);
    return settings.charge.value_or(drawn);
}

} // namespace

Robot::Robot(const AgvConfig& config, const PlantSettings& settings, const Pose2& pose, SplitMix64 random)
    : m_config(config),
      m_pose(pose),
      m_battery(settings.battery, initialCharge(settings, random)),
      m_driveModel(settings.drive),
      m_drive(settings.drive, random.split(0)),
      m_program(config.track_m, settings.drive.acceleration_m_s2),
      m_bootTime_ms(10'000 + random.next() % 1'000'000)
{
    // Robots do not report in step with each other.
    m_nextState = durationFromSeconds(random.uniform(0.0, secondsFrom(statePeriod)));
    m_nextSensors = durationFromSeconds(random.uniform(0.0, secondsFrom(sensorPeriod)));
}

void Robot::step(double seconds, Duration robotTime, const PlantLayout& plant, const Clearance& clearance)
{
    const auto robotTime_ms =
        m_bootTime_ms +
        static_cast<std::uint64_t>(std::chrono::floor<std::chrono::milliseconds>(robotTime).count());
    if (m_program.isDocking())
        followDock(plant);
    const Drive::Step rolled =
        m_drive.step(m_program.target(), wheelFactor(m_driveModel, m_battery.charge()), seconds);
    m_program.step(seconds, rolled.encoder, m_drive.speeds(), robotTime_ms);
    move(rolled.ground, clearance);
    m_battery.step(seconds, m_drive.speeds(), m_onHomeBase);
    for (const protocol::RobotReport& report : m_program.takeReports())
        send(report);
    sendPeriodic(robotTime);
    if (robotTime >= m_nextProgress) {
        if (const auto progress = m_program.segmentProgress(robotTime_ms))
            if (auto datagram = protocol::encodeReportDatagram(*progress))
                m_datagrams.push_back(std::move(*datagram));
        m_nextProgress = robotTime + progressPeriod;
    }
}

void Robot::move(WheelTravel travel, const Clearance& clearance)
{
    if (travel.left == 0.0 && travel.right == 0.0)
        return;
    m_onHomeBase = false;
    Pose2 next = rolled(m_pose, travel, m_config.track_m);
    const double free = clearance(next.position);
    const bool blocked = free < 0.0 && free < clearance(m_pose.position);
    if (blocked) {
        next.position = m_pose.position;
        m_drive.halt();
        if (!m_touching) {
            m_bumped = true;
            m_program.bump();
        }
    }
    m_touching = blocked || (m_touching && free < 0.002);
    m_pose = next;
}

void Robot::followDock(const PlantLayout& plant)
{
    const bool charging = m_program.state() == RobotState::DemoDocking;
    const auto dock = dockInSight(plant, m_pose, m_config.radius_m, charging);
    if (!dock)
        return m_program.guide(std::nullopt, false);
    const bool arrived = isDocked(m_pose, *dock);
    m_program.guide(towardsDock(m_pose, *dock, m_config.track_m), arrived);
    if (arrived) {
        m_drive.halt();
        m_onHomeBase = charging;
    }
}

void Robot::receive(std::span<const std::uint8_t> bytes)
{
    m_commands.feed(bytes, [this](const protocol::RobotCommand& command) { m_program.receive(command); });
}

void Robot::consoleConnected()
{
    m_commands.reset();
    m_program.restartNumbering();
    m_nextState = {};
    m_nextSensors = {};
}

void Robot::send(const protocol::RobotReport& report)
{
    if (const auto frame = protocol::encodeReportFrame(report))
        m_frames.insert(m_frames.end(), frame->begin(), frame->end());
}

void Robot::sendPeriodic(Duration robotTime)
{
    if (robotTime >= m_nextState) {
        send(protocol::StateUpdate{m_program.state()});
        m_nextState = robotTime + statePeriod;
    }
    if (robotTime >= m_nextSensors) {
        if (auto datagram = protocol::encodeReportDatagram(protocol::SensorUpdate{m_battery.status()}))
            m_datagrams.push_back(std::move(*datagram));
        m_nextSensors = robotTime + sensorPeriod;
    }
}

protocol::Bytes Robot::takeFrames() { return std::exchange(m_frames, {}); }

std::vector<protocol::Bytes> Robot::takeDatagrams() { return std::exchange(m_datagrams, {}); }

bool Robot::takeBump() { return std::exchange(m_bumped, false); }

void Robot::place(const Pose2& pose)
{
    m_pose = {pose.position, wrapAngle(pose.heading)};
    m_onHomeBase = false;
    m_touching = false;
}

void Robot::fail() { m_program.fail("fault set by the trainer", 99); }

void Robot::restore()
{
    m_drive.setSlip(0.0);
    m_program.clearError();
}

} // namespace agv::simulation
