// SPDX-License-Identifier: GPL-3.0-or-later
// A plant whose anchors and tags are edited while the unit on the port goes on.
#include <QSignalSpy>
#include <QTest>

#include "session/kit_on_port.h"
#include "session/session.h"

#include <cmath>
#include <optional>
#include <utility>

namespace agv::session {

class UwbLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_plant = plantWithUwb();
        m_plant.robotListen = {"127.0.0.1", 0};
        m_plant.telemetryPort = 0;
        m_places = {{5, 1.0, 1.5, 0.3}};
        m_kit = std::make_unique<KitOnPort>(simulation::idealUwbKitSettings(m_plant.anchors), m_places);
        QVERIFY(m_kit->port != nullptr);
    }
    void cleanup()
    {
        m_session.reset();
        m_kit.reset();
    }

    void everyAnchorOfThePlantShowsItsRateItsAgeAndItsResidual()
    {
        m_plant.anchors.push_back({9, "A9", 1.0, 1.0, 1.0, true}); // not of the kit
        start();
        QVERIFY(m_kit->runUntil([&] {
            return m_last.uwb && m_last.uwb->anchors.size() == 5 && m_last.uwb->anchors[3].residual;
        }));
        for (std::size_t i = 0; i < 4; ++i) {
            const UwbAnchorSnapshot& anchor = m_last.uwb->anchors[i];
            QCOMPARE(anchor.id, static_cast<int>(i));
            QVERIFY(anchor.rangesPerSecond > 0.0 && anchor.age_s && *anchor.age_s < 30.0);
            QVERIFY(std::abs(anchor.residual->mean_m) < 0.01);
            QVERIFY(anchor.residual->count >= 20);
        }
        QCOMPARE(m_last.uwb->anchors[4].id, 9);
        QCOMPARE(m_last.uwb->anchors[4].rangesPerSecond, 0.0);
        QVERIFY(!m_last.uwb->anchors[4].age_s && !m_last.uwb->anchors[4].residual);
    }
    void editsHoldAtOnceWithoutTouchingThePort()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}); }));
        std::vector<UwbAnchor> shifted = m_plant.anchors;
        for (UwbAnchor& anchor : shifted)
            anchor.x += 2.0;
        UwbSettings settings = m_plant.uwb;
        settings.tags = {{5, "Front", RobotId{3}, 0.3, {}}};
        const std::uint64_t received = m_last.uwb->link.received;
        m_session->setUwb(shifted, settings);
        QVERIFY(m_kit->runUntil([&] { return isAt({3.0, 1.5}); }));
        QCOMPARE(m_last.uwb->tags.front().label, std::string("Front"));
        QVERIFY(m_last.uwb->link.received > received);
        QCOMPARE(m_connections, 1);
    }
    void aCorrectionMovesThePositionAndTheRangesThatAreShown()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}); }));
        const double before_m = m_last.uwb->tags.front().ranges[2].range_m;
        UwbSettings settings = m_plant.uwb;
        settings.corrections = {{2, 5, 0.2}};
        m_session->setUwb(m_plant.anchors, settings);
        QVERIFY(m_kit->runUntil([&] {
            const std::vector<UwbRangeSnapshot>& ranges = m_last.uwb->tags.front().ranges;
            return ranges.size() == 4 && std::abs(ranges[2].range_m - before_m - 0.2) < 2e-3;
        }));
    }
    void aTagThatIsListedLaterGetsItsHeight()
    {
        m_kit->tags = {{5, 1.0, 1.5, 1.3}};
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position; }));
        QCOMPARE(tag()->z_m, 0.3);
        UwbSettings settings = m_plant.uwb;
        settings.tags = {{5, "T5", std::nullopt, 1.3, {}}};
        m_session->setUwb(m_plant.anchors, settings);
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}); }));
        QCOMPARE(tag()->z_m, 1.3);
    }
    void anotherPortOfThePlantIsOpenedAndOneThatTheOperatorChoseStays()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}); }));
        UwbSettings elsewhere = m_plant.uwb;
        elsewhere.port.path = "/dev/no-such-port";
        m_session->setUwb(m_plant.anchors, elsewhere);
        QVERIFY(m_kit->runUntil([&] {
            return m_last.uwb->link.reason.starts_with("There is no serial port /dev/no-such-port");
        }));
        m_session->setUwbPort({m_kit->port->path(), trekUsbId, {}});
        QVERIFY(m_kit->runUntil([&] { return m_last.uwb->link.state == LinkState::Up; }));
        elsewhere.tagHeight_m = 0.31;
        m_session->setUwb(m_plant.anchors, elsewhere);
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position && tag()->z_m == 0.31; }));
        QCOMPARE(m_last.uwb->link.state, LinkState::Up);
        QCOMPARE(m_connections, 2);
    }
    void aCalibrationFindsTheOffsetsOfTheRangesAsMeasuredWhateverIsCorrectedAlready()
    {
        m_plant.uwb.corrections = {{0, 5, 3.0}, {1, 5, -2.0}};
        start();
        m_session->startRangeCalibration(5, 1.1, 1.5, 0.3, 1.0);
        QVERIFY(m_kit->runUntil(
            [&] { return m_last.uwb && m_last.uwb->calibration.state == RangeCalibrationState::Finished; }));
        const RangeCalibrationSnapshot& result = m_last.uwb->calibration;
        QCOMPARE(result.tag, 5);
        QCOMPARE(result.rows.size(), std::size_t{4});
        for (std::size_t i = 0; i < 4; ++i) {
            const UwbAnchor& anchor = m_plant.anchors[i];
            const auto range = [&](double x) {
                return std::hypot(anchor.x - x, anchor.y - 1.5, anchor.z - 0.3);
            };
            QCOMPARE(result.rows[i].anchor, anchor.id);
            QVERIFY(std::abs(result.rows[i].offset_m.value() - (range(1.1) - range(1.0))) < 1e-3);
        }
        m_session->cancelRangeCalibration();
        QVERIFY(m_kit->runUntil([&] { return m_last.uwb->calibration == RangeCalibrationSnapshot{}; }));
    }
    void aCalibrationEndsWhenItsAnchorsAreMovedAndNotWhenTheyAreRenamed()
    {
        start();
        m_session->startRangeCalibration(5, 1.0, 1.5, 0.3, 600.0);
        m_plant.anchors[0].label = "Door";
        m_session->setUwb(m_plant.anchors, m_plant.uwb);
        QVERIFY(m_kit->runUntil([&] {
            return m_last.uwb && m_last.uwb->calibration.state == RangeCalibrationState::Collecting;
        }));
        m_plant.anchors[0].x += 0.1;
        m_session->setUwb(m_plant.anchors, m_plant.uwb);
        QVERIFY(
            m_kit->runUntil([&] { return m_last.uwb->calibration.state == RangeCalibrationState::Failed; }));
        QVERIFY(m_last.uwb->calibration.reason.starts_with("The anchors were changed meanwhile"));
    }
    void anAnchorThatWasMovedIsWarnedOfInItsRowAndOnceInTheLog()
    {
        m_plant.width_m = 6.0;
        m_plant.anchors = simulation::defaultUwbAnchors(m_plant, 4);
        simulation::UwbKitSettings settings = simulation::idealUwbKitSettings(m_plant.anchors);
        settings.anchors[2].x += 0.5;
        m_kit = std::make_unique<KitOnPort>(settings, m_places);
        start();
        // The tag is carried from place to place: the kit's time is not the one of the console.
        int steps = 0;
        const auto carryOn = [&] {
            const double turn = 0.4 * (++steps / 100);
            m_kit->tags[0].x = 3.0 + 2.4 * std::sin(turn);
            m_kit->tags[0].y = 2.0 + 1.5 * std::sin(1.55 * turn + 1.0);
        };
        const auto warning = [&](std::size_t anchor) {
            return m_last.uwb && m_last.uwb->anchors.size() == 4 ? m_last.uwb->anchors[anchor].warning
                                                                 : std::string();
        };
        QVERIFY(m_kit->runUntil([&] {
            carryOn();
            return !warning(2).empty();
        }));
        QVERIFY(warning(2).starts_with("Ranges fit a place "));
        for (const std::size_t other : {0U, 1U, 3U})
            QVERIFY(warning(other).empty());
        const int later = steps + 2000;
        QVERIFY(m_kit->runUntil([&] {
            carryOn();
            return steps > later;
        }));
        QCOMPARE(m_warnings.size(), std::size_t{1});
        QVERIFY(m_warnings.front().starts_with("Anchor 2: Ranges fit a place "));
        m_session->setUwb(settings.anchors, m_plant.uwb);
        QVERIFY(m_kit->runUntil([&] { return warning(2).empty(); }));
    }
    void theDialectCanBeChosenWhileTheUnitReports()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}); }));
        UwbSettings settings = m_plant.uwb;
        settings.dialect = UwbDialect::UlmFour;
        m_session->setUwb(m_plant.anchors, settings);
        QVERIFY(m_kit->runUntil(
            [&] { return m_last.uwb->dialectIsChosen && m_last.uwb->dialect == UwbDialect::UlmFour; }));
        QCOMPARE(m_connections, 1);
    }
    void theLinkComesToLifeWithTheFirstAnchorsAndEndsWithTheLast()
    {
        const std::vector<UwbAnchor> anchors = std::exchange(m_plant.anchors, {});
        start();
        QTRY_VERIFY(m_snapshots > 0);
        QVERIFY(!m_last.uwb);
        m_session->setUwb(anchors, m_plant.uwb);
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}); }));
        m_session->setUwb({}, m_plant.uwb);
        QVERIFY(m_kit->runUntil([&] { return !m_last.uwb; }));
        m_session->setUwb(anchors, m_plant.uwb);
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}); }));
    }
    void aLinkThatWasClosedStaysClosedWhenTheFirstAnchorsCome()
    {
        const std::vector<UwbAnchor> anchors = std::exchange(m_plant.anchors, {});
        start();
        m_session->closeUwb();
        m_session->setUwb(anchors, m_plant.uwb);
        QVERIFY(m_kit->runUntil([&] { return m_last.uwb.has_value(); }));
        QCOMPARE(m_last.uwb->link.state, LinkState::Down);
        m_session->openUwb();
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}); }));
    }

private:
    void start()
    {
        SessionOptions options;
        options.uwb = m_kit->parameters();
        // The kit's time runs faster than the console's.
        options.uwb.anchorWatch.sampleEvery_s = 0.005;
        options.uwb.anchorWatch.decideEvery_s = 0.2;
        options.uwb.anchorWatch.moved_s = 0.5;
        m_last = {};
        m_snapshots = m_connections = 0;
        m_warnings.clear();
        m_session = std::make_unique<Session>(m_plant, options);
        connect(m_session.get(), &Session::snapshotReady, this, [&](const PlantSnapshot& snapshot) {
            m_last = snapshot;
            ++m_snapshots;
        });
        connect(m_session.get(), &Session::eventLogged, this, [&](const EventEntry& event) {
            if (event.source == "UWB" && event.level == EventLevel::Warning)
                m_warnings.push_back(event.text);
            m_connections += event.source == "UWB" && event.text == "Connected" ? 1 : 0;
        });
        m_session->start();
        m_session->openUwb();
    }
    std::optional<UwbTagSnapshot> tag() const
    {
        return m_last.uwb && !m_last.uwb->tags.empty() ? std::optional(m_last.uwb->tags.front())
                                                       : std::nullopt;
    }
    bool isAt(Point2 place) const
    {
        const auto found = tag();
        return found && found->position && distance(*found->position, place) < 0.02;
    }

    PlantLayout m_plant;
    std::vector<simulation::UwbTagPlace> m_places;
    std::unique_ptr<KitOnPort> m_kit;
    std::unique_ptr<Session> m_session;
    PlantSnapshot m_last;
    std::vector<std::string> m_warnings;
    int m_snapshots = 0;
    int m_connections = 0;
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::UwbLayoutTest)
#include "test_uwb_layout.moc"
