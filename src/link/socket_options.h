// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

class QTcpSocket;

namespace agv::link {

/// A peer that vanished without a word is noticed after this many seconds: by keep-alive probes (idle,
/// interval, count) when nothing is sent, by the user time-out when something is. Neither alone notices both.
inline constexpr int keepAliveIdle_s = 1;
inline constexpr int keepAliveInterval_s = 1;
inline constexpr int keepAliveProbes = 3;
inline constexpr int userTimeout_ms = 3000;

/// Applies the above to a connected socket, and sends small packets at once. False when the system refused.
bool detectLossQuickly(QTcpSocket& socket);

} // namespace agv::link
