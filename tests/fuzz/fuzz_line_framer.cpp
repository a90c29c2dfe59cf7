// SPDX-License-Identifier: GPL-3.0-or-later
// Input: u16 seed of the split, u8 maximal length, stream. The framer, fed in pieces, must find the lines
// that a search over the whole stream finds.
#include "fuzz/fuzz_support.h"
#include "protocol/line_framer.h"

#include <string>
#include <vector>

using namespace agv::fuzz;
using namespace agv::protocol;

namespace {

struct Framed {
    std::vector<std::string> lines;
    std::uint64_t overlong = 0;
};

Framed framedByPieces(Input stream, std::uint16_t seed, std::size_t maxLength)
{
    Framed framed;
    LineFramer framer(maxLength);
    feedInPieces(stream, seed, [&](Input piece) {
        framer.feed(textOf(piece), [&](std::string_view line) {
            require(framer.lineStart() <= framer.streamPosition(), "a line begins before it ends");
            framed.lines.emplace_back(line);
        });
        require(framer.pendingBytes() <= maxLength + 3, "memory is bounded");
    });
    require(framer.streamPosition() == stream.size(), "every byte is counted");
    framed.overlong = framer.overlongLines();
    return framed;
}

/// The same by searching the whole text for the next end.
Framed framedBySearch(std::string_view text, std::size_t maxLength)
{
    constexpr std::string_view literal = "<\\r>";
    Framed framed;
    while (!text.empty()) {
        const std::size_t control = text.find_first_of("\r\n");
        const std::size_t marker = text.find(literal);
        const std::size_t end = std::min(control, marker);
        if (end == std::string_view::npos) {
            // What may still become the literal does not count as length yet.
            std::size_t undecided = 0;
            for (std::size_t n = 1; n < literal.size(); ++n)
                undecided = text.ends_with(literal.substr(0, n)) ? n : undecided;
            framed.overlong += text.size() - undecided > maxLength ? 1 : 0;
            break;
        }
        const std::string_view line = text.substr(0, end);
        if (line.size() > maxLength)
            ++framed.overlong;
        else if (!isBlankLine(line))
            framed.lines.emplace_back(line);
        text.remove_prefix(end + (marker < control ? literal.size() : 1));
    }
    return framed;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Input stream(data, size);
    const auto seed = take<std::uint16_t>(stream);
    const std::size_t maxLength = take<std::uint8_t>(stream);
    const Framed pieces = framedByPieces(stream, seed, maxLength);
    const Framed whole = framedBySearch(textOf(stream), maxLength);
    require(pieces.lines == whole.lines, "the lines do not depend on the split");
    require(pieces.overlong == whole.overlong, "over-long lines are counted once each");
    return 0;
}
