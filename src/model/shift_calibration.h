// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "core/units.h"

#include <memory>
#include <optional>
#include <vector>

namespace agv::model {

/// Calibrates several AGVs one after the other: says which turn is to be started next, and what became of
/// each. A pure state machine:
/// | state    | event                                    | next                                   |
/// |----------|------------------------------------------|----------------------------------------|
/// | Idle, Over | start(robots)                          | Asking: the first robot is to be started |
/// | Asking   | its turn runs                            | Turning                                |
/// | Asking   | its turn did not begin within patience   | Over                                   |
/// | Turning  | its turn is finished                     | Asking for the next robot; Over after the last |
/// | Turning  | its turn was aborted or failed           | Over: whoever stopped one wants to look |
/// | any      | stop()                                   | Over                                   |
class ShiftCalibration {
public:
    static constexpr Duration patience = std::chrono::seconds(5);

    enum class State { Idle, Asking, Turning, Over };
    enum class Outcome { Waiting, Running, Found, NotFound, Stopped, NotStarted };
    struct Entry {
        int robot = 0;
        Outcome outcome = Outcome::Waiting;
        std::shared_ptr<const TurnEstimate> result; ///< of Found and NotFound
    };

    void start(const std::vector<int>& robots, Time now);
    void stop();
    /// The robot whose turn is to be started now; told once for each.
    std::optional<int> update(const PlantSnapshot& snapshot);

    State state() const { return m_state; }
    bool isRunning() const { return m_state == State::Asking || m_state == State::Turning; }
    const std::vector<Entry>& entries() const { return m_entries; }
    /// Number of the running one, from 0.
    std::size_t current() const { return m_current; }
    Time began() const { return m_began; }
    bool foundAll() const;

private:
    void end(Outcome outcome);
    std::optional<int> next(Time now);

    State m_state = State::Idle;
    std::vector<Entry> m_entries;
    std::size_t m_current = 0;
    std::shared_ptr<const TurnEstimate> m_before; ///< the result that was there when the turn was asked for
    bool m_isAsked = false;
    Time m_began;
    Time m_askedAt;
};

} // namespace agv::model
