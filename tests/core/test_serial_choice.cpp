// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial_choice.h"

#include <gtest/gtest.h>

namespace agv {
namespace {

TEST(SerialChoice, ReadsTheUsbIdThatItWrites)
{
    const auto id = parseUsbId("0483:5740");
    ASSERT_TRUE(id);
    EXPECT_EQ(*id, trekUsbId);
    EXPECT_EQ(toText(*id), "0483:5740");
    EXPECT_EQ(parseUsbId("1A86:fffF"), (UsbId{0x1a86, 0xffff}));
}

TEST(SerialChoice, RefusesWhatIsNoUsbIdAndSaysWhatOneLooksLike)
{
    for (const char* text : {"", "0483", "0483:574", "0483:57400", "0483-5740", "04g3:5740", "-483:5740",
                             " 483:5740", "0x83:5740"}) {
        const auto id = parseUsbId(text);
        ASSERT_FALSE(id) << text;
        EXPECT_NE(id.error().detail.find("such as 0483:5740"), std::string::npos);
    }
}

TEST(SerialChoice, IsNamedByItsPathOrByTheUsbDevice)
{
    EXPECT_EQ(toText(SerialPortChoice{}), "USB 0483:5740");
    EXPECT_EQ(toText(SerialPortChoice{"/dev/ttyACM0", trekUsbId, "7"}), "/dev/ttyACM0");
    EXPECT_EQ(toText(SerialPortChoice{"", UsbId{0x1a86, 0x7523}, "7"}), "USB 1a86:7523, serial number 7");
}

} // namespace
} // namespace agv
