// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <QTimer>

#include "simserver/robot_client.h"
#include "simserver/uwb_port.h"
#include "simserver/wemos_server.h"
#include "simulation/plant.h"
#include "simulation/trainer_command.h"

#include <memory>
#include <optional>
#include <vector>

namespace agv::simserver {

struct ServerOptions {
    std::uint64_t seed = 1;          ///< of the sockets' own randomness, and shown in the ready message
    bool fixedReaderPorts = false;   ///< ports of the plant file; false: free ones
    std::optional<Endpoint> console; ///< where the robots connect; empty: the plant file's robotListen
    std::optional<std::uint16_t> telemetryPort; ///< empty: the plant file's
    std::optional<std::string> uwbLink = {};    ///< symbolic link to the UWB port, which has another path at
                                                ///< each plugging
    UwbDialect uwbDialect = UwbDialect::Trek;
    bool uwbFast = true; ///< 10 reports a second and tag, else 3.57
};

/// A simulated plant on real sockets: per AGV a WeMos server and a robot client, each on that AGV's own
/// loopback address, and, where the plant has UWB anchors, a UWB kit on a serial device of its own; run by
/// the real clock in ticks of 5 ms. Lives in one thread with an event loop; prints nothing itself.
class PlantServer : public QObject {
    Q_OBJECT
public:
    PlantServer(simulation::Plant plant, ServerOptions options, QObject* parent = nullptr);

    /// Opens the readers' ports and the UWB port and sends the robots out. InUse, Permission, Network, Io: a
    /// port cannot be had.
    Result<void> start();

    /// {"ready":true,"seed":...,"readers":[...],"robots":[...],"truth":[...],"uwb":{"path":...}}; "uwb" only
    /// with a kit, and with "link" when it has one.
    QJsonObject readyMessage() const;
    /// One answer per command. NotFound, BadInput: what is wrong with it; nothing was done.
    Result<QJsonObject> execute(const simulation::TrainerCommand& command);
    const simulation::Plant& plant() const { return m_plant; }

signals:
    /// Something happened that no command asked for: {"event":"...","robot":N,...}
    void event(const QJsonObject& message);
    void quitRequested();
    void ticked();

private:
    struct Agv {
        RobotId id;
        QHostAddress address;
        std::unique_ptr<WemosServer> wemos;
        std::unique_ptr<RobotClient> robot;
    };
    struct Executor;

    void addAgv(const AgvConfig& config, SplitMix64& random);
    void connectSignals(const Agv& agv);
    Result<void> startUwb();
    void catchUp();
    void tick();
    void runUwb();
    Agv* find(RobotId id);
    QJsonArray truthArray() const;
    QJsonObject uwbObject() const;
    void report(const char* what, RobotId robot, const QString& peer = {});

    simulation::Plant m_plant;
    ServerOptions m_options;
    std::vector<Agv> m_agvs;
    std::vector<UwbTag> m_uwbTags;
    std::unique_ptr<UwbPort> m_uwb; ///< null without anchors
    bool m_uwbWasPlugged = true;
    QElapsedTimer m_clock;
    Duration m_skipped{}; ///< real time the plant did not live through
    QTimer m_timer;
};

/// Tags of a simulated kit: those of the plant file that an AGV carries or, when it names none, one in the
/// middle of every AGV, numbered from 0.
std::vector<UwbTag> simulatedUwbTags(const PlantLayout& plant);

/// Where an AGV of the plant file lives on this machine: its own address when that is a loopback one,
/// 127.0.0.(1 + number) otherwise.
QHostAddress loopbackAddressOf(const AgvConfig& agv);

} // namespace agv::simserver
