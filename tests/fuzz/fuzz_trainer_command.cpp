// SPDX-License-Identifier: GPL-3.0-or-later
// Input: one line. Every answer is a command within its ranges or an error a terminal can show; blanks around
// the line change nothing.
#include "fuzz/fuzz_support.h"
#include "simulation/trainer_command.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace agv::fuzz;
using namespace agv::simulation;

namespace {

bool isShare(double value) { return value >= 0.0 && value <= 1.0; }
bool isRobot(agv::RobotId robot) { return robot.number >= 1 && robot.number <= 1000; }
bool isTime(double seconds) { return seconds >= 0.0 && seconds <= 3600.0; }

struct InRange {
    bool operator()(const ConnectToConsole& c) const { return c.console.port > 0 && c.telemetryPort > 0; }
    bool operator()(const Cut& c) const { return isRobot(c.device.robot) && isTime(c.away_s); }
    bool operator()(const Stall& c) const { return isRobot(c.device.robot) && isTime(c.duration_s); }
    bool operator()(const HalfOpen& c) const { return isRobot(c.device.robot); }
    bool operator()(const PrintGarbage& c) const
    {
        return isRobot(c.reader) && c.count >= 1 && c.count <= 100'000;
    }
    bool operator()(const KillRandomTags& c) const { return c.count >= 1 && c.count <= 100'000; }
    bool operator()(const SetCharge& c) const { return isRobot(c.robot) && isShare(c.charge); }
    bool operator()(const ShiftAntenna& c) const
    {
        return std::abs(c.offset.x) <= 0.5 && std::abs(c.offset.y) <= 0.5;
    }
    bool operator()(const SetTableError& c) const { return std::abs(c.share) <= 0.5; }
    bool operator()(const SetMissRate& c) const { return isShare(c.share); }
    bool operator()(const SetSlip& c) const { return isRobot(c.robot) && isShare(c.share); }
    bool operator()(const FailRobot& c) const { return isRobot(c.robot); }
    bool operator()(const PlaceRobot& c) const
    {
        return isRobot(c.robot) && std::isfinite(c.pose.position.x) && std::abs(c.pose.heading) <= 3.15;
    }
    bool operator()(const auto&) const { return true; }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view line = textOf({data, size});
    const auto command = parseTrainerCommand(line);
    const auto again = parseTrainerCommand(" \t" + std::string(line) + " \r\n");
    require(command.has_value() == again.has_value(), "blanks around a line change nothing");
    if (command) {
        require(command->index() == again->index(), "blanks around a line do not change the command");
        require(std::visit(InRange{}, *command), "every field is in its range");
        return 0;
    }
    const std::string& detail = command.error().detail;
    require(!detail.empty() && detail.size() < 400, "an error is a short text");
    require(std::ranges::all_of(detail, [](char c) { return c >= ' ' && c <= '~'; }),
            "an error is printable");
    return 0;
}
