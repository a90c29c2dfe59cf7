// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/reader_stream.h"
#include "protocol/robot_frame.h"
#include "simulation/plant.h"

#include <chrono>
#include <vector>

namespace agv::simulation {

using namespace std::chrono_literals;

/// An empty 3 m x 4 m hall with a tag every 100 mm and `robots` AGVs.
inline PlantLayout hall(int robots = 1)
{
    PlantLayout plant;
    plant.name = "test hall";
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    plant.floorTags = tagGrid(31, 41, 0.1, {0.0, 0.0}, TagUid{0xE00401503A5B0001});
    for (int i = 1; i <= robots; ++i) {
        AgvConfig agv;
        agv.id = {i};
        agv.robotHost = "127.0.0." + std::to_string(i + 1);
        agv.reader = {agv.robotHost, 0};
        plant.agvs.push_back(agv);
    }
    return plant;
}

/// A plant under test with what a console would see of it. Robot 1 stands in the middle, heading east.
class PlantUnderTest {
public:
    explicit PlantUnderTest(const PlantSettings& settings = idealSettings(),
                            const PlantLayout& layout = hall())
        : plant(Plant::create(layout, settings).value())
    {
        plant.placeRobot(robot, {{1.5, 2.0}, 0.0});
    }

    void run(Duration duration)
    {
        plant.advance(plant.now() + duration);
        const protocol::Bytes frames = plant.takeRobotFrames(robot);
        const auto keep = [this](const protocol::RobotReport& report) { reports.push_back(report); };
        m_frames.feed(frames, keep);
        for (const protocol::Bytes& datagram : plant.takeRobotDatagrams(robot))
            telemetry.push_back(protocol::decodeReportDatagram(datagram).value());
        m_lines.feed(plant.takeReaderBytes(robot),
                     [this](const protocol::ReaderReport& report) { lines.push_back(report); });
    }

    void send(const protocol::RobotCommand& command)
    {
        plant.receive(robot, protocol::encodeCommand(command).value());
    }
    void drive(double left, double right) { send(protocol::DirectDrive{{left, right}}); }

    Pose2 pose() const { return plant.truth(robot)->pose; }
    double heading_deg() const { return degFromRad(pose().heading); }
    RobotState state() const { return plant.truth(robot)->state; }

    template<typename Report>
    std::vector<Report> all() const
    {
        return pick<Report>(reports);
    }
    template<typename Report>
    std::vector<Report> allTelemetry() const
    {
        return pick<Report>(telemetry);
    }
    std::vector<protocol::CompleteRead> reads() const { return pick<protocol::CompleteRead>(lines); }
    protocol::ReaderStream::Counts lineCounts() const { return m_lines.counts(); }

    static constexpr RobotId robot{1};
    Plant plant;
    std::vector<protocol::RobotReport> reports;   ///< TCP
    std::vector<protocol::RobotReport> telemetry; ///< UDP
    std::vector<protocol::ReaderReport> lines;

private:
    template<typename Wanted, typename Variant>
    static std::vector<Wanted> pick(const std::vector<Variant>& from)
    {
        std::vector<Wanted> found;
        for (const Variant& item : from)
            if (const auto* wanted = std::get_if<Wanted>(&item))
                found.push_back(*wanted);
        return found;
    }

    protocol::ReportStream m_frames;
    protocol::ReaderStream m_lines;
};

} // namespace agv::simulation
