// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QTimer>

#include <linux/filter.h>
#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

namespace agv::link {

/// From now on the system throws away whatever arrives for this socket before TCP sees it. To the other side
/// the peer is gone without a word, as a bridge that lost its power: no FIN, no RST, no acknowledgement.
/// False when the system refused.
inline bool vanish(qintptr descriptor)
{
    sock_filter dropEverything{BPF_RET | BPF_K, 0, 0, 0};
    const sock_fprog program{1, &dropEverything};
    return ::setsockopt(static_cast<int>(descriptor), SOL_SOCKET, SO_ATTACH_FILTER, &program,
                        sizeof program) == 0;
}
/// The same once everything it wrote has been acknowledged: what it would send again is still let through,
/// and a peer that is gone sends nothing.
inline bool vanish(const QTcpSocket& socket)
{
    const int descriptor = static_cast<int>(socket.socketDescriptor());
    const auto isAcknowledged = [&] {
        int unacknowledged = 0;
        return socket.bytesToWrite() == 0 && ::ioctl(descriptor, SIOCOUTQ, &unacknowledged) == 0 &&
               unacknowledged == 0;
    };
    return QTest::qWaitFor(isAcknowledged) && vanish(descriptor);
}
/// Attempts to connect to it are never answered.
inline bool vanish(const QTcpServer& server) { return vanish(server.socketDescriptor()); }

/// Whether `noticed` becomes true within the 5 s that a loss may go unnoticed. Counted in beats of the event
/// loop, not by the clock: a busy computer that runs neither the test nor the code tested is no failure.
template<typename Condition>
bool noticedWithinFiveSeconds(Condition noticed)
{
    using namespace std::chrono_literals;
    constexpr auto beat = 20ms;
    int beats = 0;
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer, &QTimer::timeout, [&beats] { ++beats; });
    timer.start(beat);
    constexpr int never_ms = 120'000;
    return QTest::qWaitFor([&] { return noticed() || beats * beat > 5s; }, never_ms) && noticed();
}

} // namespace agv::link
