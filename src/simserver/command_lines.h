// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "simserver/plant_server.h"

#include <functional>

namespace agv::simserver {

/// Cuts text into trainer commands, carries them out on a PlantServer, and gives one compact JSON object per
/// command. A bad command gets {"error":"..."} and does nothing; so does a line of over 4096 characters.
class CommandLines {
public:
    using Answer = std::function<void(const QByteArray& json)>; ///< one line, without its end

    CommandLines(PlantServer& server, Answer answer) : m_server(server), m_answer(std::move(answer)) {}

    void feed(const QByteArray& text);
    /// The text ends here: its last line needs no end.
    void finish();

    static QByteArray compact(const QJsonObject& message);

private:
    void execute(const QByteArray& command);

    PlantServer& m_server;
    Answer m_answer;
    QByteArray m_pending;
    bool m_discarding = false;
};

} // namespace agv::simserver
