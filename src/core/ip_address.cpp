// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ip_address.h"

#include <array>

#include <arpa/inet.h>
#include <netinet/in.h>

namespace agv {

bool isIpAddress(const std::string& text)
{
    std::array<unsigned char, sizeof(in6_addr)> address{};
    // The system reads up to a NUL; a text that has one inside is no address.
    return text.find('\0') == std::string::npos && (::inet_pton(AF_INET, text.c_str(), address.data()) == 1 ||
                                                    ::inet_pton(AF_INET6, text.c_str(), address.data()) == 1);
}

std::optional<std::string> usualRobotHost(const std::string& console, int id)
{
    constexpr int mostId = 8; // the last digit of the address is 2 to 9
    in_addr address{};
    if (id < 1 || id > mostId || ::inet_pton(AF_INET, console.c_str(), &address) != 1 ||
        address.s_addr == INADDR_ANY)
        return std::nullopt;
    return console.substr(0, console.rfind('.') + 1) + std::to_string(id + 1);
}

} // namespace agv
