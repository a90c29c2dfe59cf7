// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"
#include "core/turn.h"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// What a file of initialisation turns looks like; told from its content, never from its name.
enum class TurnFileFormat : std::uint8_t {
    JsonLines, ///< json_turns.h
    Emulator,  ///< emulator_turns.h
    Capture,   ///< capture_turns.h
    Table,     ///< table_turns.h
};
const char* toText(TurnFileFormat format);

/// What is wrong with one turn, for people.
struct TurnFileProblem {
    int line = 0;       ///< 1-based line of the file
    std::string reason; ///< plain English, what and what was expected
};

/// One turn of a file, or why it is none.
struct RecordedTurn {
    int line = 0; ///< 1-based line it begins at
    std::expected<TurnRecord, TurnFileProblem> record;
};

struct TurnFile {
    TurnFileFormat format = TurnFileFormat::JsonLines;
    std::vector<RecordedTurn> turns;
};

/// A complete read of a reader line.
struct ReaderLineRead {
    TagUid uid;
    int rssi = 0; ///< 0..7
};

/// Decodes one line of a reader, without its end; empty for anything but a complete read.
using ReaderLineDecoder = std::function<std::optional<ReaderLineRead>(std::string_view line)>;

struct TurnFileOptions {
    std::vector<FloorTag> tags;         ///< resolve the tag numbers of the files
    double nominalStep = 0.0;           ///< rad, > 0; for files that do not say
    std::optional<double> turnTime_s;   ///< sleeptime, for files that do not say
    ReaderLineDecoder decodeReaderLine; ///< for captures; without it they cannot be read
};

/// The turns of a text. A bad turn becomes a problem and never stops the others. BadInput when the text is
/// none of the formats.
Result<TurnFile> parseTurns(std::string_view text, const TurnFileOptions& options);

inline constexpr std::size_t largestTurnFile = std::size_t{64} << 20U; ///< bytes

/// The same for a file or a pipe; the message names it. NotFound, Permission, Io, or BadInput (also when it
/// is too large).
Result<TurnFile> readTurnFile(const std::filesystem::path& path, const TurnFileOptions& options);

} // namespace agv::recording
