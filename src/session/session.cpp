// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include "session/alarm_desk.h"
#include "session/jog_desk.h"
#include "session/robot_link.h"
#include "session/session_private.h"

#include <utility>

namespace agv::session {
namespace {

constexpr std::chrono::milliseconds frame(33);                 ///< 30 snapshots per second at most
constexpr Duration idleFrame = std::chrono::milliseconds(200); ///< ages and rates change without events
constexpr std::size_t refusedPeersKept = 16;
constexpr std::chrono::seconds listenAgainAfter(2); ///< whoever holds the port may end

} // namespace

Session::Private::Private(Session& owner, PlantLayout layout, SessionOptions sessionOptions)
    : q(owner),
      plant(std::move(layout)),
      options(std::move(sessionOptions)),
      events([this](const EventEntry& entry) { logEvent(entry); }),
      recorder(new RunRecorder(options.recording, events, &owner)),
      tee(new RunTee(*recorder, &owner)),
      server(new link::RobotServer(plant.agvs, options.guard, &owner)),
      telemetry(new link::TelemetrySocket(&owner)),
      alarms(new AlarmDesk(&owner)),
      frameTimer(new QTimer(&owner)),
      listenTimer(new QTimer(&owner)),
      jogDesk(new JogDesk(&owner))
{
    tee->watch(*server, *telemetry);
    QObject::connect(recorder, &RunRecorder::changed, &owner, [this] { changed = true; });
    for (const AgvConfig& agv : plant.agvs)
        addLine(agv);
    addUwb();
    wireServer();
    QObject::connect(alarms, &AlarmDesk::changed, &owner, [this] { changed = true; });
    frameTimer->setTimerType(Qt::PreciseTimer);
    frameTimer->setInterval(frame);
    QObject::connect(frameTimer, &QTimer::timeout, &owner, [this] {
        if (changed || monotonicNow() - published >= idleFrame)
            publish();
    });
    listenTimer->setSingleShot(true);
    listenTimer->setInterval(listenAgainAfter);
    QObject::connect(listenTimer, &QTimer::timeout, &owner, [this] { listen(); });
}

void Session::Private::logEvent(const EventEntry& entry)
{
    if (tee)
        tee->event(entry);
    emit q.eventLogged(entry);
}

void Session::Private::addLine(const AgvConfig& config)
{
    const int robot = config.id.number;
    auto* agv = new AgvLine(config, plant, *server, solverFor(plant, config, options.solverSeed),
                            options.method, events, &q);
    lines.emplace(robot, agv);
    jogDesk->add(robot, *agv);
    tee->watch(robot, *agv);
    QObject::connect(agv, &AgvLine::changed, &q, [this] { changed = true; });
    QObject::connect(agv, &AgvLine::bytesReceived, &q, [this, robot](const link::Chunk& chunk) {
        emit q.readerBytes(robot, chunk.bytes, chunk.time);
    });
    QObject::connect(agv, &AgvLine::turnPhaseChanged, &q,
                     [this, robot](TurnPhase phase, int stop, Time time) {
                         emit q.turnPhaseChanged(robot, phase, stop, time);
                     });
    QObject::connect(agv, &AgvLine::turnRefused, &q,
                     [this, robot](const QString& reason) { emit q.turnRefused(robot, reason); });
    QObject::connect(
        agv, &AgvLine::turnEnded, &q,
        [this, robot](const TurnSnapshot& turn, const std::shared_ptr<const TurnRecord>& record) {
            emit q.turnEnded(robot, turn, record);
        });
}

void Session::Private::addUwb()
{
    if (plant.anchors.empty())
        return;
    uwb = new UwbLine(plant, options.uwb, events, &q);
    tee->watch(*uwb);
    QObject::connect(uwb, &UwbLine::changed, &q, [this] { changed = true; });
    QObject::connect(&uwb->link(), &UwbLink::carriedTagMeasured, &q,
                     [this](RobotId agv, const UwbTagTrack& track, Point2 mount) {
                         if (const auto carrier = lines.find(agv.number); carrier != lines.end())
                             carrier->second->onRanges(track.corrected(), mount, track.height_m(),
                                                       Time(durationFromSeconds(track.measured_s())));
                     });
    QObject::connect(uwb, &UwbLine::bytesReceived, &q,
                     [this](const link::Chunk& chunk) { emit q.uwbBytes(chunk.bytes, chunk.time); });
}

void Session::Private::wireServer()
{
    QObject::connect(server, &link::RobotServer::robotConnected, &q,
                     [this](int robot, const QString& peer, bool replaced) {
                         line(robot)->onRobotConnected(peer, replaced);
                     });
    QObject::connect(server, &link::RobotServer::robotLost, &q,
                     [this](int robot, const QString& reason) { line(robot)->onRobotLost(reason); });
    QObject::connect(server, &link::RobotServer::robotReceived, &q,
                     [this](int robot, const link::Chunk& chunk) {
                         line(robot)->robot().onReceived(chunk);
                         changed = true;
                     });
    QObject::connect(telemetry, &link::TelemetrySocket::received, &q,
                     [this](const QHostAddress& sender, const link::Chunk& datagram) {
                         if (const std::optional<int> robot = server->robotAt(sender)) {
                             line(*robot)->robot().onDatagram(datagram);
                             changed = true;
                         } else if (telemetryStrangers.isNews(sender.toString(), datagram.time)) {
                             refuse(sender.toString(),
                                    "sent telemetry that was ignored: the plant file has no robot with that "
                                    "address, or more than one");
                         }
                     });
    QObject::connect(server, &link::RobotServer::peerRefused, &q, [this](const QString& address) {
        refuse(address, "tried to connect as a robot and was refused: it is not in the plant file");
    });
}

void Session::Private::refuse(const QString& address, const char* what)
{
    const std::string peer = address.toStdString();
    log(EventLevel::Warning, peer + " " + what);
    std::erase(refusedPeers, peer);
    refusedPeers.push_back(peer);
    if (refusedPeers.size() > refusedPeersKept)
        refusedPeers.erase(refusedPeers.begin());
    changed = true;
}

/// Opens what is not open yet. While something is missing it is tried again, but said only when it changes.
void Session::Private::listen()
{
    const auto troubleOf = [](const Result<void>& result) {
        return result ? std::string() : result.error().detail;
    };
    const bool isNew = server->port() == 0;
    const std::string trouble = isNew ? troubleOf(server->listen(plant.robotListen)) : std::string();
    const Endpoint telemetryEndpoint{plant.robotListen.host, plant.telemetryPort};
    const std::string telemetryTrouble = trouble.empty() && telemetry->port() == 0
                                             ? troubleOf(telemetry->listen(telemetryEndpoint))
                                             : std::string();
    if (!trouble.empty() || !telemetryTrouble.empty())
        listenTimer->start();
    if (!trouble.empty())
        return listenFailed(trouble);
    const std::string before =
        std::exchange(listening, plant.robotListen.host + ":" + std::to_string(server->port()) + " (TCP), " +
                                     (telemetry->port() != 0 ? std::to_string(telemetry->port()) + " (UDP)"
                                                             : "no telemetry"));
    if (listening == before)
        return;
    changed = true;
    // Robots can be driven without telemetry; the battery is shown from the TCP link then.
    if (!telemetryTrouble.empty())
        log(EventLevel::Error, telemetryTrouble);
    log(EventLevel::Info, "Listening for robots on " + listening);
    for (const auto& [robot, agv] : lines)
        agv->robot().setServerTrouble({});
    if (isNew)
        emit q.listening(server->port(), telemetry->port());
}

void Session::Private::listenFailed(const std::string& trouble)
{
    const std::string before = std::exchange(listening, "Not listening: " + trouble);
    if (listening == before)
        return;
    changed = true;
    log(EventLevel::Error, trouble);
    for (const auto& [robot, agv] : lines)
        agv->robot().setServerTrouble(trouble);
    emit q.listenFailed(QString::fromStdString(trouble));
}

void Session::Private::publish()
{
    changed = false;
    published = monotonicNow();
    PlantSnapshot snapshot;
    snapshot.time = published;
    snapshot.refusedPeers = refusedPeers;
    snapshot.listening = listening;
    snapshot.simulated = options.simulated;
    snapshot.agvs.reserve(lines.size());
    for (const AgvConfig& agv : plant.agvs)
        snapshot.agvs.push_back(lines.at(agv.id.number)->snapshot(published));
    if (uwb)
        snapshot.uwb = uwb->link().snapshot(published);
    alarms->addTo(snapshot);
    snapshot.recording = recorder->snapshot(published);
    tee->snapshot(snapshot);
    emit q.snapshotReady(snapshot);
}

AgvLine* Session::Private::line(int robot)
{
    const auto found = lines.find(robot);
    if (found != lines.end())
        return found->second;
    log(EventLevel::Warning, "There is no AGV " + std::to_string(robot) + " in the plant file");
    return nullptr;
}

Session::Session(PlantLayout plant, SessionOptions options, QObject* parent)
    : QObject(parent),
      d(std::make_unique<Private>(*this, std::move(plant), std::move(options)))
{}

Session::~Session()
{
    for (const auto& [robot, agv] : d->lines)
        agv->stopNow("The console ends");
    // The lines use the server and the log; they go first.
    for (const auto& [robot, agv] : d->lines)
        delete agv;
    d->lines.clear();
    delete d->uwb;
    delete d->server;
    delete std::exchange(d->tee, nullptr);
    delete d->recorder; // waits until the run is on the disk
}

JogDesk* Session::jogDesk() const { return d->jogDesk; }

void Session::start()
{
    d->recorder->begin(d->plant, d->options.simulated, d->options.solverSeed, d->options.method);
    d->listen();
    d->frameTimer->start();
    d->publish();
}

AlarmDesk& Session::alarms() { return *d->alarms; }

} // namespace agv::session
