// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/event_log.h"

#include "session/wall_clock.h"

namespace agv::session {

void EventLog::add(EventLevel level, const std::string& source, const std::string& text, Time now)
{
    if (level > EventLevel::Info) {
        emitEntry(level, source, text);
        return;
    }
    Source& state = m_sources[{source, level}];
    if (now - state.since >= std::chrono::seconds(1)) {
        if (state.held > 0)
            emitEntry(level, source, std::to_string(state.held) + " more messages were left out");
        state = {now, 0, 0};
    }
    if (++state.passed <= burst)
        emitEntry(level, source, text);
    else
        ++state.held;
}

void EventLog::emitEntry(EventLevel level, const std::string& source, const std::string& text)
{
    m_sink({utcNow_ms(), level, source, text});
}

} // namespace agv::session
