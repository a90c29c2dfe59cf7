// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzz/fuzz_support.h"
#include "protocol/robot_frame.h"

#include <vector>

namespace agv::fuzz {

/// Input: u16 seed of the split, stream of one direction of the robot link. Any split gives the same messages
/// and counts, every frame is counted, and what is decoded encodes to the frame it came from.
template<typename Message, typename Encode>
void checkMessageStream(Input bytes, Encode encode)
{
    const auto seed = take<std::uint16_t>(bytes);
    std::vector<Message> expected;
    protocol::MessageStream<Message> whole;
    whole.feed(bytes, [&expected](const Message& message) { expected.push_back(message); });

    std::vector<Message> messages;
    protocol::MessageStream<Message> split;
    feedInPieces(bytes, seed, [&](Input piece) {
        split.feed(piece, [&messages](const Message& message) { messages.push_back(message); });
        require(split.pendingBytes() <= 256, "memory is bounded");
    });
    require(messages == expected, "the messages do not depend on the split");
    require(split.counts() == whole.counts(), "the counts do not depend on the split");
    require(whole.counts().good == expected.size(), "every message is counted");

    std::size_t frames = 0;
    std::size_t next = 0;
    for (Input rest = bytes; rest.size() >= 2 && rest.size() >= 2U + rest[1];
         rest = rest.subspan(2U + rest[1])) {
        const Input frame = rest.first(2U + rest[1]);
        ++frames;
        if (next == expected.size())
            continue;
        const auto encoded = encode(expected[next]);
        require(encoded.has_value(), "what is decoded can be encoded");
        if (std::ranges::equal(*encoded, frame))
            ++next;
    }
    require(next == expected.size(), "encode(decode(frame)) is the frame");
    require(whole.counts().good + whole.counts().droppedTotal() == frames, "every frame is counted");
}

} // namespace agv::fuzz
