// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/capture_writer.h"

#include "recording/number_text.h"
#include "recording/turn_limits.h"

#include <cstdio>
#include <numbers>

namespace agv::recording {

namespace {

std::string milliseconds(Duration since) { return numberText(secondsFrom(since) * 1e3); }

} // namespace

CaptureWriter::CaptureWriter(Sink sink, Time begin) : m_sink(std::move(sink)), m_begin(begin)
{
    m_sink("# agv-capture 1\n");
}

void CaptureWriter::turn(const TurnParameters& parameters, Time at)
{
    std::string text = "turn step_deg=" + numberText(360.0 / parameters.stopsPerTurn);
    if (parameters.kind == TurnKind::Timed)
        text += " turn_time_ms=" + numberText(parameters.turnTime_s * 1e3);
    text += " rotation=" + std::string(agv::toText(parameters.rotation));
    text += " kind=" + std::string(toText(parameters.kind));
    mark(text, at);
}

void CaptureWriter::stop(int number, Time at) { mark("stop " + std::to_string(number), at); }
void CaptureWriter::retake(int number, Time at) { mark("retake " + std::to_string(number), at); }
void CaptureWriter::moving(Time at) { mark("moving", at); }
void CaptureWriter::end(Time at) { mark("end", at); }
void CaptureWriter::aborted(Time at) { mark("aborted", at); }

void CaptureWriter::mark(const std::string& text, Time at)
{
    m_sink("# " + text + " at_ms=" + milliseconds(at - m_begin) + "\n");
}

void CaptureWriter::bytes(std::string_view chunk, Time at)
{
    constexpr std::size_t longestLine = 512;
    for (const char byte : chunk) {
        if (byte == '\r' || byte == '\n') {
            endLine();
            continue;
        }
        if (m_line.empty())
            m_lineTime = at;
        if (byte >= ' ' && byte <= '~') {
            m_line += byte;
        } else {
            char escaped[5];
            std::snprintf(escaped, sizeof escaped, "\\x%02X",
                          static_cast<unsigned>(static_cast<unsigned char>(byte)));
            m_line += escaped;
        }
        if (m_line.size() >= longestLine)
            endLine();
    }
}

void CaptureWriter::endLine()
{
    if (m_line.empty())
        return;
    m_sink("@" + milliseconds(m_lineTime - m_begin) + " " + m_line + "\n");
    m_line.clear();
}

} // namespace agv::recording
