// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/serial_failure_text.h"

#include <QFile>
#include <QFileInfo>

#include <unistd.h>

namespace agv::link {
namespace {

/// Lets whoever sits at the computer open the port of a TREK1000 unit.
constexpr const char* udevRule =
    R"(SUBSYSTEM=="tty", ATTRS{idVendor}=="0483", ATTRS{idProduct}=="5740", TAG+="uaccess")";

bool isForbidden(const QString& path)
{
    return ::access(QFile::encodeName(path).constData(), R_OK | W_OK) != 0 && errno == EACCES;
}

} // namespace

bool isTransient(SerialFault fault) { return fault != SerialFault::NotSerial; }

SerialFault serialFaultOf(QSerialPort::SerialPortError error, bool wasOpen, const QString& path)
{
    if (wasOpen) {
        // A hang-up is a ResourceError of a USB device and a ReadError of a pseudo-terminal.
        const bool isLoss = error == QSerialPort::ResourceError || error == QSerialPort::ReadError ||
                            error == QSerialPort::WriteError;
        return isLoss || !QFileInfo::exists(path) ? SerialFault::Unplugged : SerialFault::Other;
    }
    if (!QFileInfo::exists(path))
        return SerialFault::Missing;
    switch (error) {
    case QSerialPort::DeviceNotFoundError:
        return SerialFault::Missing;
    case QSerialPort::PermissionError:
    case QSerialPort::OpenError:
        return isForbidden(path) ? SerialFault::Forbidden : SerialFault::Busy;
    case QSerialPort::UnsupportedOperationError:
        return SerialFault::NotSerial;
    default:
        return SerialFault::Other;
    }
}

QString serialFailureText(SerialFault fault, const QString& port, const QString& group,
                          const QString& systemText)
{
    switch (fault) {
    case SerialFault::Missing:
        return QStringLiteral("There is no serial port %1: plug the unit in, or choose another port")
            .arg(port);
    case SerialFault::Busy:
        return QStringLiteral("Serial port %1 is in use: another console, terminal or program holds it; end "
                              "that program")
            .arg(port);
    case SerialFault::Forbidden:
        if (group.isEmpty())
            return QStringLiteral("You may not open the serial port %1: install the udev rule %2")
                .arg(port, QString::fromLatin1(udevRule));
        return QStringLiteral("You may not open the serial port %1: join the group %2 (sudo usermod -aG %2 "
                              "$USER, then log in anew) or install the udev rule %3")
            .arg(port, group, QString::fromLatin1(udevRule));
    case SerialFault::NotSerial:
        return QStringLiteral("%1 is no serial port: choose another port").arg(port);
    case SerialFault::Unplugged:
        return QStringLiteral("Serial port %1 is gone: the unit was unplugged or lost its power; plug it in "
                              "again")
            .arg(port);
    case SerialFault::Other:
        break;
    }
    return QStringLiteral("Serial port %1 failed: %2").arg(port, systemText);
}

QString groupOf(const QString& path) { return QFileInfo(path).group(); }

} // namespace agv::link
