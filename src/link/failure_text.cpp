// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/failure_text.h"

namespace agv::link {
namespace {

QString text(const Endpoint& endpoint) { return QString::fromStdString(toText(endpoint)); }

} // namespace

bool isTransient(QAbstractSocket::SocketError error)
{
    switch (error) {
    case QAbstractSocket::HostNotFoundError:
    case QAbstractSocket::SocketAccessError:
    case QAbstractSocket::UnsupportedSocketOperationError:
        return false;
    default:
        return true;
    }
}

QString connectionFailureText(QAbstractSocket::SocketError error, bool wasConnected, const Endpoint& peer,
                              const QString& systemText)
{
    switch (error) {
    case QAbstractSocket::ConnectionRefusedError:
        return QStringLiteral(
                   "%1 refuses the connection: the device is on, but nothing listens on that port; "
                   "check the port")
            .arg(text(peer));
    case QAbstractSocket::RemoteHostClosedError:
        return QStringLiteral("%1 closed the connection: it was switched off, restarted or serves other "
                              "clients already")
            .arg(text(peer));
    case QAbstractSocket::HostNotFoundError:
        return QStringLiteral("The host \"%1\" is not known: check the name in the plant file")
            .arg(QString::fromStdString(peer.host));
    case QAbstractSocket::SocketTimeoutError:
        return wasConnected
                   ? QStringLiteral("%1 no longer answers: check its power and its Wi-Fi").arg(text(peer))
                   : QStringLiteral("%1 does not answer: check the address, its power and its Wi-Fi")
                         .arg(text(peer));
    case QAbstractSocket::NetworkError:
        return QStringLiteral("%1 cannot be reached (%2): check the cable, the Wi-Fi and the address")
            .arg(text(peer), systemText);
    case QAbstractSocket::SocketAccessError:
        return QStringLiteral("The system forbids a connection to %1: check the firewall").arg(text(peer));
    default:
        return QStringLiteral("Connection to %1 failed: %2").arg(text(peer), systemText);
    }
}

QString robotLossText(QAbstractSocket::SocketError error, const Endpoint& robot, const QString& systemText)
{
    if (error == QAbstractSocket::RemoteHostClosedError)
        return QStringLiteral("%1 closed the connection: it was switched off or restarted").arg(text(robot));
    return connectionFailureText(error, true, robot, systemText);
}

Error listenFailure(QAbstractSocket::SocketError error, const char* protocol, const Endpoint& local,
                    const QString& systemText)
{
    const std::string where =
        std::string(protocol) + " port " + std::to_string(local.port) + " on " + local.host;
    switch (error) {
    case QAbstractSocket::AddressInUseError:
        return {ErrorCode::InUse, where + " is in use: another console or program holds it; end that program "
                                          "or change the port in the plant file"};
    case QAbstractSocket::SocketAccessError:
        return {ErrorCode::Permission,
                where + " is forbidden by the system: ports below 1024 need administrator rights; choose a "
                        "higher port in the plant file"};
    case QAbstractSocket::SocketAddressNotAvailableError:
        return {ErrorCode::NotFound,
                where +
                    " does not exist: this computer has no network interface with that address; check the "
                    "listen address in the plant file"};
    default:
        return {ErrorCode::Network, where + " cannot be opened: " + systemText.toStdString()};
    }
}

} // namespace agv::link
