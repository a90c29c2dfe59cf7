// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/socket_options.h"

#include <QTcpSocket>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace agv::link {
namespace {

template<typename T>
bool setOption(qintptr descriptor, int level, int name, T value)
{
    return ::setsockopt(static_cast<int>(descriptor), level, name, &value, sizeof value) == 0;
}

} // namespace

bool detectLossQuickly(QTcpSocket& socket)
{
    const qintptr descriptor = socket.socketDescriptor();
    if (descriptor < 0)
        return false;
    socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
    return setOption(descriptor, SOL_SOCKET, SO_KEEPALIVE, 1) &&
           setOption(descriptor, IPPROTO_TCP, TCP_KEEPIDLE, keepAliveIdle_s) &&
           setOption(descriptor, IPPROTO_TCP, TCP_KEEPINTVL, keepAliveInterval_s) &&
           setOption(descriptor, IPPROTO_TCP, TCP_KEEPCNT, keepAliveProbes) &&
           setOption(descriptor, IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<unsigned>(userTimeout_ms));
}

} // namespace agv::link
