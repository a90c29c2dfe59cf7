// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/solve_worker.h"

#include "estimation/turn_solver.h"

#include <utility>

namespace agv::session {

SolveFunction solverFor(const PlantLayout& plant, const AgvConfig& agv, std::uint64_t seed)
{
    return [context = estimation::contextFor(plant, agv), seed](const TurnRecord& record, SolveMethod method,
                                                                std::stop_token stop) {
        return estimation::solveTurn(record, context, {method, seed, std::move(stop)});
    };
}

SolveWorker::SolveWorker(SolveFunction solve, QObject* parent) : QObject(parent), m_solve(std::move(solve)) {}

SolveWorker::~SolveWorker() { cancel(); }

void SolveWorker::request(TurnRecord record, SolveMethod method, Answer answer)
{
    cancel();
    const int id = ++m_lastId;
    m_current = id;
    m_jobs.push_back({id, std::jthread([this, id, method, record = std::move(record),
                                        answer = std::move(answer)](const std::stop_token& stop) {
                          auto estimate = std::make_shared<const TurnEstimate>(m_solve(record, method, stop));
                          // The destructor joins this thread first, so `this` lives; Qt drops the call with
                          // it.
                          QMetaObject::invokeMethod(
                              this, [this, id, estimate, answer] { finished(id, estimate, answer); },
                              Qt::QueuedConnection);
                      })});
}

void SolveWorker::cancel()
{
    m_current = 0;
    for (Job& job : m_jobs)
        job.thread.request_stop();
}

void SolveWorker::finished(int id, const std::shared_ptr<const TurnEstimate>& estimate, const Answer& answer)
{
    m_jobs.remove_if([id](const Job& job) { return job.id == id; });
    if (id != m_current)
        return;
    m_current = 0;
    answer(estimate);
}

} // namespace agv::session
