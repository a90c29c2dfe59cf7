// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/units.h"
#include "recording/file_problem.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace agv::recording {

/// Bytes of a port as one read gave them.
struct SerialChunk {
    Duration since{}; ///< since the beginning of the capture
    std::string bytes;
    friend bool operator==(const SerialChunk&, const SerialChunk&) = default;
};

/// What a UWB unit sent, either with the times of its reads or as the bytes alone, as other programs save
/// them:
///
///     # agv-uwb-capture 1
///     # port /dev/ttyACM0 0483:5740
///     @0 mc 0f 00000663 000005a3 00000512 000004cb 095f c1 00024c24 a0:0(CR as backslash r)
///     @0.4 (LF as backslash n)
///
/// A line "@ms " holds one read. Bytes that are no printable ASCII are escaped as in C: r, n, t or xHH behind
/// a backslash, which is itself doubled. Other lines beginning with # are notes. Not one byte is lost.
struct SerialCapture {
    bool hasTimes = false;
    std::vector<SerialChunk> chunks; ///< one, when it has no times
    FileProblems problems;
};

/// Writes captures while they happen. Owned by the caller, one per port; never touches a file itself.
class SerialCaptureWriter {
public:
    using Sink = std::function<void(std::string_view text)>;

    /// `begin`: time zero. Writes the first line.
    SerialCaptureWriter(Sink sink, Time begin);
    void note(std::string_view text);
    void bytes(std::string_view chunk, Time at);

private:
    Sink m_sink;
    Time m_begin;
};

/// A capture of either form; any text is one without times. Lines of one with times that are not of its form
/// are problems.
SerialCapture readSerialCapture(std::string_view text);

bool looksLikeTimedCapture(std::string_view text);
/// Does the text have lines that begin like a report of a UWB unit?
bool looksLikeRawCapture(std::string_view text);

} // namespace agv::recording
