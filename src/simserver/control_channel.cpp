// SPDX-License-Identifier: GPL-3.0-or-later
#include "simserver/control_channel.h"

#include <array>
#include <cerrno>
#include <unistd.h>

namespace agv::simserver {

ControlChannel::ControlChannel(PlantServer& server, int input, QObject* parent)
    : QObject(parent),
      m_commands(server, [this](const QByteArray& json) { emit line(json); }),
      m_input(input),
      m_notifier(input, QSocketNotifier::Read)
{
    connect(&m_notifier, &QSocketNotifier::activated, this, &ControlChannel::readInput);
    connect(&server, &PlantServer::event, this,
            [this](const QJsonObject& message) { emit line(CommandLines::compact(message)); });
}

void ControlChannel::readInput()
{
    std::array<char, 4096> bytes{};
    const auto count = ::read(m_input, bytes.data(), bytes.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN))
        return;
    if (count <= 0) {
        m_notifier.setEnabled(false);
        m_commands.finish();
        emit inputEnded();
        return;
    }
    m_commands.feed({bytes.data(), static_cast<qsizetype>(count)});
}

} // namespace agv::simserver
