// SPDX-License-Identifier: GPL-3.0-or-later
// What a PlantServer does with each trainer command.
#include "simserver/plant_server.h"

#include <QJsonArray>

#include <algorithm>

namespace agv::simserver {
namespace {

using namespace agv::simulation;

QJsonObject done(const char* command) { return {{"ok", true}, {"command", command}}; }

} // namespace

/// Carries a command out; one overload per command, so that a forgotten one does not compile.
struct PlantServer::Executor {
    PlantServer& server;

    Result<QJsonObject> operator()(ShowHelp) const
    {
        QJsonArray lines;
        for (const std::string& line : trainerHelp())
            lines.append(QString::fromStdString(line));
        return QJsonObject{{"help", lines}};
    }
    Result<QJsonObject> operator()(ShowTruth) const
    {
        server.catchUp();
        return QJsonObject{{"truth", server.truthArray()},
                           {"time_s", secondsFrom(server.m_plant.now().time_since_epoch())}};
    }
    Result<QJsonObject> operator()(Quit) const
    {
        emit server.quitRequested();
        return done("quit");
    }
    Result<QJsonObject> operator()(Restore) const
    {
        server.m_plant.restore();
        for (const Agv& agv : server.m_agvs) {
            agv.wemos->restore();
            agv.robot->restore();
        }
        if (!server.m_uwb)
            return done("restore");
        if (auto plugged = server.m_uwb->plug(server.m_plant.now()); !plugged)
            return std::unexpected(plugged.error());
        server.m_uwb->kit().restore(server.m_plant.now());
        return done("restore");
    }
    Result<QJsonObject> operator()(const ConnectToConsole& command) const
    {
        for (const Agv& agv : server.m_agvs)
            if (auto known = agv.robot->setConsole(command.console, command.telemetryPort); !known)
                return std::unexpected(known.error());
        return done("console");
    }
    Result<QJsonObject> operator()(const Cut& command) const
    {
        return onDevice(command.device, "cut",
                        [&](auto& end) { end.cut(durationFromSeconds(command.away_s)); });
    }
    Result<QJsonObject> operator()(const Stall& command) const
    {
        return onDevice(command.device, "stall",
                        [&](auto& end) { end.stall(durationFromSeconds(command.duration_s)); });
    }
    Result<QJsonObject> operator()(const HalfOpen& command) const
    {
        return onDevice(command.device, "halfopen", [](auto& end) { end.loseSilently(); });
    }
    Result<QJsonObject> operator()(const PrintGarbage& command) const
    {
        return onRobot(command.reader, "garbage",
                       [&](Plant& plant) { plant.printGarbage(command.reader, command.count); });
    }
    Result<QJsonObject> operator()(const KillTag& command) const
    {
        if (auto killed = server.m_plant.killTag(command.uid); !killed)
            return std::unexpected(killed.error());
        return done("deadtag");
    }
    Result<QJsonObject> operator()(const KillRandomTags& command) const
    {
        QJsonArray tags;
        for (const TagUid uid : server.m_plant.killRandomTags(command.count))
            tags.append(QString::fromStdString(fullText(uid)));
        QJsonObject answer = done("deadtag");
        answer.insert("tags", tags);
        return answer;
    }
    Result<QJsonObject> operator()(const simulation::SwapTags& command) const
    {
        if (auto swapped = server.m_plant.swapTags(command.first, command.second); !swapped)
            return std::unexpected(swapped.error());
        return done("swaptags");
    }
    Result<QJsonObject> operator()(const SetCharge& command) const
    {
        return onRobot(command.robot, "battery",
                       [&](Plant& plant) { plant.setCharge(command.robot, command.charge); });
    }
    Result<QJsonObject> operator()(const ShiftAntenna& command) const
    {
        return onRobot(command.robot, "antenna",
                       [&](Plant& plant) { plant.shiftAntenna(command.robot, command.offset); });
    }
    Result<QJsonObject> operator()(SetTableError command) const
    {
        server.m_plant.setTableError(command.share);
        return done("table");
    }
    Result<QJsonObject> operator()(SetMissRate command) const
    {
        server.m_plant.setMissRate(command.share);
        return done("miss");
    }
    Result<QJsonObject> operator()(const SetSlip& command) const
    {
        return onRobot(command.robot, "slip",
                       [&](Plant& plant) { plant.setSlip(command.robot, command.share); });
    }
    Result<QJsonObject> operator()(FailRobot command) const
    {
        return onRobot(command.robot, "robot-error", [&](Plant& plant) { plant.failRobot(command.robot); });
    }
    Result<QJsonObject> operator()(const PlaceRobot& command) const
    {
        server.catchUp();
        if (auto possible = server.m_plant.checkPlace(command.robot, command.pose.position); !possible)
            return std::unexpected(possible.error());
        return onRobot(command.robot, "place",
                       [&](Plant& plant) { plant.placeRobot(command.robot, command.pose); });
    }

    Result<QJsonObject> operator()(const UnplugUwb& command) const
    {
        return onUwb("unplug", [&](UwbPort& port, Time now) -> Result<void> {
            port.unplug(command.away_s.transform(durationFromSeconds), now);
            return {};
        });
    }
    Result<QJsonObject> operator()(PlugUwb) const
    {
        return onUwb("plug", [](UwbPort& port, Time now) { return port.plug(now); });
    }
    Result<QJsonObject> operator()(const BlockAnchor& command) const
    {
        return onAnchor(command.anchor, "nlos", [&](UwbKit& kit, Time now) {
            kit.blockAnchor(command.anchor, command.extra_m, durationFromSeconds(command.duration_s), now);
        });
    }
    Result<QJsonObject> operator()(DropAnchor command) const
    {
        return onAnchor(command.anchor, "dropanchor",
                        [&](UwbKit& kit, Time) { kit.setAnchorMissing(command.anchor, true); });
    }

private:
    Result<QJsonObject> onUwb(const char* command, auto&& action) const
    {
        if (!server.m_uwb)
            return failure(ErrorCode::NotFound, "the plant has no UWB kit: its plant file names no anchors");
        server.catchUp();
        if (Result<void> result = action(*server.m_uwb, server.m_plant.now()); !result)
            return std::unexpected(result.error());
        return done(command);
    }
    Result<QJsonObject> onAnchor(int anchor, const char* command, auto&& action) const
    {
        return onUwb(command, [&](UwbPort& port, Time now) -> Result<void> {
            if (std::ranges::find(server.m_plant.layout().anchors, anchor, &UwbAnchor::id) ==
                server.m_plant.layout().anchors.end())
                return failure(ErrorCode::NotFound, "the plant has no anchor " + std::to_string(anchor));
            action(port.kit(), now);
            return {};
        });
    }
    static std::unexpected<Error> noSuchRobot(RobotId robot)
    {
        return failure(ErrorCode::NotFound, "the plant has no robot " + std::to_string(robot.number));
    }
    Result<QJsonObject> onRobot(RobotId robot, const char* command, auto&& action) const
    {
        if (!server.find(robot))
            return noSuchRobot(robot);
        server.catchUp();
        action(server.m_plant);
        return done(command);
    }
    Result<QJsonObject> onDevice(Device device, const char* command, auto&& action) const
    {
        const Agv* agv = server.find(device.robot);
        if (!agv)
            return noSuchRobot(device.robot);
        if (device.kind == Device::Kind::Reader)
            action(*agv->wemos);
        else
            action(*agv->robot);
        return done(command);
    }
};

Result<QJsonObject> PlantServer::execute(const TrainerCommand& command)
{
    return std::visit(Executor{*this}, command);
}

} // namespace agv::simserver
