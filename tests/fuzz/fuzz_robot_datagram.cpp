// SPDX-License-Identifier: GPL-3.0-or-later
// Input: one UDP datagram. What is decoded encodes to the datagram it came from.
#include "fuzz/fuzz_support.h"
#include "protocol/robot_frame.h"

using namespace agv::fuzz;
using namespace agv::protocol;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Input datagram(data, size);
    const auto report = decodeReportDatagram(datagram);
    if (!report)
        return 0;
    const auto encoded = encodeReportDatagram(*report);
    require(encoded.has_value(), "what is decoded can be encoded");
    require(std::ranges::equal(*encoded, datagram), "encode(decode(datagram)) is the datagram");
    return 0;
}
