// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/output_queue.h"

#include <utility>

namespace agv::link {

bool OutputQueue::push(QByteArray message)
{
    if (m_messages.size() >= maxMessages)
        return false;
    m_messages.push_back({std::move(message), false});
    return true;
}

void OutputQueue::pushUrgent(QByteArray message)
{
    std::erase_if(m_messages, [](const Message& waiting) { return !waiting.urgent; });
    if (m_messages.size() >= maxMessages)
        m_messages.pop_front();
    m_messages.push_back({std::move(message), true});
}

std::optional<QByteArray> OutputQueue::pop()
{
    if (m_messages.empty())
        return std::nullopt;
    QByteArray bytes = std::move(m_messages.front().bytes);
    m_messages.pop_front();
    return bytes;
}

} // namespace agv::link
