// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The one-line commands by which a trainer or a test steers a simulated plant while it runs. On the line mm,
/// degrees and per cent; here SI and shares.
namespace agv::simulation {

/// One end of a wire that can be cut.
struct Device {
    enum class Kind { Reader, Robot };
    Kind kind = Kind::Reader;
    RobotId robot;
    friend bool operator==(const Device&, const Device&) = default;
};

struct ShowHelp {};
struct ShowTruth {};
struct Quit {};
struct Restore {};
struct ConnectToConsole {
    Endpoint console;
    std::uint16_t telemetryPort = 0;
};
struct Cut {
    Device device;
    double away_s = 0.0; ///< 0..3600, refusing or not seeking connections for so long
};
struct Stall {
    Device device;
    double duration_s = 0.0; ///< 0..3600
};
struct HalfOpen {
    Device device;
};
struct PrintGarbage {
    RobotId reader;
    std::size_t count = 0; ///< 1..100,000 bytes
};
struct KillTag {
    TagUid uid;
};
struct KillRandomTags {
    std::size_t count = 0; ///< 1..100,000
};
struct SwapTags {
    TagUid first;
    TagUid second;
};
struct SetCharge {
    RobotId robot;
    double charge = 0.0; ///< 0..1
};
struct ShiftAntenna {
    RobotId robot;
    Point2 offset; ///< m, forward and left; -0.5..0.5
};
struct SetTableError {
    double share = 0.0; ///< -0.5..0.5
};
struct SetMissRate {
    double share = 0.0; ///< 0..1
};
struct SetSlip {
    RobotId robot;
    double share = 0.0; ///< 0..1
};
struct FailRobot {
    RobotId robot;
};
struct PlaceRobot {
    RobotId robot;
    Pose2 pose;
};

struct UnplugUwb {
    std::optional<double> away_s; ///< 0..3600; empty: until PlugUwb
};
struct PlugUwb {};
struct BlockAnchor {
    int anchor = 0;          ///< 0..7
    double extra_m = 0.0;    ///< 0..10
    double duration_s = 0.0; ///< 0..3600
};
struct DropAnchor {
    int anchor = 0; ///< 0..7
};

using TrainerCommand =
    std::variant<ShowHelp, ShowTruth, Quit, Restore, ConnectToConsole, Cut, Stall, HalfOpen, PrintGarbage,
                 KillTag, KillRandomTags, SwapTags, SetCharge, ShiftAntenna, SetTableError, SetMissRate,
                 SetSlip, FailRobot, PlaceRobot, UnplugUwb, PlugUwb, BlockAnchor, DropAnchor>;

/// Reads one line, words separated by blanks or tabs. BadInput says which word is wrong and what was
/// expected.
Result<TrainerCommand> parseTrainerCommand(std::string_view line);

/// One line per command: its syntax and what it does.
std::vector<std::string> trainerHelp();

} // namespace agv::simulation
