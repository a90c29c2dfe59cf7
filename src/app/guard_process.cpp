// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guard_process.h"

#include "app/guard_channel.h"
#include "procedure/zero_burst.h"
#include "protocol/robot_frame.h"

#include <array>
#include <csignal>
#include <cstring>
#include <map>
#include <optional>
#include <poll.h>
#include <span>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <thread>
#include <unistd.h>

namespace agv::app {
namespace {

using namespace std::chrono_literals;

constexpr int console = STDIN_FILENO;
constexpr auto longestWrite = 20ms;      ///< within the interval of the zeros
constexpr auto longestFarewell = 1000ms; ///< for the robots to take the last words and close

bool isReady(int descriptor, short events, std::chrono::milliseconds longest)
{
    pollfd entry{descriptor, events, 0};
    return ::poll(&entry, 1, static_cast<int>(longest.count())) > 0;
}

/// A connection that the console has, too; only the descriptor is our own.
class Connection {
public:
    explicit Connection(int descriptor) : m_descriptor(descriptor) {}
    ~Connection() { ::close(m_descriptor); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// The console hands whole frames to the system (see link::RobotConnection), so a frame may begin here.
    void say(std::span<const std::uint8_t> frame) const
    {
        while (!frame.empty() && isReady(m_descriptor, POLLOUT, longestWrite)) {
            const auto sent = ::send(m_descriptor, frame.data(), frame.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
            if (sent <= 0)
                return;
            frame = frame.subspan(static_cast<std::size_t>(sent));
        }
    }
    /// Closes in order: unread input would turn the close into a reset, which may throw the last words away.
    void finish(std::chrono::steady_clock::time_point latest) const
    {
        ::shutdown(m_descriptor, SHUT_WR);
        std::array<char, 4096> unread{};
        for (auto left = longestFarewell; left > 0ms;
             left = std::chrono::ceil<std::chrono::milliseconds>(latest - std::chrono::steady_clock::now()))
            if (!isReady(m_descriptor, POLLIN, left) ||
                ::recv(m_descriptor, unread.data(), unread.size(), MSG_DONTWAIT) <= 0)
                return;
    }

private:
    int m_descriptor;
};

struct Received {
    GuardMessage message;
    int descriptor = -1;
};

/// Nothing when the console is gone.
std::optional<Received> receive()
{
    Received received;
    iovec data{&received.message, sizeof received.message};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> ancillary{};
    msghdr header{};
    header.msg_iov = &data;
    header.msg_iovlen = 1;
    header.msg_control = ancillary.data();
    header.msg_controllen = ancillary.size();
    if (::recvmsg(console, &header, MSG_CMSG_CLOEXEC) != sizeof received.message)
        return std::nullopt;
    const cmsghdr* attached = CMSG_FIRSTHDR(&header);
    if (attached && attached->cmsg_level == SOL_SOCKET && attached->cmsg_type == SCM_RIGHTS)
        std::memcpy(&received.descriptor, CMSG_DATA(attached), sizeof received.descriptor);
    return received;
}

class Guard {
public:
    void run()
    {
        for (int silences = 0;;) {
            if (!isReady(console, POLLIN, silenceInterval)) {
                if (++silences == 2)
                    standIn();
                continue;
            }
            silences = 0;
            const auto received = receive();
            if (!received)
                break;
            take(*received);
        }
        stopRobots();
        const auto latest = std::chrono::steady_clock::now() + longestFarewell;
        for (const auto& [robot, connection] : m_connections)
            connection.finish(latest);
    }

private:
    void take(const Received& received)
    {
        if (received.message.kind == GuardMessage::Kind::Release)
            m_connections.erase(received.message.robot);
        if (received.message.kind != GuardMessage::Kind::Guard || received.descriptor < 0)
            return;
        m_connections.erase(received.message.robot);
        m_connections.try_emplace(received.message.robot, received.descriptor);
    }
    /// The console is there but does not run: stopped by job control or a debugger, hung, or dumping core.
    void standIn()
    {
        stopRobots();
        const GuardMessage spoke{GuardMessage::Kind::Spoke, 0};
        ::send(console, &spoke, sizeof spoke, MSG_NOSIGNAL | MSG_DONTWAIT);
    }
    void stopRobots() const
    {
        if (m_connections.empty())
            return;
        const protocol::Bytes interrupt = protocol::encodeCommand(protocol::Interrupt{}).value();
        const protocol::Bytes zero = protocol::encodeCommand(protocol::DirectDrive{}).value();
        for (const auto& [robot, connection] : m_connections)
            connection.say(interrupt);
        for (int i = 0; i < procedure::ZeroBurst::repeats; ++i) {
            if (i > 0)
                std::this_thread::sleep_for(procedure::ZeroBurst::interval);
            for (const auto& [robot, connection] : m_connections)
                connection.say(zero);
        }
    }

    std::map<int, Connection> m_connections; ///< by robot
};

} // namespace

int runGuard()
{
    // What ends the console must not end its watchdog: Ctrl-C goes to a whole process group, and
    // "killall agv-console" goes by this name.
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP})
        std::signal(number, SIG_IGN);
    ::prctl(PR_SET_NAME, "agv-guard");
    Guard().run();
    return 0;
}

} // namespace agv::app
