// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "session/solve_worker.h"

#include <atomic>
#include <condition_variable>
#include <mutex>

namespace agv::session {
namespace {

using Estimate = std::shared_ptr<const TurnEstimate>;

TurnEstimate answerWith(const char* status)
{
    TurnEstimate estimate;
    estimate.status = status;
    return estimate;
}

/// Waits until it is cancelled.
TurnEstimate endless(const TurnRecord&, SolveMethod, std::stop_token stop)
{
    std::mutex mutex;
    std::condition_variable_any woken;
    std::unique_lock lock(mutex);
    woken.wait(lock, stop, [] { return false; });
    return answerWith("cancelled");
}

} // namespace

class SolveWorkerTest : public QObject {
    Q_OBJECT
private slots:
    void answersInItsOwnThreadWithoutBlockingIt()
    {
        QThread* solvedIn = nullptr;
        SolveWorker worker([&](const TurnRecord&, SolveMethod, std::stop_token) {
            solvedIn = QThread::currentThread();
            return answerWith("ok");
        });
        Estimate estimate;
        QThread* answeredIn = nullptr;
        worker.request({}, SolveMethod::Fast, [&](const Estimate& answer) {
            estimate = answer;
            answeredIn = QThread::currentThread();
        });
        QVERIFY(!estimate);
        QTRY_VERIFY(estimate);
        QCOMPARE(estimate->status, std::string("ok"));
        QCOMPARE(answeredIn, thread());
        QVERIFY(solvedIn != thread());
    }
    void aNewRequestCancelsTheOneBefore()
    {
        std::atomic<int> calls = 0;
        SolveWorker worker([&](const TurnRecord& record, SolveMethod method, std::stop_token stop) {
            return ++calls == 1 ? endless(record, method, std::move(stop)) : answerWith("second");
        });
        QStringList answers;
        const auto note = [&](const Estimate& answer) { answers << QString::fromStdString(answer->status); };
        worker.request({}, SolveMethod::Fast, note);
        QTRY_COMPARE(calls.load(), 1);
        worker.request({}, SolveMethod::Auto, note);
        QTRY_COMPARE(answers, QStringList("second"));
    }
    void aCancelledRequestIsNeverAnswered()
    {
        std::atomic<bool> ended = false;
        SolveWorker worker([&](const TurnRecord& record, SolveMethod method, std::stop_token stop) {
            TurnEstimate estimate = endless(record, method, std::move(stop));
            ended = true;
            return estimate;
        });
        bool answered = false;
        worker.request({}, SolveMethod::Auto, [&](const Estimate&) { answered = true; });
        worker.cancel();
        QTRY_VERIFY(ended);
        QCoreApplication::processEvents();
        QVERIFY(!answered);
    }
    void itsDestructionCancelsWhatRuns()
    {
        auto worker = std::make_unique<SolveWorker>(endless);
        bool answered = false;
        worker->request({}, SolveMethod::Auto, [&](const Estimate&) { answered = true; });
        worker.reset();
        QCoreApplication::processEvents();
        QVERIFY(!answered);
    }
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::SolveWorkerTest)
#include "test_solve_worker.moc"
