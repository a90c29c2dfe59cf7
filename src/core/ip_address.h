// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace agv {

/// True for an IPv4 or IPv6 address in numbers, such as "192.168.1.2" or "fe80::1"; names are none.
bool isIpAddress(const std::string& text);

/// The address of robot `id` by the rule of the old program, where a robot's number was the last digit of
/// its address minus 1: the one nearest to that in the network of `console` ("192.168.1.200", 1 ->
/// "192.168.1.2"). Nothing for an id that is not 1 to 8 or a console without an IPv4 address of its own.
std::optional<std::string> usualRobotHost(const std::string& console, int id);

} // namespace agv
