// SPDX-License-Identifier: GPL-3.0-or-later
// The places of the anchors of a kit on a serial port, by the ranges between them.
#include <QSignalSpy>
#include <QTest>

#include "session/kit_on_port.h"
#include "session/session.h"

#include <cmath>
#include <memory>

namespace agv::session {

class SessionAnchorSurveyTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_plant = plantWithUwb();
        m_plant.robotListen = {"127.0.0.1", 0};
        m_plant.telemetryPort = 0;
        m_kitSettings = simulation::idealUwbKitSettings(m_plant.anchors);
        m_kitSettings.model.noiseSd_m = 0.03;
    }
    void cleanup()
    {
        m_session.reset();
        m_kit.reset();
    }

    void theRangesBetweenTheAnchorsAreShown()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return heard(100); }));
        const std::vector<AnchorPairSnapshot>& pairs = m_last.uwb->anchorPairs;
        const double lengths_m[] = {3.0, 5.0, 4.0}; // all at the same height
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            QVERIFY(std::abs(pairs[i].range_m - lengths_m[i]) < 0.02);
            QVERIFY(std::abs(pairs[i].sd_m - 0.03) < 0.01);
        }
    }
    void anchorsThatAreWrongInTheListAreFound()
    {
        const std::vector<UwbAnchor> truth = m_plant.anchors;
        m_kitSettings.anchors[1].z = 3.2; // ranges along a slope
        m_plant.anchors[1] = {1, "A1", 2.0, 0.5, 3.2, true};
        m_plant.anchors[2] = {2, "A2", 2.5, 5.0, 2.0, true};
        start();
        QVERIFY(m_kit->runUntil([&] { return heard(100); }));
        const AnchorSurvey survey = surveyed();
        QCOMPARE(survey.trouble, std::string());
        QCOMPARE(survey.anchors.size(), std::size_t{3});
        QCOMPARE(survey.notes,
                 std::vector<std::string>{"Anchor 3 has no ranges to the others and stays where it is"});
        const std::vector<UwbAnchor> found = placed(survey, closestFrame(survey, truth), m_plant.anchors);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(std::hypot(found[i].x - truth[i].x, found[i].y - truth[i].y) < 0.03);
        QCOMPARE(found[3], m_plant.anchors[3]);
    }
    void beforeAnythingIsHeardTheSurveySaysWhy()
    {
        start();
        QVERIFY(surveyed().trouble.starts_with("No ranges between the anchors were heard"));
    }
    void withoutAnchorsInThePlantTheSurveySaysWhy()
    {
        m_plant.anchors.clear();
        start();
        QVERIFY(surveyed().trouble.starts_with("There is no anchor in the list"));
        QVERIFY(surveyed().anchors.empty());
    }
    void anotherUnitBeginsWithoutTheRangesOfTheOneBefore()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return heard(100); }));
        m_kit->unplug();
        QVERIFY(m_kit->runUntil([&] { return m_last.uwb->link.state != LinkState::Up; }));
        m_kit->port->kit().setAnchorMissing(2, true);
        QVERIFY(m_kit->plug());
        QVERIFY(m_kit->runUntil([&] { return m_last.uwb->anchorPairs.size() == 1; }));
        QCOMPARE(m_last.uwb->anchorPairs.front().second, 1);
        QVERIFY(surveyed().trouble.starts_with("Too few pairs of anchors range with each other"));
    }

private:
    void start()
    {
        m_kit = std::make_unique<KitOnPort>(m_kitSettings,
                                            std::vector<simulation::UwbTagPlace>{{5, 1.0, 1.5, 0.3}});
        QVERIFY(m_kit->port != nullptr);
        SessionOptions options;
        options.uwb = m_kit->parameters();
        m_session = std::make_unique<Session>(m_plant, options);
        QObject::connect(m_session.get(), &Session::snapshotReady, m_session.get(),
                         [this](const PlantSnapshot& snapshot) { m_last = snapshot; });
        m_session->start();
        m_session->openUwb();
    }
    bool heard(int count) const
    {
        return m_last.uwb && m_last.uwb->anchorPairs.size() == 3 &&
               m_last.uwb->anchorPairs.front().count >= count;
    }
    AnchorSurvey surveyed()
    {
        QSignalSpy spy(m_session.get(), &Session::anchorsSurveyed);
        m_session->surveyAnchors();
        return spy.count() == 1 ? spy.front().front().value<AnchorSurvey>() : AnchorSurvey{};
    }

    PlantLayout m_plant;
    simulation::UwbKitSettings m_kitSettings;
    std::unique_ptr<KitOnPort> m_kit;
    std::unique_ptr<Session> m_session;
    PlantSnapshot m_last;
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::SessionAnchorSurveyTest)
#include "test_anchor_survey.moc"
