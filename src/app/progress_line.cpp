// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_line.h"

#include <cstdio>
#include <unistd.h>
#include <utility>

namespace agv::app {
namespace {

const char* words(TurnPhase phase)
{
    switch (phase) {
    case TurnPhase::Settling:
        return "settling";
    case TurnPhase::Reading:
        return "reading";
    case TurnPhase::Turning:
        return "turning";
    case TurnPhase::Solving:
        return "solving";
    case TurnPhase::Idle:
    case TurnPhase::Finished:
    case TurnPhase::Aborted:
    case TurnPhase::Failed:
        break;
    }
    return "";
}

} // namespace

ProgressLine::ProgressLine() : m_terminal(::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const std::string& label, const TurnSnapshot& turn)
{
    const char* doing = words(turn.phase);
    if (*doing == '\0')
        return;
    if (m_terminal) {
        std::fprintf(stderr, "\r\033[K%s: stop %d of %d, %s, %.0f %%, %.0f s left", label.c_str(), turn.stop,
                     turn.stopCount, doing, 100.0 * turn.progress, turn.timeLeft_s);
        m_open = true;
        return;
    }
    const bool solving = turn.phase == TurnPhase::Solving && m_lastPhase != TurnPhase::Solving;
    m_lastPhase = turn.phase;
    if (solving)
        std::fprintf(stderr, "%s: solving\n", label.c_str());
    else if (std::exchange(m_lastStop, turn.stop) != turn.stop)
        std::fprintf(stderr, "%s: stop %d of %d\n", label.c_str(), turn.stop, turn.stopCount);
}

void ProgressLine::print(const std::string& text)
{
    if (std::exchange(m_lastText, text) == text)
        return;
    finish();
    std::fprintf(stderr, "%s\n", text.c_str());
}

void ProgressLine::finish()
{
    if (std::exchange(m_open, false))
        std::fputs("\r\033[K", stderr);
    m_lastStop = 0;
    m_lastPhase = TurnPhase::Idle;
}

} // namespace agv::app
