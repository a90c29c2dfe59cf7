// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/plant_layout.h"
#include "core/turn.h"

#include <functional>
#include <list>
#include <memory>
#include <stop_token>
#include <thread>

namespace agv::session {

/// One recorded turn solved with one method; runs in a thread of its own, must not throw and must return soon
/// once the token asks for it.
using SolveFunction =
    std::function<TurnEstimate(const TurnRecord& record, SolveMethod method, std::stop_token stop)>;

/// The solvers of this program for the turns of `agv`; the same seed gives the same answers.
SolveFunction solverFor(const PlantLayout& plant, const AgvConfig& agv, std::uint64_t seed);

/// Runs solvers off the event loop. A new request cancels the one before: its answer is never delivered.
/// Lives in the session thread.
class SolveWorker : public QObject {
    Q_OBJECT
public:
    explicit SolveWorker(SolveFunction solve, QObject* parent = nullptr);
    /// Cancels what runs and waits for it.
    ~SolveWorker() override;

    using Answer = std::function<void(std::shared_ptr<const TurnEstimate>)>;
    /// `answer` is called in this object's thread.
    void request(TurnRecord record, SolveMethod method, Answer answer);
    void cancel();

private:
    struct Job {
        int id = 0;
        std::jthread thread;
    };
    void finished(int id, const std::shared_ptr<const TurnEstimate>& estimate, const Answer& answer);

    SolveFunction m_solve;
    std::list<Job> m_jobs; ///< cancelled ones stay until they have ended
    int m_current = 0;     ///< id of the job whose answer is wanted; 0: none
    int m_lastId = 0;
};

} // namespace agv::session
