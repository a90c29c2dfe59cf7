// SPDX-License-Identifier: GPL-3.0-or-later
// Input: u32 first number, then four doubles per segment. A drive command of arbitrary numbers is either
// refused or comes back from the wire within half a unit of each field; a limit never becomes "no limit".
#include "fuzz/fuzz_support.h"
#include "protocol/robot_frame.h"

#include <cmath>

using namespace agv;
using namespace agv::fuzz;
using namespace agv::protocol;

namespace {

constexpr double halfUnit = 0.5 + 1e-9;

bool sameSpeeds(const WheelSpeeds& a, const WheelSpeeds& b)
{
    return std::abs(mmFromMetres(a.left - b.left)) <= halfUnit &&
           std::abs(mmFromMetres(a.right - b.right)) <= halfUnit;
}

bool sameLimit(double a, double b) { return std::abs(a - b) <= halfUnit && (a == 0.0) == (b == 0.0); }

bool sameSegment(const DriveSegment& a, const DriveSegment& b)
{
    return sameSpeeds(a.speeds, b.speeds) &&
           sameLimit(mmFromMetres(a.endDistance_m), mmFromMetres(b.endDistance_m)) &&
           sameLimit(degFromRad(a.endAngle), degFromRad(b.endAngle));
}

/// The command as the robot gets it, from a frame that the encoder accepted.
RobotCommand overTheWire(const Bytes& frame)
{
    RobotCommand received;
    CommandStream stream;
    stream.feed(frame, [&received](const RobotCommand& command) { received = command; });
    require(stream.counts().good == 1 && stream.pendingBytes() == 0, "one frame, one command");
    return received;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Input input(data, size);
    AddSegments segments{take<std::uint32_t>(input), {}};
    while (!input.empty() && segments.segments.size() <= maxSegments) {
        const WheelSpeeds speeds{take<double>(input), take<double>(input)};
        segments.segments.push_back({speeds, take<double>(input), take<double>(input)});
    }
    if (const auto frame = encodeCommand(segments)) {
        const auto received = std::get<AddSegments>(overTheWire(*frame));
        require(received.firstNumber == segments.firstNumber, "the first number comes back");
        require(std::ranges::equal(received.segments, segments.segments, sameSegment),
                "the segments come back");
    }
    if (segments.segments.empty())
        return 0;
    const DirectDrive drive{segments.segments.front().speeds};
    if (const auto frame = encodeCommand(drive))
        require(sameSpeeds(std::get<DirectDrive>(overTheWire(*frame)).speeds, drive.speeds),
                "the speeds come back");
    return 0;
}
