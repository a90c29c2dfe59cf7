// SPDX-License-Identifier: GPL-3.0-or-later
#include "simserver/command_lines.h"

#include <QJsonDocument>

#include <utility>

namespace agv::simserver {
namespace {

constexpr qsizetype longestLine = 4096;

QJsonObject errorMessage(const std::string& detail) { return {{"error", QString::fromStdString(detail)}}; }

} // namespace

void CommandLines::feed(const QByteArray& text)
{
    m_pending.append(text);
    for (qsizetype end = m_pending.indexOf('\n'); end >= 0; end = m_pending.indexOf('\n')) {
        const QByteArray command = m_pending.left(end);
        m_pending.remove(0, end + 1);
        if (!std::exchange(m_discarding, false) && !command.trimmed().isEmpty())
            execute(command);
    }
    if (m_pending.size() > longestLine) {
        m_pending.clear();
        if (!std::exchange(m_discarding, true))
            m_answer(compact(errorMessage("command longer than 4096 characters; it was ignored")));
    }
}

void CommandLines::finish()
{
    const QByteArray last = std::exchange(m_pending, {});
    if (!std::exchange(m_discarding, false) && !last.trimmed().isEmpty())
        execute(last);
}

void CommandLines::execute(const QByteArray& command)
{
    const auto parsed =
        simulation::parseTrainerCommand({command.data(), static_cast<std::size_t>(command.size())});
    if (!parsed)
        return m_answer(compact(errorMessage(parsed.error().detail)));
    const auto answer = m_server.execute(*parsed);
    m_answer(compact(answer ? *answer : errorMessage(answer.error().detail)));
}

QByteArray CommandLines::compact(const QJsonObject& message)
{
    return QJsonDocument(message).toJson(QJsonDocument::Compact);
}

} // namespace agv::simserver
