// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSerialPort>
#include <QString>

#include "link/chunk.h"
#include "link/serial_failure_text.h"
#include "link/serial_port_list.h"

#include <optional>

class QSocketNotifier;

namespace agv::link {

/// A serial port (115200 8N1), one attempt at a time. It reports, it does not decide: when to try again is
/// the business of procedure::LinkLife. Lives in the session thread; never blocks. Every attempt ends with
/// close() or with exactly one failed(); the port is closed by then, at the first error: a port that hung up
/// reports errors for ever.
///
/// A USB device that was open once is found again by its USB id and serial number, wherever it is plugged
/// in, as long as the choice stays the same.
class SerialLink : public QObject {
    Q_OBJECT
public:
    /// Bytes that may wait for a unit that does not read.
    static constexpr qint64 maxBacklog = 4096;

    explicit SerialLink(SerialPortLister ports = availableSerialPorts, QObject* parent = nullptr);
    ~SerialLink() override;

    /// Ends a running attempt silently and begins a new one; its signals come from the event loop.
    void open(const SerialPortChoice& choice);
    /// Silent: no signal follows.
    void close();
    /// False, and nothing is sent, when the port is not open or the backlog would pass maxBacklog.
    bool write(const QByteArray& bytes);
    bool isConnected() const { return m_port && m_port->isOpen(); }

    /// The port that is open or was open last, while the choice stays the same.
    const std::optional<SerialPortEntry>& port() const { return m_entry; }

signals:
    void connected();
    void received(const agv::link::Chunk& chunk);
    /// `transient`: another try may help by itself. `reason`: plain English, what and what to do.
    void failed(bool transient, const QString& reason);

private:
    std::optional<SerialPortEntry> findPort() const;
    void attempt();
    void onReadyRead();
    void onError(QSerialPort::SerialPortError error);
    void watchForHangUp();
    void onException();
    /// Takes the last bytes, then ends the attempt, unless whoever took them has ended it.
    void lose(SerialFault fault, const QString& systemText);
    void fail(SerialFault fault, const QString& port, const QString& systemText);

    SerialPortLister m_ports;
    SerialPortChoice m_choice;
    std::optional<SerialPortEntry> m_entry;
    QSerialPort* m_port = nullptr;       ///< owned (QObject child); a new one for each attempt
    QSocketNotifier* m_hangUp = nullptr; ///< owned by m_port
};

} // namespace agv::link
