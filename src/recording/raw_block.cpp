// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/raw_block.h"

#include <zlib.h>

#include <cstdint>
#include <optional>

namespace agv::recording {
namespace {

constexpr std::size_t lengthBytes = 4;
constexpr std::size_t mostBlockBytes = 2 * largestRawBlock;   ///< with the times of many small chunks
constexpr std::uint64_t longestBlock_ns = 86'400'000'000'000; ///< a day: blocks are made twice a second
constexpr int compression = 1; ///< the fastest; the best gains 10 % of the size

void appendNumber(std::string& text, std::uint64_t number)
{
    while (number >= 0x80) {
        text += static_cast<char>(number | 0x80);
        number >>= 7;
    }
    text += static_cast<char>(number);
}

/// Takes a number from the front; nothing when it does not end or does not fit.
std::optional<std::uint64_t> takeNumber(std::string_view& text)
{
    std::uint64_t number = 0;
    for (unsigned shift = 0; shift < 63 && !text.empty(); shift += 7) {
        const auto byte = static_cast<unsigned char>(text.front());
        text.remove_prefix(1);
        number |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
        if (byte < 0x80)
            return number;
    }
    return std::nullopt;
}

std::unexpected<Error> damaged()
{
    return failure(ErrorCode::BadInput, "a block of received bytes is damaged: use a copy of the run");
}

Result<std::string> inflated(std::string_view packed)
{
    if (packed.size() < lengthBytes)
        return damaged();
    std::size_t size = 0;
    for (std::size_t i = 0; i < lengthBytes; ++i)
        size |= static_cast<std::size_t>(static_cast<unsigned char>(packed[i])) << (8 * i);
    if (size > mostBlockBytes)
        return damaged();
    std::string plain(size, '\0');
    uLongf length = size;
    const int status =
        uncompress(reinterpret_cast<Bytef*>(plain.data()), &length,
                   reinterpret_cast<const Bytef*>(packed.data() + lengthBytes), packed.size() - lengthBytes);
    if (status != Z_OK || length != size)
        return damaged();
    return plain;
}

} // namespace

std::string packChunks(std::span<const RunChunk* const> chunks)
{
    std::string plain;
    appendNumber(plain, chunks.size());
    Time before = chunks.front()->time;
    for (const RunChunk* chunk : chunks) {
        appendNumber(plain, static_cast<std::uint64_t>(Duration(chunk->time - before).count()));
        appendNumber(plain, chunk->bytes.size());
        before = chunk->time;
    }
    for (const RunChunk* chunk : chunks)
        plain += chunk->bytes;

    uLongf length = compressBound(plain.size());
    std::string packed(lengthBytes + length, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data() + lengthBytes), &length,
              reinterpret_cast<const Bytef*>(plain.data()), plain.size(), compression);
    for (std::size_t i = 0; i < lengthBytes; ++i)
        packed[i] = static_cast<char>(plain.size() >> (8 * i));
    packed.resize(lengthBytes + length);
    return packed;
}

Result<std::vector<RunChunk>> unpackChunks(std::string_view packed, Time first, const std::string& link)
{
    const Result<std::string> plain = inflated(packed);
    if (!plain)
        return std::unexpected(plain.error());
    std::string_view rest = *plain;
    const auto count = takeNumber(rest);
    if (!count || *count > rest.size()) // every chunk takes two bytes at least
        return damaged();
    std::vector<RunChunk> chunks(static_cast<std::size_t>(*count));
    std::vector<std::size_t> lengths;
    lengths.reserve(chunks.size());
    std::uint64_t left_ns = longestBlock_ns;
    for (RunChunk& chunk : chunks) {
        const auto since = takeNumber(rest);
        const auto length = takeNumber(rest);
        if (!since || !length || *since > left_ns)
            return damaged();
        left_ns -= *since;
        first += Duration(static_cast<std::int64_t>(*since));
        chunk.time = first;
        chunk.link = link;
        lengths.push_back(static_cast<std::size_t>(*length));
    }
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        if (lengths[i] > rest.size())
            return damaged();
        chunks[i].bytes = rest.substr(0, lengths[i]);
        rest.remove_prefix(lengths[i]);
    }
    if (!rest.empty())
        return damaged();
    return chunks;
}

} // namespace agv::recording
