// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"

#include <string>

namespace agv::app {

/// The progress of a turn on standard error: one line that is written over on a terminal, one line per stop
/// otherwise.
class ProgressLine {
public:
    ProgressLine();

    void show(const std::string& label, const TurnSnapshot& turn);
    /// Text of its own line; the progress goes on below it. The same again and again is shown once.
    void print(const std::string& text);
    /// Leaves the terminal on a fresh line.
    void finish();

private:
    bool m_terminal;
    bool m_open = false;
    std::string m_lastText;
    int m_lastStop = 0;
    TurnPhase m_lastPhase = TurnPhase::Idle;
};

} // namespace agv::app
