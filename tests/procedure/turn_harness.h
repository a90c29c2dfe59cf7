// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedure/initialisation_turn.h"

#include <functional>
#include <optional>
#include <random>
#include <vector>

namespace agv::procedure {

/// A reader that reports the tags in range in turn, one every 30 to 35 ms, and sometimes misses one (the
/// anticollision of ISO 15693 lets every tag answer once a round).
struct ReaderModel {
    int tagsInRange = 5;
    double missRate = 0.15;
    bool silent = false;
};

/// Runs an InitialisationTurn in virtual time against a reader and a robot made of numbers.
class TurnHarness {
public:
    struct Emitted {
        Time time;
        TurnPhase phase; ///< after the action
        TurnAction action;
    };

    explicit TurnHarness(TurnParameters parameters = {}, ReaderModel reader = {}, std::uint32_t seed = 1);

    InitialisationTurn& turn() { return m_turn; }
    Time now() const { return m_now; }
    void start() { perform(m_turn.start(m_now)); }
    void perform(const TurnActions& actions);
    /// Serves timers, reads and the robot until `done` holds or `limit` has passed; true when it holds.
    bool runUntil(const std::function<bool()>& done, Duration limit = std::chrono::seconds(120));
    bool runUntilPhase(TurnPhase phase);
    /// Serves what is left to do after an end: the repeated zeros.
    void drain();

    /// The solver answers this long after it was asked; empty: never.
    std::optional<Duration> solveTime = std::chrono::milliseconds(250);
    bool robotAnswers = true; ///< segmentDone of measured turns
    ReaderModel reader;

    const std::vector<Emitted>& emitted() const { return m_emitted; }
    template<typename Action>
    std::vector<Action> all() const
    {
        std::vector<Action> found;
        for (const Emitted& entry : m_emitted) {
            if (const auto* action = std::get_if<Action>(&entry.action))
                found.push_back(*action);
        }
        return found;
    }
    /// Number of DriveWheels and DriveSegments that start a motion.
    int motionsStarted() const;

private:
    Time nextEvent() const;
    void serve();
    void readOne();

    InitialisationTurn m_turn;
    Time m_now{std::chrono::seconds(1000)};
    Time m_nextRead;
    std::optional<Time> m_solvedAt;
    std::optional<Time> m_segmentDoneAt;
    std::uint32_t m_segment = 0;
    int m_tag = 0; ///< whose turn it is
    Duration m_stepTime;
    std::mt19937 m_random;
    std::vector<Emitted> m_emitted;
};

} // namespace agv::procedure
