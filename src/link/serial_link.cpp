// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/serial_link.h"

#include <QSocketNotifier>
#include <QTimer>

#include <utility>

#include <poll.h>
#include <sys/ioctl.h>

namespace agv::link {
namespace {

/// No loss: what a port says about settings or lines that it does not have.
bool isHarmless(QSerialPort::SerialPortError error)
{
    return error == QSerialPort::NoError || error == QSerialPort::UnsupportedOperationError ||
           error == QSerialPort::TimeoutError || error == QSerialPort::NotOpenError;
}

} // namespace

SerialLink::SerialLink(SerialPortLister ports, QObject* parent) : QObject(parent), m_ports(std::move(ports))
{}

SerialLink::~SerialLink() { close(); }

void SerialLink::open(const SerialPortChoice& choice)
{
    close();
    if (m_choice != choice)
        m_entry.reset();
    m_choice = choice;
    m_port = new QSerialPort(this);
    // So a port that cannot be opened fails after open() has returned. By then it may have been closed.
    QTimer::singleShot(0, m_port, [this, port = m_port] {
        if (m_port == port)
            attempt();
    });
}

void SerialLink::close()
{
    QSerialPort* port = std::exchange(m_port, nullptr);
    if (!port)
        return;
    // Nothing of an old attempt may reach the next one.
    port->disconnect(this);
    if (QSocketNotifier* watch = std::exchange(m_hangUp, nullptr))
        watch->setEnabled(false); // it may be the one that is telling
    if (port->isOpen()) {
        port->clear(QSerialPort::Output); // closing must not wait for a unit that does not read
        port->close();
    }
    port->deleteLater();
}

bool SerialLink::write(const QByteArray& bytes)
{
    if (!isConnected() || m_port->bytesToWrite() + bytes.size() > maxBacklog)
        return false;
    return m_port->write(bytes) == bytes.size();
}

/// The unit that was open before, wherever it is now; else what was chosen.
std::optional<SerialPortEntry> SerialLink::findPort() const
{
    const std::vector<SerialPortEntry> ports = m_ports();
    if (m_entry && m_entry->usb) {
        const SerialPortChoice same{{}, m_entry->usb, m_entry->serialNumber.toStdString()};
        if (auto found = chosenPort(ports, same))
            return found;
    }
    return chosenPort(ports, m_choice);
}

void SerialLink::attempt()
{
    const std::optional<SerialPortEntry> entry = findPort();
    if (!entry)
        return fail(SerialFault::Missing, QString::fromStdString(toText(m_choice)), {});
    m_port->setPortName(entry->path);
    m_port->setBaudRate(QSerialPort::Baud115200);
    if (!m_port->open(QIODevice::ReadWrite))
        return fail(serialFaultOf(m_port->error(), false, entry->path), entry->path, m_port->errorString());
    m_entry = entry;
    m_port->clear(QSerialPort::Input); // from before it was opened
    connect(m_port, &QSerialPort::readyRead, this, &SerialLink::onReadyRead);
    connect(m_port, &QSerialPort::errorOccurred, this, &SerialLink::onError);
    watchForHangUp();
    emit connected();
}

// Qt 6.4 reports a device that is gone without an end, Qt 6.8 never while it spins on the end of the file:
// the hang-up that poll() tells is asked for here, whatever Qt makes of it. The dispatcher lets a notifier
// for exceptions fire on it, and not on data.
void SerialLink::watchForHangUp()
{
    m_hangUp = new QSocketNotifier(m_port->handle(), QSocketNotifier::Exception, m_port);
    connect(m_hangUp, &QSocketNotifier::activated, this, &SerialLink::onException);
}

void SerialLink::onException()
{
    pollfd asked{m_port->handle(), POLLIN, 0};
    if (::poll(&asked, 1, 0) < 0 || !(asked.revents & (POLLHUP | POLLERR)))
        return;
    // What the device said last is still to be read by the port; the hang-up stays and is told again.
    int unread = 0;
    if (::ioctl(asked.fd, FIONREAD, &unread) == 0 && unread > 0)
        return;
    lose(serialFaultOf(QSerialPort::ResourceError, true, m_entry->path), {});
}

void SerialLink::onReadyRead()
{
    const Time now = std::chrono::steady_clock::now();
    emit received({m_port->readAll(), now});
}

void SerialLink::onError(QSerialPort::SerialPortError error)
{
    if (isHarmless(error))
        return;
    lose(serialFaultOf(error, true, m_entry->path), m_port->errorString());
}

void SerialLink::lose(SerialFault fault, const QString& systemText)
{
    const QSerialPort* const failing = m_port;
    // The last bytes before the end are as good as any.
    if (m_port->bytesAvailable() > 0)
        onReadyRead();
    // Whoever took them may have closed the link, or opened it anew: then this attempt is over already.
    if (m_port == failing)
        fail(fault, m_entry->path, systemText);
}

void SerialLink::fail(SerialFault fault, const QString& port, const QString& systemText)
{
    close();
    emit failed(isTransient(fault), serialFailureText(fault, port, groupOf(port), systemText));
}

} // namespace agv::link
