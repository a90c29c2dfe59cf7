// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "protocol/robot_frame.h"
#include "protocol/robot_stream.h"

#include <arpa/inet.h>
#include <array>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace agv::bench {

/// A robot that does nothing but note when which drive command came out of the wire, in a thread of its own.
class WireWatch {
public:
    struct Drive {
        WheelSpeeds speeds;
        Time time;
    };

    /// Connects from `address` to the console at 127.0.0.1.
    WireWatch(const char* address, std::uint16_t consolePort)
        : m_socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        ::inet_pton(AF_INET, address, &own.sin_addr);
        sockaddr_in console = own;
        console.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        console.sin_port = htons(consolePort);
        m_isConnected = ::bind(m_socket, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0 &&
                        ::connect(m_socket, reinterpret_cast<const sockaddr*>(&console), sizeof console) == 0;
        m_thread = std::jthread([this] { run(); });
    }
    ~WireWatch()
    {
        ::shutdown(m_socket, SHUT_RDWR);
        m_thread = {};
        ::close(m_socket);
    }
    WireWatch(const WireWatch&) = delete;
    WireWatch& operator=(const WireWatch&) = delete;

    bool isConnected() const { return m_isConnected; }
    std::size_t count()
    {
        const std::lock_guard lock(m_mutex);
        return m_drives.size();
    }
    /// The first command from `index` on that is zero, or drives; nothing after five seconds.
    std::optional<Drive> wait(std::size_t index, bool zero)
    {
        std::optional<Drive> found;
        std::unique_lock lock(m_mutex);
        m_news.wait_for(lock, std::chrono::seconds(5), [&] {
            for (; index < m_drives.size() && !found; ++index)
                if ((m_drives[index].speeds == WheelSpeeds{}) == zero)
                    found = m_drives[index];
            return found.has_value();
        });
        return found;
    }
    /// Commands to drive from `index` on that came after `after`.
    std::size_t motions(std::size_t index, Time after)
    {
        const std::lock_guard lock(m_mutex);
        std::size_t count = 0;
        for (; index < m_drives.size(); ++index)
            count += m_drives[index].speeds != WheelSpeeds{} && m_drives[index].time > after;
        return count;
    }

private:
    void run()
    {
        protocol::CommandStream stream;
        std::array<std::uint8_t, 4096> bytes{};
        while (true) {
            const auto received = ::recv(m_socket, bytes.data(), bytes.size(), 0);
            const Time now = std::chrono::steady_clock::now();
            if (received <= 0)
                return;
            stream.feed({bytes.data(), static_cast<std::size_t>(received)},
                        [&](const protocol::RobotCommand& command) {
                            const auto* drive = std::get_if<protocol::DirectDrive>(&command);
                            if (!drive)
                                return;
                            const std::lock_guard lock(m_mutex);
                            m_drives.push_back({drive->speeds, now});
                        });
            m_news.notify_all();
        }
    }

    int m_socket;
    bool m_isConnected = false;
    std::mutex m_mutex;
    std::condition_variable m_news;
    std::vector<Drive> m_drives;
    std::jthread m_thread; ///< last: gone before what it fills
};

} // namespace agv::bench
