// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/turn_file.h"

#include "core/text_file.h"
#include "recording/capture_turns.h"
#include "recording/emulator_turns.h"
#include "recording/json_turns.h"
#include "recording/table_turns.h"
#include "recording/tag_numbers.h"
#include "recording/text_lines.h"

#include <algorithm>
#include <array>

namespace agv::recording {

namespace {

/// The format that most lines look like; one mark is enough for a capture, whose lines look like nothing
/// else.
std::optional<TurnFileFormat> formatOf(const std::vector<TextLine>& lines)
{
    int json = 0;
    int emulator = 0;
    int table = 0;
    for (const TextLine& line : lines) {
        if (isCaptureMark(line.text))
            return TurnFileFormat::Capture;
        if (trimmed(line.text).starts_with('{'))
            ++json;
        else if (looksLikeEmulatorLine(line.text))
            ++emulator;
        else if (looksLikeTableRow(line.text))
            ++table;
    }
    if (json == 0 && emulator == 0 && table == 0)
        return std::nullopt;
    if (json >= std::max(emulator, table))
        return TurnFileFormat::JsonLines;
    return emulator >= table ? TurnFileFormat::Emulator : TurnFileFormat::Table;
}

std::vector<RecordedTurn> readAs(TurnFileFormat format, const std::vector<TextLine>& lines,
                                 const TurnFileOptions& options)
{
    switch (format) {
    case TurnFileFormat::JsonLines:
        return readJsonTurns(lines, options);
    case TurnFileFormat::Emulator:
        return readEmulatorTurns(lines, options);
    case TurnFileFormat::Capture:
        return readCaptureTurns(lines, options);
    case TurnFileFormat::Table:
        return readTableTurns(lines, options);
    }
    return {};
}

} // namespace

const char* toText(TurnFileFormat format)
{
    switch (format) {
    case TurnFileFormat::JsonLines:
        return "JSON lines";
    case TurnFileFormat::Emulator:
        return "emulator file";
    case TurnFileFormat::Capture:
        return "reader capture";
    case TurnFileFormat::Table:
        return "table";
    }
    return "unknown";
}

Result<TurnFile> parseTurns(std::string_view text, const TurnFileOptions& options)
{
    const std::vector<TextLine> lines = linesOf(text);
    auto format = formatOf(lines);
    // A reader may print any noise; nothing else has zero bytes.
    if (format != TurnFileFormat::Capture && text.find('\0') != std::string_view::npos)
        format.reset();
    if (!format) {
        const bool isEmpty = text.find_first_not_of(" \t\r\n") == std::string_view::npos;
        return failure(ErrorCode::BadInput,
                       std::string(isEmpty ? "holds no turns, it is empty" : "holds no turns") +
                           "; expected JSON lines with 'rows', an emulator file, a reader capture with "
                           "'# stop' marks, or a table of tags and RSSI");
    }
    if (*format == TurnFileFormat::Capture && !options.decodeReaderLine)
        return failure(ErrorCode::BadInput, "is a reader capture, which cannot be decoded here");
    TurnFile file{*format, readAs(*format, lines, options)};
    const TagNumbers numbers(options.tags);
    for (RecordedTurn& turn : file.turns) {
        if (!turn.record)
            continue;
        if (auto why = numbers.whyForeign(*turn.record))
            turn.record = std::unexpected(TurnFileProblem{turn.line, std::move(*why)});
    }
    return file;
}

Result<TurnFile> readTurnFile(const std::filesystem::path& path, const TurnFileOptions& options)
{
    const auto text = readTextStream(path, largestTurnFile);
    if (!text)
        return std::unexpected(text.error());
    auto file = parseTurns(*text, options);
    if (!file)
        file.error().detail = path.string() + ": " + file.error().detail;
    return file;
}

} // namespace agv::recording
