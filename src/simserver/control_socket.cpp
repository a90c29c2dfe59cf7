// SPDX-License-Identifier: GPL-3.0-or-later
#include "simserver/control_socket.h"

#include <QDir>
#include <QFileInfo>
#include <QLocalSocket>

#include <memory>
#include <sys/stat.h>

namespace agv::simserver {
namespace {

constexpr int connectTimeout_ms = 500;
constexpr qint64 backlogLimit = 1 << 20; // a client that does not read is dropped

/// Left behind by a program that was killed?
bool isAbandoned(const QString& path)
{
    struct stat status{};
    if (::lstat(QFile::encodeName(path).constData(), &status) != 0 || !S_ISSOCK(status.st_mode))
        return false;
    QLocalSocket probe;
    probe.connectToServer(path);
    return !probe.waitForConnected(connectTimeout_ms);
}

} // namespace

ControlSocket::ControlSocket(PlantServer& server, QObject* parent) : QObject(parent), m_plant(server)
{
    m_server.setSocketOptions(QLocalServer::UserAccessOption);
    connect(&m_server, &QLocalServer::newConnection, this, &ControlSocket::accept);
}

Result<void> ControlSocket::listen(const QString& path)
{
    const QString absolute = QDir::current().absoluteFilePath(path);
    const std::string place = "cannot take commands at " + absolute.toStdString() + ": ";
    // Asked first, because with UserAccessOption Qt renames its socket over whatever is there.
    if (isAbandoned(absolute))
        QLocalServer::removeServer(absolute);
    else if (QFileInfo::exists(absolute))
        return failure(ErrorCode::InUse,
                       place + "it is in use; name another path or end the program that listens there");
    if (m_server.listen(absolute))
        return {};
    return failure(ErrorCode::Io, place + m_server.errorString().toStdString());
}

void ControlSocket::accept()
{
    while (QLocalSocket* client = m_server.nextPendingConnection()) {
        const auto commands = std::make_shared<CommandLines>(m_plant, [client](const QByteArray& json) {
            if (client->bytesToWrite() > backlogLimit)
                return client->abort();
            client->write(json + '\n');
            client->flush();
        });
        connect(client, &QLocalSocket::readyRead, client,
                [client, commands] { commands->feed(client->readAll()); });
        connect(client, &QLocalSocket::disconnected, client, &QObject::deleteLater);
    }
}

} // namespace agv::simserver
