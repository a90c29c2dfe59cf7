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

constexpr std::uint64_t uwbStream = 1001; ///< apart from the sockets'

} // namespace

QHostAddress loopbackAddressOf(const AgvConfig& agv)
{
    const QHostAddress own(QString::fromStdString(agv.robotHost));
    if (!own.isNull() && own.isLoopback())
        return own;
    return QHostAddress(QHostAddress(QStringLiteral("127.0.0.1")).toIPv4Address() +
                        static_cast<quint32>(std::max(0, agv.id.number)));
}

std::vector<UwbTag> simulatedUwbTags(const PlantLayout& plant)
{
    std::vector<UwbTag> tags;
    for (const UwbTag& tag : plant.uwb.tags)
        if (tag.agv && plant.findAgv(*tag.agv) != nullptr)
            tags.push_back(tag);
    if (!plant.uwb.tags.empty())
        return tags;
    for (const AgvConfig& agv : plant.agvs)
        tags.push_back({.id = static_cast<int>(tags.size()),
                        .label = {},
                        .agv = agv.id,
                        .z_m = plant.uwb.tagHeight_m,
                        .mount = {}});
    return tags;
}

PlantServer::PlantServer(Plant plant, ServerOptions options, QObject* parent)
    : QObject(parent),
      m_plant(std::move(plant)),
      m_options(std::move(options)),
      m_uwbTags(simulatedUwbTags(m_plant.layout()))
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
    if (auto started = startUwb(); !started)
        return started;
    m_clock.start();
    m_timer.start();
    const Endpoint console = m_options.console.value_or(m_plant.layout().robotListen);
    const quint16 telemetry = m_options.telemetryPort.value_or(m_plant.layout().telemetryPort);
    for (Agv& agv : m_agvs)
        if (auto known = agv.robot->setConsole(console, telemetry); !known)
            return known;
    return {};
}

Result<void> PlantServer::startUwb()
{
    if (m_plant.layout().anchors.empty())
        return {};
    auto port = UwbPort::create({.seed = SplitMix64(m_options.seed).split(uwbStream).next(),
                                 .dialect = m_options.uwbDialect,
                                 .fastMode = m_options.uwbFast,
                                 .model = {},
                                 .anchors = m_plant.layout().anchors},
                                m_options.uwbLink, m_plant.now());
    if (!port)
        return std::unexpected(port.error());
    m_uwb = std::move(*port);
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
    if (m_uwb)
        runUwb();
    emit ticked();
}

void PlantServer::runUwb()
{
    std::vector<UwbTagPlace> places;
    for (const UwbTag& tag : m_uwbTags) {
        const Point2 at = fromVehicleFrame(m_plant.truth(*tag.agv)->pose, tag.mount);
        places.push_back({tag.id, at.x, at.y, tag.z_m});
    }
    m_uwb->advance(m_plant.now(), places);
    const bool wasPlugged = std::exchange(m_uwbWasPlugged, m_uwb->isPlugged());
    if (wasPlugged == m_uwbWasPlugged)
        return;
    QJsonObject message = uwbObject();
    message.insert("event", m_uwbWasPlugged ? "uwb-plugged" : "uwb-unplugged");
    emit event(message);
}

QJsonObject PlantServer::uwbObject() const
{
    QJsonObject uwb{{"path", QString::fromStdString(m_uwb->path())}};
    if (m_options.uwbLink)
        uwb.insert("link", QString::fromStdString(*m_options.uwbLink));
    return uwb;
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
    QJsonObject message{{"ready", true},
                        {"seed", static_cast<qint64>(m_options.seed)},
                        {"readers", readers},
                        {"robots", robots},
                        {"truth", truthArray()}};
    if (m_uwb)
        message.insert("uwb", uwbObject());
    return message;
}

} // namespace agv::simserver
