// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QSocketNotifier>

#include "simserver/command_lines.h"

namespace agv::simserver {

/// Steers a PlantServer by lines of text: trainer commands in from a file descriptor (standard input), one
/// compact JSON object out per command or event.
class ControlChannel : public QObject {
    Q_OBJECT
public:
    /// `input` stays the caller's and must outlive this object.
    ControlChannel(PlantServer& server, int input, QObject* parent = nullptr);

signals:
    void line(const QByteArray& json); ///< one output line, without its end
    void inputEnded();                 ///< end of file or a read error; no more commands come

private:
    void readInput();

    CommandLines m_commands;
    int m_input;
    QSocketNotifier m_notifier;
};

} // namespace agv::simserver
