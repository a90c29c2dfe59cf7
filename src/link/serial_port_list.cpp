// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/serial_port_list.h"

#include <QSerialPortInfo>

#include <algorithm>
#include <tuple>

namespace agv::link {
namespace {

int rank(const SerialPortEntry& port)
{
    if (port.usb == trekUsbId)
        return 0;
    return port.usb ? 1 : 2;
}

/// ttyS9 before ttyS10: by the name without its number, then by the number.
auto order(const SerialPortEntry& port)
{
    const auto isDigit = [](QChar c) { return c.isDigit(); };
    const auto number = std::find_if_not(port.path.crbegin(), port.path.crend(), isDigit).base();
    const auto nameLength = static_cast<qsizetype>(number - port.path.cbegin());
    return std::tuple(rank(port), port.path.left(nameLength), port.path.size(), port.path);
}

SerialPortEntry entryOf(const QSerialPortInfo& info)
{
    SerialPortEntry entry{info.systemLocation(), info.description(), {}, info.serialNumber()};
    if (info.hasVendorIdentifier() && info.hasProductIdentifier())
        entry.usb = UsbId{info.vendorIdentifier(), info.productIdentifier()};
    return entry;
}

} // namespace

QString toText(const SerialPortEntry& port)
{
    QString text = port.path;
    if (!port.description.isEmpty())
        text += QStringLiteral(": ") + port.description;
    if (!port.usb)
        return text;
    text += QStringLiteral(" (") + QString::fromStdString(agv::toText(*port.usb));
    if (!port.serialNumber.isEmpty())
        text += QStringLiteral(", serial number ") + port.serialNumber;
    return text + QLatin1Char(')');
}

void sortByPreference(std::vector<SerialPortEntry>& ports) { std::ranges::stable_sort(ports, {}, order); }

std::vector<SerialPortEntry> availableSerialPorts()
{
    std::vector<SerialPortEntry> ports;
    for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts())
        ports.push_back(entryOf(info));
    sortByPreference(ports);
    return ports;
}

std::optional<SerialPortEntry> chosenPort(const std::vector<SerialPortEntry>& ports,
                                          const SerialPortChoice& choice)
{
    const QString serialNumber = QString::fromStdString(choice.serialNumber);
    if (!choice.path.empty()) {
        const QString path = QString::fromStdString(choice.path);
        const auto listed = std::ranges::find(ports, path, &SerialPortEntry::path);
        if (listed != ports.end() && listed->usb)
            return *listed;
        return SerialPortEntry{path, {}, choice.usb, serialNumber};
    }
    const UsbId usb = choice.usb.value_or(trekUsbId);
    const auto found = std::ranges::find_if(ports, [&](const SerialPortEntry& port) {
        return port.usb == usb && (serialNumber.isEmpty() || port.serialNumber == serialNumber);
    });
    if (found == ports.end())
        return std::nullopt;
    return *found;
}

} // namespace agv::link
