// SPDX-License-Identifier: GPL-3.0-or-later
// From the release of the drive pad to zero on the wire: the session in its thread as in the program, a robot
// on a real socket, while 10,000 messages a second come in from four readers and a UWB unit. The time runs
// from the moment the window would say "released" to the moment the robot's program has the zero in hand.
//     bench_jog_stop [PRESSES] [--quiet]        --quiet: without the messages
#include "bench/message_flood.h"
#include "bench/wire_watch.h"
#include "core/random.h"
#include "link/pseudo_terminal.h"
#include "session/jog_desk.h"
#include "session/session.h"

#include <QCoreApplication>
#include <QThread>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>

using namespace agv;
using namespace std::chrono_literals;

namespace {

Time now() { return std::chrono::steady_clock::now(); }

PlantLayout plantOf(const bench::MessageFlood& flood, const std::string& unit)
{
    PlantLayout plant;
    plant.name = "Bench";
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    plant.floorTags = tagGrid(3, 3, 0.1, {0.3, 0.3}, TagUid{0xE00401503A5B0000});
    for (int i = 0; i < int(bench::MessageFlood::readers); ++i) {
        AgvConfig agv;
        agv.id = {i + 1};
        agv.robotHost = "127.0.0." + std::to_string(i + 2);
        agv.reader = {"127.0.0.1", flood.readerPort(std::size_t(i))};
        plant.agvs.push_back(agv);
    }
    plant.anchors = {{0, "A0", 0, 0, 2, true},
                     {1, "A1", 3, 0, 2, true},
                     {2, "A2", 3, 4, 2, true},
                     {3, "A3", 0, 4, 2, true}};
    plant.uwb.port.path = unit;
    plant.robotListen = {"127.0.0.1", 0};
    plant.telemetryPort = 0;
    return plant;
}

void printSpread(const char* name, std::vector<double>& ms)
{
    std::ranges::sort(ms);
    const auto at = [&](double part) {
        return ms[std::min(ms.size() - 1, static_cast<std::size_t>(part * static_cast<double>(ms.size())))];
    };
    std::printf("%-34s n %5zu   median %7.3f   p95 %7.3f   p99 %7.3f   max %7.3f ms\n", name, ms.size(),
                at(0.5), at(0.95), at(0.99), ms.back());
}

/// The window's side, in this thread: words to the session, queued as the window's signals are.
class Hand {
public:
    explicit Hand(session::JogDesk* desk) : m_desk(desk) {}

    void press()
    {
        ++m_press;
        say([](session::JogDesk& desk, const JogCommand& command) { desk.press(1, command); });
    }
    /// Says every 50 ms that it holds.
    void holdFor(Duration time)
    {
        const Time end = now() + time;
        for (Time next = now() + 50ms; next < end; next += 50ms) {
            std::this_thread::sleep_until(next);
            say([](session::JogDesk& desk, const JogCommand& command) { desk.hold(1, command); });
        }
        std::this_thread::sleep_until(end);
    }
    Time release()
    {
        const Time letGo = now();
        say([](session::JogDesk& desk, const JogCommand& command) {
            desk.release(1, command, JogReason::Released);
        });
        return letGo;
    }
    Time lastWord() const { return m_lastWord; }

private:
    template<typename Word>
    void say(Word word)
    {
        m_lastWord = now();
        const JogCommand command{JogSource::Pad, m_press, {0.1, 0.1}, m_lastWord};
        QMetaObject::invokeMethod(
            m_desk, [desk = m_desk, command, word] { word(*desk, command); }, Qt::QueuedConnection);
    }

    session::JogDesk* m_desk;
    std::uint32_t m_press = 0;
    Time m_lastWord;
};

struct Figures {
    std::vector<double> stop_ms, start_ms, frozen_ms;
    std::size_t motionsAfterZero = 0;
    int missing = 0;
};

void measure(Hand& hand, bench::WireWatch& wire, int presses, Figures& figures)
{
    SplitMix64 random(1);
    const auto ms = [](Duration time) { return 1e3 * secondsFrom(time); };
    for (int i = 0; i < presses; ++i) {
        const std::size_t before = wire.count();
        hand.press();
        const auto driven = wire.wait(before, false);
        const Time pressed = hand.lastWord();
        hand.holdFor(std::chrono::milliseconds(20 + random.next() % 60));
        const std::size_t held = wire.count();
        const Time letGo = hand.release();
        const auto stopped = wire.wait(held, true);
        if (!driven || !stopped) {
            ++figures.missing;
            continue;
        }
        figures.start_ms.push_back(ms(driven->time - pressed));
        figures.stop_ms.push_back(ms(stopped->time - letGo));
        figures.motionsAfterZero += wire.motions(held, stopped->time);
    }
    for (int i = 0; i < std::max(presses / 20, 1); ++i) { // the window hangs: no release, no more words
        const std::size_t before = wire.count();
        hand.press();
        const bool drives = wire.wait(before, false).has_value();
        const std::size_t held = wire.count();
        hand.holdFor(120ms);
        const auto stopped = drives ? wire.wait(held, true) : std::nullopt;
        if (stopped)
            figures.frozen_ms.push_back(ms(stopped->time - hand.lastWord()));
        else
            ++figures.missing;
        hand.release();
    }
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const bool isQuiet = argc > 1 && std::strcmp(argv[argc - 1], "--quiet") == 0;
    const int presses = argc > 1 && std::atoi(argv[1]) > 0 ? std::atoi(argv[1]) : 1000;

    PseudoTerminal unit;
    bench::MessageFlood flood(unit.descriptor());
    auto* session = new session::Session(plantOf(flood, unit.path().toStdString()), {});
    QThread thread;
    session->moveToThread(&thread);
    QObject::connect(&thread, &QThread::finished, session, &QObject::deleteLater);
    std::atomic<int> port = 0;
    std::atomic<std::uint64_t> received = 0;
    QObject::connect(session, &session::Session::listening, session, [&](quint16 robots) { port = robots; });
    QObject::connect(session, &session::Session::snapshotReady, session, [&](const PlantSnapshot& snapshot) {
        std::uint64_t sum = snapshot.uwb ? snapshot.uwb->link.received : 0;
        for (const AgvSnapshot& agv : snapshot.agvs)
            sum += agv.readerLink.received;
        received = sum;
    });
    thread.start(QThread::TimeCriticalPriority); // as the program does
    QMetaObject::invokeMethod(session, [session] {
        session->start();
        for (int robot = 1; robot <= int(bench::MessageFlood::readers); ++robot)
            session->openReader(robot);
        session->openUwb();
    });
    while (port == 0)
        std::this_thread::sleep_for(1ms);
    if (!isQuiet)
        flood.start();
    bench::WireWatch wire("127.0.0.2", static_cast<std::uint16_t>(port.load()));
    std::this_thread::sleep_for(1s); // connections, and the zeros that a robot is greeted with
    Hand hand(session->jogDesk());
    Figures figures;
    const std::uint64_t receivedBefore = received;
    const Time begin = now();
    if (wire.isConnected())
        measure(hand, wire, presses, figures);
    const double rate = static_cast<double>(received - receivedBefore) / secondsFrom(now() - begin);
    thread.quit();
    thread.wait();
    if (figures.stop_ms.empty() || figures.frozen_ms.empty()) {
        std::fprintf(stderr, "nothing was measured: the robot got no command\n");
        return 1;
    }
    std::printf("%.0f messages per second received\n", rate);
    printSpread("release to zero on the wire", figures.stop_ms);
    printSpread("press to first command", figures.start_ms);
    printSpread("last word of a frozen window to zero", figures.frozen_ms);
    std::printf("commands to drive after the zero: %zu, missing: %d\n", figures.motionsAfterZero,
                figures.missing);
    return figures.motionsAfterZero == 0 && figures.missing == 0 ? 0 : 1;
}
