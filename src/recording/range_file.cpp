// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/range_file.h"

#include "core/text_file.h"

#include <optional>

namespace agv::recording {

namespace {

std::optional<RangeFileFormat> formatOf(std::string_view text)
{
    if (looksLikeTimedCapture(text))
        return RangeFileFormat::SerialCapture;
    if (looksLikeDecaRangeLog(text))
        return RangeFileFormat::DecaRangeLog;
    if (looksLikeRangeCsv(text))
        return RangeFileFormat::RangeCsv;
    if (looksLikeRawCapture(text))
        return RangeFileFormat::SerialCapture;
    return std::nullopt;
}

Result<RangeFile> fromLog(std::string_view text)
{
    auto log = readDecaRangeLog(text);
    if (!log)
        return std::unexpected(log.error());
    return RangeFile{RangeFileFormat::DecaRangeLog, std::move(log->table), std::move(log->fixes),
                     std::move(log->anchors)};
}

Result<RangeFile> fromCsv(std::string_view text)
{
    auto table = readRangeCsv(text);
    if (!table)
        return std::unexpected(table.error());
    return RangeFile{RangeFileFormat::RangeCsv, std::move(*table), {}, {}};
}

Result<RangeFile> fromCapture(std::string_view text, const SerialDecoder& decode)
{
    if (!decode)
        return failure(ErrorCode::BadInput, "is a capture of a UWB unit, which cannot be decoded here");
    SerialCapture capture = readSerialCapture(text);
    RangeFile file{RangeFileFormat::SerialCapture, {}, {}, {}};
    file.table.ranges = decode(capture);
    file.table.problems = std::move(capture.problems);
    return file;
}

Result<RangeFile> readAs(RangeFileFormat format, std::string_view text, const SerialDecoder& decode)
{
    switch (format) {
    case RangeFileFormat::RangeCsv:
        return fromCsv(text);
    case RangeFileFormat::DecaRangeLog:
        return fromLog(text);
    case RangeFileFormat::SerialCapture:
        return fromCapture(text, decode);
    }
    return failure(ErrorCode::BadInput, "has an unknown format");
}

} // namespace

const char* toText(RangeFileFormat format)
{
    switch (format) {
    case RangeFileFormat::RangeCsv:
        return "range table";
    case RangeFileFormat::DecaRangeLog:
        return "DecaRangeRTLS log";
    case RangeFileFormat::SerialCapture:
        return "serial capture";
    }
    return "unknown";
}

Result<RangeFile> parseRanges(std::string_view text, const SerialDecoder& decodeSerial)
{
    const auto format = formatOf(text);
    if (!format)
        return failure(
            ErrorCode::BadInput,
            "holds no UWB ranges; expected a table with the columns t_s,tag,anchor,range_m, a log of "
            "DecaRangeRTLS, or the lines of a UWB unit");
    auto file = readAs(*format, text, decodeSerial);
    if (file && file->table.ranges.empty())
        return failure(ErrorCode::BadInput,
                       "is a " + std::string(toText(*format)) + " without a single range");
    return file;
}

Result<RangeFile> readRangeFile(const std::filesystem::path& path, const SerialDecoder& decodeSerial)
{
    constexpr std::size_t largestFile = std::size_t{256} << 20U;
    const auto text = readTextFile(path, largestFile);
    if (!text)
        return std::unexpected(text.error());
    auto file = parseRanges(*text, decodeSerial);
    if (!file) {
        const bool namesLine = !file.error().detail.empty() && file.error().detail.front() >= '0' &&
                               file.error().detail.front() <= '9';
        file.error().detail = path.string() + (namesLine ? ":" : ": ") + file.error().detail;
    }
    return file;
}

} // namespace agv::recording
