// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial_choice.h"

#include <charconv>
#include <cstdio>

namespace agv {
namespace {

constexpr std::size_t digits = 4;

std::optional<std::uint16_t> hexWord(std::string_view text)
{
    std::uint16_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value, 16);
    if (text.size() != digits || error != std::errc{} || stop != end)
        return std::nullopt;
    return value;
}

} // namespace

std::string toText(UsbId id)
{
    char text[2 * digits + 2];
    std::snprintf(text, sizeof text, "%04x:%04x", unsigned{id.vendor}, unsigned{id.product});
    return text;
}

Result<UsbId> parseUsbId(std::string_view text)
{
    if (text.size() == 2 * digits + 1 && text[digits] == ':') {
        const auto vendor = hexWord(text.substr(0, digits));
        const auto product = hexWord(text.substr(digits + 1));
        if (vendor && product)
            return UsbId{*vendor, *product};
    }
    return failure(ErrorCode::BadInput,
                   "\"" + std::string(text) +
                       "\" is no USB id: write vendor and product in hexadecimal, such as 0483:5740");
}

std::string toText(const SerialPortChoice& choice)
{
    if (!choice.path.empty())
        return choice.path;
    std::string text = "USB " + toText(choice.usb.value_or(trekUsbId));
    if (!choice.serialNumber.empty())
        text += ", serial number " + choice.serialNumber;
    return text;
}

} // namespace agv
