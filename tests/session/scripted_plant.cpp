// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scripted_plant.h"

#include "link/vanishing_peer.h"

#include <QEventLoop>
#include <QTest>

#include <algorithm>
#include <span>
#include <utility>

namespace agv::session {

using namespace std::chrono_literals;

namespace {

/// A robot that has not driven says nothing, and is called silent if the rest takes a while.
bool isConnected(LinkState state) { return state == LinkState::Up || state == LinkState::Silent; }

} // namespace

ScriptedReader::ScriptedReader()
{
    listen();
    QObject::connect(&m_server, &QTcpServer::newConnection, this, [this] {
        while (QTcpSocket* socket = m_server.nextPendingConnection()) {
            ++m_connectionsEver;
            m_clients.push_back(socket);
            QObject::connect(socket, &QTcpSocket::disconnected, this, [this, socket] {
                std::erase(m_clients, socket);
                socket->deleteLater();
            });
        }
    });
    QObject::connect(&m_timer, &QTimer::timeout, this, [this] {
        m_firstTag = !m_firstTag;
        if (!m_mute)
            say(m_firstTag ? "SCAN:+UID=E004000000000001,+RSSI=3/2\r\n"
                           : "SCAN:+UID=E004000000000002,+RSSI=5\r");
    });
    m_timer.start(5ms);
}

void ScriptedReader::listen()
{
    m_server.listen(QHostAddress::LocalHost, m_port);
    m_port = m_server.serverPort();
}

void ScriptedReader::cut()
{
    m_server.close();
    for (QTcpSocket* socket : std::vector(m_clients))
        socket->abort();
}

void ScriptedReader::vanish()
{
    m_mute = true;
    QVERIFY(link::vanish(m_server));
    for (const QTcpSocket* socket : m_clients)
        QVERIFY(link::vanish(*socket));
}

void ScriptedReader::say(const QByteArray& bytes)
{
    for (QTcpSocket* socket : m_clients)
        socket->write(bytes);
}

void ScriptedRobot::connectTo(quint16 port)
{
    m_stream.reset();
    m_socket = std::make_unique<QTcpSocket>();
    QVERIFY(m_socket->bind(QHostAddress(m_address)));
    QObject::connect(m_socket.get(), &QTcpSocket::readyRead, this, [this] {
        const QByteArray bytes = m_socket->readAll();
        m_stream.feed({reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size())},
                      [this](const protocol::RobotCommand& command) { take(command); });
    });
    m_socket->connectToHost(QHostAddress::LocalHost, port);
}

void ScriptedRobot::cut() { m_socket->abort(); }

void ScriptedRobot::vanish() { QVERIFY(link::vanish(*m_socket)); }

void ScriptedRobot::report(const protocol::RobotReport& report)
{
    const protocol::Bytes bytes = protocol::encodeReportFrame(report).value();
    m_socket->write(reinterpret_cast<const char*>(bytes.data()), qint64(bytes.size()));
}

void ScriptedRobot::take(const protocol::RobotCommand& command)
{
    m_wire.push_back(command);
    m_times.push_back(std::chrono::steady_clock::now());
    if (const auto* drive = std::get_if<protocol::DirectDrive>(&command)) {
        const bool drove = std::exchange(m_drives, drive->speeds != WheelSpeeds{});
        if (drove && !m_drives)
            report(protocol::StateUpdate{RobotState::Idle});
    }
    const auto* segments = std::get_if<protocol::AddSegments>(&command);
    if (!segments || !answersSegments)
        return;
    QTimer::singleShot(80, m_socket.get(), [this, number = segments->firstNumber] {
        report(protocol::SegmentDone{number, 0});
        report(protocol::SegmentDone{number + 1, 0});
        ++m_segmentsDone;
    });
}

int ScriptedRobot::motionsAfter(std::size_t index) const
{
    return int(std::count_if(m_wire.begin() + std::ptrdiff_t(index), m_wire.end(), [](const auto& command) {
        const auto* drive = std::get_if<protocol::DirectDrive>(&command);
        return (drive && drive->speeds != WheelSpeeds{}) ||
               std::holds_alternative<protocol::AddSegments>(command);
    }));
}

int ScriptedRobot::zerosAfter(std::size_t index) const
{
    return int(std::count(m_wire.begin() + std::ptrdiff_t(index), m_wire.end(),
                          protocol::RobotCommand(protocol::DirectDrive{})));
}

std::size_t ScriptedRobot::behindLastMotion() const
{
    std::size_t index = m_wire.size();
    while (index > 0 && motionsAfter(index - 1) == 0)
        --index;
    return index;
}

PlantLayout ScriptedPlant::layout(quint16 readerPort)
{
    PlantLayout plant;
    plant.name = "Scripted";
    plant.width_m = 1.0;
    plant.height_m = 1.0;
    plant.floorTags = tagGrid(5, 5, 0.1, {0.3, 0.3}, TagUid{0xE004000000000001});
    AgvConfig agv;
    agv.id = {1};
    agv.robotHost = "127.0.0.2";
    agv.reader = {"127.0.0.1", readerPort};
    plant.agvs = {agv};
    plant.robotListen = {"127.0.0.1", 0};
    plant.telemetryPort = 0;
    return plant;
}

TurnParameters ScriptedPlant::quickTurn(TurnKind kind)
{
    TurnParameters parameters;
    parameters.kind = kind;
    parameters.turnTime_s = 0.1;
    parameters.settle_s = 0.03;
    parameters.minDwell_s = 0.06;
    parameters.maxDwell_s = 5.0;
    return parameters;
}

ScriptedPlant::ScriptedPlant(SolveMethod method, RecordingOptions recording)
{
    SessionOptions options;
    options.method = method;
    options.recording = std::move(recording);
    session = std::make_unique<Session>(layout(reader.port()), options);
    QObject::connect(session.get(), &Session::listening, [this](quint16 tcp, quint16 udp) {
        port = tcp;
        telemetryPort = udp;
    });
    QObject::connect(session.get(), &Session::snapshotReady,
                     [this](const PlantSnapshot& snapshot) { last = snapshot; });
    QObject::connect(session.get(), &Session::eventLogged,
                     [this](const EventEntry& event) { events.push_back(event); });
    QObject::connect(session.get(), &Session::turnPhaseChanged, [this](int, TurnPhase now, int at, Time) {
        phase = now;
        stop = at;
    });
    QObject::connect(session.get(), &Session::turnEnded,
                     [this](int, const TurnSnapshot& turn, std::shared_ptr<const TurnRecord> reads) {
                         ended.push_back(turn);
                         record = std::move(reads);
                     });
    session->start();
}

// Its last events still go into the members above.
ScriptedPlant::~ScriptedPlant() { endSession(); }

bool ScriptedPlant::bringUp()
{
    session->openReader(1);
    robot.connectTo(port);
    const std::size_t before = robot.wire().size();
    const bool isUp = QTest::qWaitFor(
        [this, before] {
            return last.agvs.size() == 1 && agv().readerLink.state == LinkState::Up &&
                   isConnected(agv().robotLink.state) && agv().readerLink.received > 0 &&
                   robot.zerosAfter(before) >= 5;
        },
        20000);
    if (!isUp)
        describe();
    return isUp;
}

void ScriptedPlant::describe() const
{
    qWarning("%d zeros on the wire", robot.zerosAfter(0));
    for (const AgvSnapshot& shown : last.agvs) {
        for (const LinkSnapshot& link : {shown.readerLink, shown.robotLink})
            qWarning("%s: state %d, %llu received, %s", link.name.c_str(), int(link.state),
                     static_cast<unsigned long long>(link.received), link.reason.c_str());
    }
    for (const EventEntry& event : events)
        qWarning("%lld %s: %s", static_cast<long long>(event.utc_ms), event.source.c_str(),
                 event.text.c_str());
}

bool ScriptedPlant::reach(TurnPhase wanted, int at)
{
    if (phase == wanted && stop == at)
        return true;
    // Polling could miss a phase of 30 ms on a busy computer.
    QEventLoop loop;
    QObject::connect(session.get(), &Session::turnPhaseChanged, &loop, [&](int, TurnPhase now, int newStop) {
        if (now == wanted && newStop == at)
            loop.exit(0);
    });
    QTimer::singleShot(30s, &loop, [&loop] { loop.exit(1); });
    return loop.exec() == 0;
}

bool ScriptedPlant::logged(EventLevel level, const char* part) const
{
    return std::ranges::any_of(events, [&](const EventEntry& event) {
        return event.level == level && event.text.find(part) != std::string::npos;
    });
}

} // namespace agv::session
