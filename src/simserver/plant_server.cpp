// SPDX-License-Identifier: GPL-3.0-or-later
#include "simserver/plant_server.h"

#include <QJsonArray>

#include <algorithm>
#include <chrono>
#include <utility>

namespace agv::simserver {
namespace {

using namespace std::chrono_literals;
using namespace agv::simulation;

constexpr auto tickPeriod = 5ms;
constexpr Duration longestCatchUp = 2s;
constexpr std::uint64_t socketStream = 1000; ///< apart from the streams of the plant itself

QJsonObject truthObject(const RobotTruth& truth)
{
    return {{"robot", truth.id.number},
            {"x_mm", mmFromMetres(truth.pose.position.x)},
            {"y_mm", mmFromMetres(truth.pose.position.y)},
            {"heading_deg", degFromRad(truth.pose.heading)},
            {"antenna_x_mm", mmFromMetres(truth.antenna.x)},
            {"antenna_y_mm", mmFromMetres(truth.antenna.y)},
            {"left_mm_s", mmFromMetres(truth.wheels.left)},
            {"right_mm_s", mmFromMetres(truth.wheels.right)},
            {"commanded_left_mm_s", mmFromMetres(truth.commanded.left)},
            {"commanded_right_mm_s", mmFromMetres(truth.commanded.right)},
            {"state", static_cast<int>(truth.state)},
            {"charge_percent", 100.0 * truth.charge},
            {"charging", truth.charging}};
}

QJsonObject done(const char* command) { return {{"ok", true}, {"command", command}}; }

} // namespace

QHostAddress loopbackAddressOf(const AgvConfig& agv)
{
    const QHostAddress own(QString::fromStdString(agv.robotHost));
    if (!own.isNull() && own.isLoopback())
        return own;
    return QHostAddress(QHostAddress(QStringLiteral("127.0.0.1")).toIPv4Address() +
                        static_cast<quint32>(std::max(0, agv.id.number)));
}

PlantServer::PlantServer(Plant plant, ServerOptions options, QObject* parent)
    : QObject(parent),
      m_plant(std::move(plant)),
      m_options(std::move(options))
{
    SplitMix64 random = SplitMix64(m_options.seed).split(socketStream);
    for (const AgvConfig& config : m_plant.layout().agvs)
        addAgv(config, random);
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(tickPeriod);
    connect(&m_timer, &QTimer::timeout, this, &PlantServer::tick);
}

void PlantServer::addAgv(const AgvConfig& config, SplitMix64& random)
{
    const QHostAddress address = loopbackAddressOf(config);
    m_agvs.push_back({config.id, address, std::make_unique<WemosServer>(SplitMix64(random.next())),
                      std::make_unique<RobotClient>(address, config.robotPeerPort)});
    connectSignals(m_agvs.back());
}

void PlantServer::connectSignals(const Agv& agv)
{
    const RobotId id = agv.id;
    WemosServer* wemos = agv.wemos.get();
    RobotClient* robot = agv.robot.get();
    connect(wemos, &WemosServer::clientConnected, this,
            [=, this](const QString& peer) { report("reader-client-connected", id, peer); });
    connect(wemos, &WemosServer::clientRefused, this,
            [=, this](const QString& peer) { report("reader-client-refused", id, peer); });
    connect(wemos, &WemosServer::clientLost, this,
            [=, this](const QString& peer) { report("reader-client-lost", id, peer); });
    connect(robot, &RobotClient::connected, this, [=, this] {
        m_plant.consoleConnected(id);
        report("robot-connected", id);
    });
    // The robot keeps its last speed: no time-out of its own is documented for it.
    connect(robot, &RobotClient::lost, this,
            [=, this](const QString& reason) { report("robot-disconnected", id, reason); });
    connect(robot, &RobotClient::received, this, [=, this](const QByteArray& bytes) {
        catchUp();
        m_plant.receive(id, {reinterpret_cast<const std::uint8_t*>(bytes.data()),
                             static_cast<std::size_t>(bytes.size())});
    });
}

Result<void> PlantServer::start()
{
    for (Agv& agv : m_agvs) {
        const AgvConfig& config = *m_plant.layout().findAgv(agv.id);
        const quint16 port = m_options.fixedReaderPorts ? config.reader.port : quint16{0};
        if (auto listening = agv.wemos->listen(agv.address, port); !listening)
            return listening;
    }
    m_clock.start();
    m_timer.start();
    const Endpoint console = m_options.console.value_or(m_plant.layout().robotListen);
    const quint16 telemetry = m_options.telemetryPort.value_or(m_plant.layout().telemetryPort);
    for (Agv& agv : m_agvs)
        if (auto known = agv.robot->setConsole(console, telemetry); !known)
            return known;
    return {};
}

void PlantServer::catchUp()
{
    const Duration real = std::chrono::nanoseconds(m_clock.nsecsElapsed());
    const Time now = Time{} + (real - m_skipped);
    if (now - m_plant.now() > longestCatchUp) // the machine slept; the plant did so, too
        m_skipped += now - m_plant.now() - longestCatchUp;
    m_plant.advance(Time{} + (real - m_skipped));
}

void PlantServer::tick()
{
    catchUp();
    for (Agv& agv : m_agvs) {
        agv.wemos->forward(m_plant.takeReaderBytes(agv.id));
        agv.robot->send(m_plant.takeRobotFrames(agv.id));
        agv.robot->sendTelemetry(m_plant.takeRobotDatagrams(agv.id));
        if (m_plant.takeBump(agv.id))
            report("bump", agv.id);
    }
    emit ticked();
}

PlantServer::Agv* PlantServer::find(RobotId id)
{
    const auto found = std::ranges::find(m_agvs, id, &Agv::id);
    return found == m_agvs.end() ? nullptr : &*found;
}

void PlantServer::report(const char* what, RobotId robot, const QString& peer)
{
    QJsonObject message{{"event", what}, {"robot", robot.number}};
    if (!peer.isEmpty())
        message.insert("detail", peer);
    emit event(message);
}

QJsonArray PlantServer::truthArray() const
{
    QJsonArray all;
    for (const RobotTruth& truth : m_plant.truth())
        all.append(truthObject(truth));
    return all;
}

QJsonObject PlantServer::readyMessage() const
{
    QJsonArray readers;
    QJsonArray robots;
    for (const Agv& agv : m_agvs) {
        const QString host = agv.address.toString();
        readers.append(QJsonObject{{"robot", agv.id.number}, {"host", host}, {"port", agv.wemos->port()}});
        robots.append(QJsonObject{{"robot", agv.id.number}, {"host", host}});
    }
    return {{"ready", true},
            {"seed", static_cast<qint64>(m_options.seed)},
            {"readers", readers},
            {"robots", robots},
            {"truth", truthArray()}};
}

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

private:
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
