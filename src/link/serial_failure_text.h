// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSerialPort>
#include <QString>

#include <cstdint>

namespace agv::link {

/// Why a serial port cannot be opened or is lost.
enum class SerialFault : std::uint8_t {
    Missing,   ///< there is no such port
    Busy,      ///< another program holds it
    Forbidden, ///< the user may not open it
    NotSerial, ///< the name is of something else
    Unplugged, ///< it was open and is gone
    Other,
};

/// Whether another try may help without the operator. After plugging in, a port may be forbidden for the
/// moment that the system needs to set its rights.
bool isTransient(SerialFault fault);

/// What the system's error means. `wasOpen`: the error came after opening. `path` is looked at: does it
/// exist, may this user open it?
SerialFault serialFaultOf(QSerialPort::SerialPortError error, bool wasOpen, const QString& path);

/// What is wrong with the port and what to do; plain English. `group`: whose members may open it, may be
/// empty. `systemText` is what the system says about faults that have no sentence of their own.
QString serialFailureText(SerialFault fault, const QString& port, const QString& group,
                          const QString& systemText);

/// Name of the group that a device belongs to; empty when it has none or does not exist.
QString groupOf(const QString& path);

} // namespace agv::link
