// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace agv {

/// Vendor and product of a USB device.
struct UsbId {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    friend bool operator==(const UsbId&, const UsbId&) = default;
};

/// The virtual COM port of a TREK1000 unit.
inline constexpr UsbId trekUsbId{0x0483, 0x5740};

/// "0483:5740"
std::string toText(UsbId id);
/// Reads what toText() writes; digits in either case. BadInput otherwise.
Result<UsbId> parseUsbId(std::string_view text);

/// Which serial port a unit is on. With a path that port; the USB id then only says what the unit is, for
/// ports of which the system does not know it. Without a path the first port with this USB id and, if given,
/// this serial number. With nothing at all the first port of a TREK1000 unit.
struct SerialPortChoice {
    std::string path; ///< "/dev/ttyACM0", "COM3", any name the system opens
    std::optional<UsbId> usb;
    std::string serialNumber;
    friend bool operator==(const SerialPortChoice&, const SerialPortChoice&) = default;
};

/// A serial port of this computer, to choose from.
struct SerialPortInfo {
    std::string path;         ///< what is opened: "/dev/ttyACM0"
    std::string description;  ///< of the device, may be empty
    std::optional<UsbId> usb; ///< empty: no USB device, or the system does not tell
    std::string serialNumber; ///< of the USB device, may be empty
    friend bool operator==(const SerialPortInfo&, const SerialPortInfo&) = default;
};

/// "/dev/ttyACM0", "USB 0483:5740" or "USB 0483:5740, serial number 3061"
std::string toText(const SerialPortChoice& choice);

} // namespace agv
