// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/trainer_command.h"

#include <gtest/gtest.h>

#include <limits>

using namespace agv;
using namespace agv::simulation;

namespace {

template<typename Command>
Command parsed(std::string_view line)
{
    const auto command = parseTrainerCommand(line);
    EXPECT_TRUE(command) << line << ": " << command.error().detail;
    const Command* wanted = command ? std::get_if<Command>(&*command) : nullptr;
    EXPECT_NE(wanted, nullptr) << line;
    return wanted ? *wanted : Command{};
}

std::string errorOf(std::string_view line)
{
    const auto command = parseTrainerCommand(line);
    return command ? "no error" : command.error().detail;
}

} // namespace

TEST(TrainerCommand, readsEveryCommand)
{
    parsed<ShowHelp>("help");
    parsed<ShowTruth>("truth");
    parsed<Quit>("quit");
    parsed<Restore>("restore");
    const auto console = parsed<ConnectToConsole>("console 127.0.0.1 2001 2000");
    EXPECT_EQ(console.console, (Endpoint{"127.0.0.1", 2001}));
    EXPECT_EQ(console.telemetryPort, 2000);
    EXPECT_EQ(parsed<Cut>("cut reader 2").device, (Device{Device::Kind::Reader, RobotId{2}}));
    EXPECT_EQ(parsed<Cut>("cut robot 1 2.5").away_s, 2.5);
    EXPECT_EQ(parsed<Stall>("stall robot 3 0.5").duration_s, 0.5);
    EXPECT_EQ(parsed<HalfOpen>("halfopen reader 4").device.robot, RobotId{4});
    EXPECT_EQ(parsed<PrintGarbage>("garbage reader 1 20").count, 20U);
    EXPECT_EQ(parsed<KillTag>("deadtag E00401503A5BDAE4").uid, TagUid{0xE00401503A5BDAE4});
    EXPECT_EQ(parsed<KillRandomTags>("deadtag random 5").count, 5U);
    EXPECT_EQ(parsed<SwapTags>("swaptags AE4 586").second, TagUid{0x586});
    EXPECT_DOUBLE_EQ(parsed<SetCharge>("battery 1 35").charge, 0.35);
    EXPECT_EQ(parsed<ShiftAntenna>("antenna 1 3 -4").offset, (Point2{0.003, -0.004}));
    EXPECT_DOUBLE_EQ(parsed<SetTableError>("table -8").share, -0.08);
    EXPECT_DOUBLE_EQ(parsed<SetMissRate>("miss 30").share, 0.3);
    EXPECT_DOUBLE_EQ(parsed<SetSlip>("slip 2 15").share, 0.15);
    EXPECT_EQ(parsed<FailRobot>("robot-error 2").robot, RobotId{2});
    EXPECT_EQ(parsed<UnplugUwb>("unplug").away_s, std::nullopt);
    EXPECT_EQ(parsed<UnplugUwb>("unplug 2.5").away_s, 2.5);
    parsed<PlugUwb>("plug");
    const auto nlos = parsed<BlockAnchor>("nlos 3 450 10");
    EXPECT_EQ(nlos.anchor, 3);
    EXPECT_DOUBLE_EQ(nlos.extra_m, 0.45);
    EXPECT_EQ(nlos.duration_s, 10.0);
    EXPECT_EQ(parsed<DropAnchor>("dropanchor 0").anchor, 0);
    const auto place = parsed<PlaceRobot>("place 1 1500 2000 -90");
    EXPECT_EQ(place.pose.position, (Point2{1.5, 2.0}));
    EXPECT_DOUBLE_EQ(place.pose.heading, radFromDeg(-90.0));
}

TEST(TrainerCommand, allowsBlanksAndTabsAnywhere) { parsed<Cut>("  cut\treader   1 \r\n"); }

TEST(TrainerCommand, saysWhatIsWrong)
{
    EXPECT_NE(errorOf("").find("empty"), std::string::npos);
    EXPECT_NE(errorOf("fly 1").find("unknown command 'fly'"), std::string::npos);
    EXPECT_NE(errorOf("cut").find("missing device"), std::string::npos);
    EXPECT_NE(errorOf("cut wire 1").find("'reader' or 'robot'"), std::string::npos);
    EXPECT_NE(errorOf("cut reader").find("missing robot number"), std::string::npos);
    EXPECT_NE(errorOf("cut reader x").find("robot number 'x'"), std::string::npos);
    EXPECT_NE(errorOf("cut reader 1.5").find("whole"), std::string::npos);
    EXPECT_NE(errorOf("cut reader 1 2 3").find("unexpected '3'"), std::string::npos);
    EXPECT_NE(errorOf("battery 1 101").find("from 0 to 100"), std::string::npos);
    EXPECT_NE(errorOf("battery 1 nan").find("'nan'"), std::string::npos);
    EXPECT_NE(errorOf("battery 1 1e999").find("'1e999'"), std::string::npos);
    EXPECT_NE(errorOf("deadtag XYZ").find("tag UID 'XYZ'"), std::string::npos);
    EXPECT_NE(errorOf("console localhost").find("missing port"), std::string::npos);
    EXPECT_NE(errorOf("console localhost 0 1").find("port '0'"), std::string::npos);
    EXPECT_NE(errorOf("cut reader").find("usage: cut reader N|robot N"), std::string::npos);
}

TEST(TrainerCommand, echoesNothingUnprintableAndNothingLong)
{
    EXPECT_NE(errorOf("\x01\xff").find("'\?\?'"), std::string::npos);
    EXPECT_LT(errorOf(std::string(100'000, 'x')).size(), 120U);
}

TEST(TrainerCommand, helpNamesEveryCommand)
{
    const auto help = trainerHelp();
    ASSERT_EQ(help.size(), 22U);
    for (const std::string& line : help) {
        const std::string name = line.substr(0, line.find_first_of(" :"));
        EXPECT_EQ(errorOf(name).find("unknown"), std::string::npos) << name;
    }
}
