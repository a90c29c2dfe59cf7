// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/serial_choice.h"

#include <functional>
#include <optional>
#include <vector>

namespace agv::link {

/// A serial port of this computer, as a list to choose from shows it.
struct SerialPortEntry {
    QString path;             ///< what is opened: "/dev/ttyACM0"
    QString description;      ///< of the device, may be empty: "STM32 Virtual COM Port"
    std::optional<UsbId> usb; ///< empty: no USB device, or the system does not tell
    QString serialNumber;     ///< of the USB device, may be empty
    friend bool operator==(const SerialPortEntry&, const SerialPortEntry&) = default;
};

/// "/dev/ttyACM0: STM32 Virtual COM Port (0483:5740, serial number 3061)"
QString toText(const SerialPortEntry& port);

/// TREK1000 units first, then other USB devices, then the rest, each by path.
void sortByPreference(std::vector<SerialPortEntry>& ports);

/// Every serial port there is, in order of preference. Pseudo-terminals are not among them.
std::vector<SerialPortEntry> availableSerialPorts();

/// Where SerialLink gets its ports from; tests have a list of their own.
using SerialPortLister = std::function<std::vector<SerialPortEntry>()>;

/// The port that is meant. With a path there always is one, listed or not; what the choice says about its
/// USB id and serial number holds where the list says nothing.
std::optional<SerialPortEntry> chosenPort(const std::vector<SerialPortEntry>& ports,
                                          const SerialPortChoice& choice);

} // namespace agv::link
