// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/run_rows.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// Chunks of one link packed into a few bytes: the lines of a device differ little from each other. Layout,
/// compressed with zlib behind four bytes with the length before (little-endian): the number of chunks; for
/// each the nanoseconds since the one before and its length; then all bytes. Numbers are LEB128.
/// @pre chunks is not empty and its times do not fall
std::string packChunks(std::span<const RunChunk* const> chunks);

/// The chunks of a packed block whose first one came at `first`. BadInput when it is damaged; never more
/// memory than the largest block needs, whatever the bytes are.
Result<std::vector<RunChunk>> unpackChunks(std::string_view packed, Time first, const std::string& link);

/// Blocks hold at most so many bytes of a link.
inline constexpr std::size_t largestRawBlock = std::size_t{4} * 1024 * 1024;

} // namespace agv::recording
