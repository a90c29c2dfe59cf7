// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/message_stream_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using agv::protocol::RobotReport;
    agv::fuzz::checkMessageStream<RobotReport>({data, size}, agv::protocol::encodeReportFrame);
    return 0;
}
