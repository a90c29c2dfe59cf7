// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <deque>
#include <optional>

namespace agv::link {

/// Messages that wait for a slow peer. Bounded; an urgent message (zero wheel speed) overtakes and discards
/// the ordinary ones that wait, because a command from before a stop must not come after it.
class OutputQueue {
public:
    static constexpr std::size_t maxMessages = 32;

    /// False when the queue is full: the message is not taken.
    bool push(QByteArray message);
    /// Always taken; the oldest urgent message makes room when there are too many.
    void pushUrgent(QByteArray message);
    std::optional<QByteArray> pop();
    std::size_t size() const { return m_messages.size(); }

private:
    struct Message {
        QByteArray bytes;
        bool urgent = false;
    };
    std::deque<Message> m_messages;
};

} // namespace agv::link
