// SPDX-License-Identifier: GPL-3.0-or-later
// The window's word that the hand holds, in virtual time.
#include <QSignalSpy>
#include <QTest>

#include "gui/jog_hold.h"

using namespace agv;
using namespace agv::gui;
using namespace std::chrono_literals;

class JogHoldTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_now = Time{} + 1h;
        m_hold = std::make_unique<JogHold>(nullptr, [this] { return m_now; });
        m_hold->setWatching(true);
    }
    void everyBeatSaysThatTheHandHoldsAndSinceWhen()
    {
        QSignalSpy held(m_hold.get(), &JogHold::held);
        QVERIFY(m_hold->begin(JogSource::Keys, {0.1, 0.1}));
        beatAfter(50ms);
        m_hold->setSpeeds({0.04, 0.1});
        beatAfter(50ms);
        QCOMPARE(held.count(), 2);
        QCOMPARE(held[1][0].value<JogCommand>().input, m_now);
        QCOMPARE(held[1][0].value<JogCommand>().speeds, (WheelSpeeds{0.04, 0.1}));
        m_hold->end(JogReason::Released);
        beatAfter(50ms);
        QCOMPARE(held.count(), 2);
    }
    void anEndIsSaidOnce()
    {
        QSignalSpy released(m_hold.get(), &JogHold::released);
        m_hold->end(JogReason::Released);
        QVERIFY(m_hold->begin(JogSource::Keys, {0.1, 0.1}));
        m_hold->end(JogReason::FocusLost);
        m_hold->end(JogReason::Released);
        QCOMPARE(released.count(), 1);
        QCOMPARE(released[0][1].value<JogReason>(), JogReason::FocusLost);
    }
    void aWindowThatStoodStillEndsTheHoldInsteadOfSayingThatItGoesOn()
    {
        QSignalSpy held(m_hold.get(), &JogHold::held);
        QSignalSpy stalled(m_hold.get(), &JogHold::stalled);
        QVERIFY(m_hold->begin(JogSource::Keys, {0.1, 0.1}));
        beatAfter(249ms);
        QCOMPARE(held.count(), 1);
        beatAfter(10s);
        QCOMPARE(held.count(), 1);
        QCOMPARE(stalled.count(), 1);
    }
    void whatWasPressedWhileTheWindowStoodStillDrivesNothing()
    {
        m_now += 3s;
        QVERIFY(!m_hold->begin(JogSource::Keys, {0.1, 0.1})); // before the first beat
        beatAfter(0ms);
        QVERIFY(!m_hold->begin(JogSource::Keys, {0.1, 0.1})); // and right after it
        beatAfter(50ms);
        beatAfter(150ms);
        QVERIFY(!m_hold->begin(JogSource::Keys, {0.1, 0.1}));
        beatAfter(50ms);
        QVERIFY(m_hold->begin(JogSource::Keys, {0.1, 0.1}));
    }
    void aPadThatWasHiddenForLongHasNotStoodStill()
    {
        m_hold->setWatching(false);
        m_now += 1h;
        m_hold->setWatching(true);
        QVERIFY(m_hold->begin(JogSource::Pad, {0.1, 0.1}));
    }

private:
    void beatAfter(Duration pause)
    {
        m_now += pause;
        m_hold->beat();
    }

    Time m_now;
    std::unique_ptr<JogHold> m_hold;
};

QTEST_MAIN(JogHoldTest)
#include "test_jog_hold.moc"
