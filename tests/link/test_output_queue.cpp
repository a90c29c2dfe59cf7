// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "link/output_queue.h"

namespace agv::link {

class OutputQueueTest : public QObject {
    Q_OBJECT
private slots:
    void keepsTheOrder()
    {
        OutputQueue queue;
        QVERIFY(queue.push("a"));
        QVERIFY(queue.push("b"));
        QCOMPARE(queue.pop(), std::optional<QByteArray>("a"));
        QCOMPARE(queue.pop(), std::optional<QByteArray>("b"));
        QCOMPARE(queue.pop(), std::nullopt);
    }
    void refusesWhatPassesItsBound()
    {
        OutputQueue queue;
        for (std::size_t i = 0; i < OutputQueue::maxMessages; ++i)
            QVERIFY(queue.push("a"));
        QVERIFY(!queue.push("b"));
        QCOMPARE(queue.size(), OutputQueue::maxMessages);
    }
    void aStopOvertakesAFullQueueAndNothingOlderComesAfterIt()
    {
        OutputQueue queue;
        while (queue.push("drive")) {
        }
        queue.pushUrgent("stop");
        QCOMPARE(queue.pop(), std::optional<QByteArray>("stop"));
        QCOMPARE(queue.pop(), std::nullopt);
    }
    void manyStopsStayBounded()
    {
        OutputQueue queue;
        for (int i = 0; i < 1000; ++i)
            queue.pushUrgent("stop");
        QCOMPARE(queue.size(), OutputQueue::maxMessages);
    }
    void whatComesAfterAStopStaysBehindIt()
    {
        OutputQueue queue;
        queue.pushUrgent("stop");
        QVERIFY(queue.push("drive"));
        QCOMPARE(queue.pop(), std::optional<QByteArray>("stop"));
        QCOMPARE(queue.pop(), std::optional<QByteArray>("drive"));
    }
};

} // namespace agv::link

QTEST_GUILESS_MAIN(agv::link::OutputQueueTest)
#include "test_output_queue.moc"
