// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"

#include <arpa/inet.h>
#include <array>
#include <chrono>
#include <cstdio>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace agv::bench {

/// TCP socket that listens on a free port of 127.0.0.1.
inline int listeningSocket(std::uint16_t& port)
{
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (::bind(server, reinterpret_cast<const sockaddr*>(&address), size) != 0 || ::listen(server, 4) != 0 ||
        ::getsockname(server, reinterpret_cast<sockaddr*>(&address), &size) != 0)
        std::perror("reader socket");
    port = ntohs(address.sin_port);
    return server;
}

/// Four readers and a UWB unit that together say 10,000 messages a second, from a thread of their own: eight
/// reader lines and two UWB reports each millisecond.
class MessageFlood {
public:
    /// `unit`: the device end of the UWB unit's serial line.
    explicit MessageFlood(int unit) : m_unit(unit)
    {
        for (std::size_t i = 0; i < m_servers.size(); ++i)
            m_servers[i] = listeningSocket(m_ports[i]);
    }
    ~MessageFlood()
    {
        m_thread = {}; // ends it
        for (const int descriptor : m_clients)
            ::close(descriptor);
        for (const int descriptor : m_servers)
            ::close(descriptor);
    }
    MessageFlood(const MessageFlood&) = delete;
    MessageFlood& operator=(const MessageFlood&) = delete;

    std::uint16_t readerPort(std::size_t reader) const { return m_ports[reader]; }
    /// Once the console has connected to every reader, which this waits for.
    void start()
    {
        for (const int server : m_servers)
            m_clients.push_back(::accept4(server, nullptr, nullptr, SOCK_CLOEXEC));
        m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }

    static constexpr std::size_t readers = 4;

private:
    void run(const std::stop_token& stop)
    {
        auto next = std::chrono::steady_clock::now();
        for (unsigned tick = 0; !stop.stop_requested(); ++tick) {
            const std::string lines = readerLine(2 * tick) + readerLine(2 * tick + 1);
            for (const int client : m_clients) [[maybe_unused]]
                const auto sent = ::send(client, lines.data(), lines.size(), MSG_NOSIGNAL);
            const std::string reports = report(2 * tick) + report(2 * tick + 1);
            [[maybe_unused]] const auto written = ::write(m_unit, reports.data(), reports.size());
            next += std::chrono::milliseconds(1); // what is late is made up for
            std::this_thread::sleep_until(next);
        }
    }
    static std::string readerLine(unsigned number)
    {
        std::array<char, 64> line{};
        std::snprintf(line.data(), line.size(), "SCAN:+UID=E00401503A5B%04X,+RSSI=%u/%u\r\n", number % 9,
                      number % 7, number % 5);
        return line.data();
    }
    static std::string report(unsigned number)
    {
        std::array<char, 96> line{};
        std::snprintf(line.data(), line.size(),
                      "mc 0f 00000663 000005a3 00000512 000004cb %04x %02x %08x a%u:0\r\n", number & 0xffffU,
                      (number / 4) & 0xffU, number * 10, number % 4);
        return line.data();
    }

    int m_unit;
    std::array<int, readers> m_servers{};
    std::array<std::uint16_t, readers> m_ports{};
    std::vector<int> m_clients;
    std::jthread m_thread;
};

} // namespace agv::bench
