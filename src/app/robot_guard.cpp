// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robot_guard.h"

#include <QThread>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace agv::app {
namespace {

constexpr std::chrono::seconds respawnInterval(3);
constexpr std::chrono::minutes reportInterval(1);
constexpr int reapTries = 400;
constexpr unsigned long reapInterval_ms = 5;

/// Starts this program as the watchdog with `channel` as its standard input. Returns errno, 0: started.
int startWatchdog(int channel, pid_t& process)
{
    posix_spawn_file_actions_t files{};
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, channel, STDIN_FILENO);
    // Not the console's own: who reads them must see their end when the console ends.
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
    posix_spawnattr_t attributes{};
    ::posix_spawnattr_init(&attributes);
    // A session of its own: what is sent to the console's process group must not reach it.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
    std::string name = "agv-guard"; // not found by "pkill -f agv-console"
    std::string command = guardCommand;
    const std::array<char*, 3> arguments{name.data(), command.data(), nullptr};
    const int error =
        ::posix_spawn(&process, "/proc/self/exe", &files, &attributes, arguments.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
    return error;
}

} // namespace

RobotGuard::RobotGuard() : m_beat(this), m_respawn(this)
{
    m_beat.setInterval(beatInterval);
    m_respawn.setSingleShot(true);
    m_respawn.setInterval(respawnInterval);
    connect(&m_beat, &QTimer::timeout, this, &RobotGuard::beat);
    connect(&m_respawn, &QTimer::timeout, this, &RobotGuard::spawn);
}

RobotGuard::~RobotGuard() { end(); }

void RobotGuard::start()
{
    spawn();
    m_beat.start();
}

void RobotGuard::spawn()
{
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        m_respawn.start();
        reportFailure(QString::fromLocal8Bit(std::strerror(errno)));
        return;
    }
    const int error = startWatchdog(ends[1], m_process);
    ::close(ends[1]);
    m_channel = ends[0];
    if (error != 0) {
        m_process = -1;
        end();
        m_respawn.start();
        reportFailure(QString::fromLocal8Bit(std::strerror(error)));
        return;
    }
    m_notifier = std::make_unique<QSocketNotifier>(m_channel, QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &RobotGuard::onReadable);
    for (const auto& [robot, descriptor] : m_descriptors)
        send(GuardMessage::Kind::Guard, robot, descriptor);
}

void RobotGuard::reportFailure(const QString& reason)
{
    if (m_lastReport.isValid() && m_lastReport.elapsed() < std::chrono::milliseconds(reportInterval).count())
        return;
    m_lastReport.start();
    emit failed(reason);
}

void RobotGuard::end()
{
    m_notifier.reset();
    if (m_channel >= 0)
        ::close(std::exchange(m_channel, -1));
    if (m_process > 0)
        reap();
}

void RobotGuard::reap()
{
    const pid_t process = std::exchange(m_process, -1);
    for (int i = 0; i < reapTries; ++i) { // it ends with the channel
        if (::waitpid(process, nullptr, WNOHANG) != 0)
            return;
        QThread::msleep(reapInterval_ms);
    }
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
}

void RobotGuard::onReadable()
{
    GuardMessage message;
    const auto size = ::recv(m_channel, &message, sizeof message, MSG_DONTWAIT);
    if (size == sizeof message) {
        if (message.kind == GuardMessage::Kind::Spoke)
            emit robotsStopped();
        return;
    }
    if (size < 0 && (errno == EAGAIN || errno == EINTR))
        return;
    m_notifier->setEnabled(false);
    m_notifier.release()->deleteLater(); // its signal is being delivered
    end();
    m_respawn.start();
    reportFailure(QStringLiteral("it ended"));
}

void RobotGuard::beat() { send(GuardMessage::Kind::Beat, 0); }

void RobotGuard::guard(int robot, int descriptor)
{
    m_descriptors[robot] = descriptor;
    send(GuardMessage::Kind::Guard, robot, descriptor);
}

void RobotGuard::release(int robot)
{
    if (m_descriptors.erase(robot) > 0)
        send(GuardMessage::Kind::Release, robot);
}

void RobotGuard::send(GuardMessage::Kind kind, int robot, std::optional<int> descriptor)
{
    if (m_channel < 0)
        return;
    GuardMessage message{kind, robot};
    iovec data{&message, sizeof message};
    msghdr header{};
    header.msg_iov = &data;
    header.msg_iovlen = 1;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> ancillary{};
    if (descriptor) {
        header.msg_control = ancillary.data();
        header.msg_controllen = ancillary.size();
        cmsghdr* attached = CMSG_FIRSTHDR(&header);
        attached->cmsg_level = SOL_SOCKET;
        attached->cmsg_type = SCM_RIGHTS;
        attached->cmsg_len = CMSG_LEN(sizeof(int));
        std::memcpy(CMSG_DATA(attached), &*descriptor, sizeof(int));
    }
    // A watchdog that has ended is noticed by onReadable().
    [[maybe_unused]] const auto sent = ::sendmsg(m_channel, &header, MSG_NOSIGNAL | MSG_DONTWAIT);
}

} // namespace agv::app
