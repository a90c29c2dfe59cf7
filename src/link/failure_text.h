// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractSocket>
#include <QString>

#include "core/plant_layout.h"
#include "core/result.h"

namespace agv::link {

/// Whether another try may help without the operator.
bool isTransient(QAbstractSocket::SocketError error);

/// Why a connection to `peer` failed or ended, and what to do; plain English. `systemText` is what the system
/// says about errors that have no sentence of their own.
QString connectionFailureText(QAbstractSocket::SocketError error, bool wasConnected, const Endpoint& peer,
                              const QString& systemText);

/// The same for a connection that a robot made to the console. It serves no other clients, as a WeMos does.
QString robotLossText(QAbstractSocket::SocketError error, const Endpoint& robot, const QString& systemText);

/// Why `local` cannot be listened on, and what to do. `protocol`: "TCP" or "UDP".
Error listenFailure(QAbstractSocket::SocketError error, const char* protocol, const Endpoint& local,
                    const QString& systemText);

} // namespace agv::link
