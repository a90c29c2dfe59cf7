// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "core/units.h"

#include <functional>
#include <map>
#include <string>
#include <utility>

namespace agv::session {

/// Stamps events and holds back floods: of each source at most `burst` Info events a second pass, and as
/// many details; the rest is counted and said in one line. Warnings and errors always pass.
class EventLog {
public:
    using Sink = std::function<void(const EventEntry&)>;
    static constexpr int burst = 10;

    explicit EventLog(Sink sink) : m_sink(std::move(sink)) {}

    void add(EventLevel level, const std::string& source, const std::string& text, Time now);

private:
    struct Source {
        Time since;
        int passed = 0;
        int held = 0;
    };
    void emitEntry(EventLevel level, const std::string& source, const std::string& text);

    Sink m_sink;
    std::map<std::pair<std::string, EventLevel>, Source> m_sources;
};

} // namespace agv::session
