// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/decarange_log.h"
#include "recording/range_table.h"
#include "recording/serial_capture.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace agv::recording {

/// What a file of UWB ranges looks like; told from its content, never from its name.
enum class RangeFileFormat : std::uint8_t {
    RangeCsv,      ///< range_table.h
    DecaRangeLog,  ///< decarange_log.h
    SerialCapture, ///< serial_capture.h, with or without times
};
const char* toText(RangeFileFormat format);

struct RangeFile {
    RangeFileFormat format = RangeFileFormat::RangeCsv;
    RangeTable table;
    std::vector<LoggedFix> fixes;   ///< of a DecaRangeRTLS log
    std::vector<UwbAnchor> anchors; ///< of a DecaRangeRTLS log
};

/// Decodes what a UWB unit sent. A capture without times gets those of the unit's own clock.
using SerialDecoder = std::function<std::vector<RangeMeasurement>(const SerialCapture&)>;

/// The ranges of a text. Bad lines become problems of the table and never stop the others. BadInput when the
/// text is none of the formats, holds no range, or is a capture and there is no decoder; where a line is to
/// blame the message begins with "LINE: ".
Result<RangeFile> parseRanges(std::string_view text, const SerialDecoder& decodeSerial);

/// The same for a file; the message begins with its name and, where one is to blame, the line. NotFound,
/// Permission, Io, or BadInput (also over 256 MiB).
Result<RangeFile> readRangeFile(const std::filesystem::path& path, const SerialDecoder& decodeSerial);

} // namespace agv::recording
