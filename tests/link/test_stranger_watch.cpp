// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "link/stranger_watch.h"

namespace agv::link {

using namespace std::chrono_literals;

class StrangerWatchTest : public QObject {
    Q_OBJECT
private slots:
    void reportsEachStrangerOnceInTenSeconds()
    {
        StrangerWatch watch;
        const Time start{100s};
        QVERIFY(watch.isNews("10.0.0.1", start));
        QVERIFY(watch.isNews("10.0.0.2", start));
        QVERIFY(!watch.isNews("10.0.0.1", start + 9999ms));
        QVERIFY(watch.isNews("10.0.0.1", start + 10s));
        QVERIFY(!watch.isNews("10.0.0.1", start + 19s));
    }
    void forgetsRatherThanGrows()
    {
        StrangerWatch watch;
        const Time start{100s};
        for (qsizetype i = 0; i < StrangerWatch::mostKept; ++i)
            QVERIFY(watch.isNews(QString::number(i), start));
        QVERIFY(!watch.isNews("0", start));
        QVERIFY(watch.isNews("one more", start));
        QVERIFY(watch.isNews("0", start));
    }
};

} // namespace agv::link

QTEST_GUILESS_MAIN(agv::link::StrangerWatchTest)
#include "test_stranger_watch.moc"
