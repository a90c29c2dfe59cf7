// SPDX-License-Identifier: GPL-3.0-or-later
// Input: u16 seed of the split, what a unit says after it was asked. Any split finds the same answer; an
// answer has a printable version; the configuration is in its ranges.
#include "fuzz/fuzz_support.h"
#include "procedure/uwb_handshake.h"

using namespace agv;
using namespace agv::fuzz;
using namespace agv::procedure;

namespace {

UwbHandshake asked()
{
    UwbHandshake handshake;
    handshake.opened(true, Time{});
    require(handshake.onTimer(Time{} + std::chrono::seconds(1)) == UwbHandshakeAction::SendRequest,
            "a silent TREK port is asked");
    return handshake;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Input bytes(data, size);
    const auto seed = take<std::uint16_t>(bytes);
    const Time now = Time{} + std::chrono::milliseconds(1100);

    UwbHandshake whole = asked();
    whole.bytes(textOf(bytes), UwbDialect::Trek, now);
    UwbHandshake split = asked();
    feedInPieces(bytes, seed, [&](Input piece) { split.bytes(textOf(piece), UwbDialect::Trek, now); });
    require(split.unit() == whole.unit(), "the answer does not depend on the split");
    if (!whole.unit())
        return 0;
    for (const char c : whole.unit()->version)
        require((c >= ' ' && c <= '~') || c == '\0', "a version is printable");
    const UwbConfiguration& configuration = whole.unit()->configuration;
    require(configuration.address >= 0 && configuration.address <= 7, "an address is 0 to 7");
    require(decodeUwbConfiguration(encodeUwbConfiguration(configuration)) == configuration,
            "decode(encode(x)) is x");
    return 0;
}
