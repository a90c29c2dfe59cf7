// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/virtual_turn.h"

namespace agv::simulation {
namespace {

using namespace std::chrono_literals;
using procedure::InitialisationTurn;

constexpr Duration longestTurn = 120s;

class Console {
public:
    Console(Plant& plant, RobotId robot, const TurnParameters& parameters, std::uint32_t firstSegment)
        : m_plant(plant),
          m_robot(robot),
          m_turn(parameters, firstSegment),
          m_previous(plant.truth(robot)->pose.heading)
    {}

    void run()
    {
        const Time begin = m_plant.now();
        act(m_turn.start(m_plant.now()));
        while ((m_turn.isActive() || m_turn.deadline()) && m_plant.now() < begin + longestTurn)
            step();
    }
    const InitialisationTurn& turn() const { return m_turn; }
    double turned() const { return m_turned; }

private:
    void step()
    {
        m_plant.advance(m_plant.now() + Plant::step);
        const Time now = m_plant.now();
        m_lines.feed(m_plant.takeReaderBytes(m_robot), [&](const protocol::ReaderReport& report) {
            if (const auto* read = std::get_if<protocol::CompleteRead>(&report))
                act(m_turn.onTagRead({now, read->uid, read->rssi}));
        });
        m_frames.feed(m_plant.takeRobotFrames(m_robot), [&](const protocol::RobotReport& report) {
            if (const auto* done = std::get_if<protocol::SegmentDone>(&report))
                act(m_turn.onSegmentDone(done->number, now));
            if (const auto* state = std::get_if<protocol::StateUpdate>(&report))
                act(m_turn.onRobotState(state->state, now));
        });
        if (m_turn.deadline() && *m_turn.deadline() <= now)
            act(m_turn.onTimer(now));
        const double heading = m_plant.truth(m_robot)->pose.heading;
        m_turned += wrapAngle(heading - m_previous);
        m_previous = heading;
    }

    void act(const procedure::TurnActions& actions)
    {
        for (const procedure::TurnAction& action : actions) {
            if (const auto* wheels = std::get_if<procedure::DriveWheels>(&action))
                send(protocol::DirectDrive{wheels->speeds});
            if (const auto* segments = std::get_if<procedure::DriveSegments>(&action))
                send(protocol::AddSegments{segments->firstNumber, segments->segments});
            if (std::holds_alternative<procedure::InterruptRobot>(action))
                send(protocol::Interrupt{});
            if (std::holds_alternative<procedure::SolveResult>(action))
                act(m_turn.solved(m_plant.now()));
        }
    }

    void send(const protocol::RobotCommand& command)
    {
        m_plant.receive(m_robot, protocol::encodeCommand(command).value());
    }

    Plant& m_plant;
    RobotId m_robot;
    InitialisationTurn m_turn;
    protocol::ReaderStream m_lines;
    protocol::ReportStream m_frames;
    double m_previous;
    double m_turned = 0.0;
};

} // namespace

VirtualTurn driveTurn(Plant& plant, RobotId robot, const TurnParameters& parameters,
                      std::uint32_t firstSegment)
{
    plant.takeReaderBytes(robot); // what nobody listened to
    plant.takeRobotFrames(robot);
    VirtualTurn result;
    result.first = plant.truth(robot).value();
    const Time begin = plant.now();
    Console console(plant, robot, parameters, firstSegment);
    console.run();
    result.end = console.turn().phase();
    result.message = console.turn().snapshot(plant.now()).message;
    result.record = console.turn().record();
    result.last = plant.truth(robot).value();
    result.duration_s = secondsFrom(plant.now() - begin);
    result.nextSegment = console.turn().nextSegment();
    if (result.record.stops.size() > 1)
        result.meanStep = std::abs(console.turned()) / static_cast<double>(result.record.stops.size() - 1);
    return result;
}

} // namespace agv::simulation
