// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/turn.h"

#include <functional>
#include <string>
#include <string_view>

namespace agv::recording {

/// Writes raw captures (format: capture_turns.h) while they happen: every line of the reader as received,
/// noise included, with the time of its first byte, and the marks of the turn. Owned by the caller, one per
/// reader; never touches a file itself.
class CaptureWriter {
public:
    /// Takes whole lines, each with its end.
    using Sink = std::function<void(std::string_view text)>;

    /// `begin`: time zero of the capture. Writes the first line.
    CaptureWriter(Sink sink, Time begin);

    void turn(const TurnParameters& parameters, Time at);
    void stop(int number, Time at);   ///< 1-based
    void retake(int number, Time at); ///< 1-based; a stop taken before
    void moving(Time at);
    void end(Time at);
    void aborted(Time at);

    /// Bytes as they arrived, at any split. Lines end at CR or LF, or after 512 bytes. Bytes that are no
    /// printable ASCII are written as \xHH.
    void bytes(std::string_view chunk, Time at);

private:
    void mark(const std::string& text, Time at);
    void endLine();

    Sink m_sink;
    Time m_begin;
    std::string m_line;
    Time m_lineTime;
};

} // namespace agv::recording
