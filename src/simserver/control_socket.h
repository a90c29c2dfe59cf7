// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocalServer>
#include <QObject>

#include "simserver/command_lines.h"

namespace agv::simserver {

/// Steers a PlantServer over a local socket, any number of clients at a time, this user only: trainer
/// commands in, one line of JSON out per command. So a plant whose standard input belongs to the console can
/// be steered while the console runs.
class ControlSocket : public QObject {
    Q_OBJECT
public:
    explicit ControlSocket(PlantServer& server, QObject* parent = nullptr);

    /// A socket that a killed program left behind is replaced. InUse: another program listens there, or there
    /// is a file of another kind. Io: the socket cannot be made, and why.
    Result<void> listen(const QString& path);

private:
    void accept();

    PlantServer& m_plant;
    QLocalServer m_server;
};

} // namespace agv::simserver
