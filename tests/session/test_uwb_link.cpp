// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "session/kit_on_port.h"
#include "session/wall_clock.h"

#include <cmath>
#include <optional>

namespace agv::session {

class UwbLinkTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_plant = plantWithUwb();
        m_settings = simulation::idealUwbKitSettings(m_plant.anchors);
    }
    void cleanup()
    {
        m_link.reset();
        m_kit.reset();
    }

    void findsTheUnitAsksItAndGivesThePositionOfATag()
    {
        m_plant.uwb.tags = {{5, "Front", RobotId{1}, 0.3, {}}};
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position && snapshot().unit; }));
        const UwbSnapshot now = snapshot();
        QCOMPARE(now.link.state, LinkState::Up);
        QVERIFY(now.link.address.find("0483:5740, serial number 3061") != std::string::npos);
        QVERIFY(now.dialect == UwbDialect::Trek && !now.dialectIsChosen);
        QCOMPARE(now.unit->version, std::string("Ver.2.25mx TREK"));
        QVERIFY(now.unit->configuration.fastMode);
        QCOMPARE(now.tags.front().label, std::string("Front"));
        QVERIFY(now.tags.front().agv == RobotId{1});
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}, 0.02); }));
    }
    void theUncertaintyIsThatOfThePosition()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position && tag()->reports > 50; }));
        const PositionCovariance covariance = tag()->covariance;
        QVERIFY(covariance.xx > 1e-6 && covariance.yy > 1e-6);
        QVERIFY(covariance.xx < 0.1 && covariance.yy < 0.1);
        QVERIFY(covariance.xx * covariance.yy > covariance.xy * covariance.xy);
    }
    void rangesAreOneReportPeriodOlderThanTheirReport()
    {
        m_settings.anchorRanges = false;
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position && snapshot().unit; }));
        // Time is not turned back when the period becomes known; so it is a while until this holds.
        const auto olderBy_s = [&] {
            const UwbSnapshot now = snapshot();
            return now.tags.front().age_s - *now.link.dataAge_s;
        };
        QVERIFY(m_kit->runUntil([&] { return std::abs(olderBy_s() - 0.1) < 1e-3; }));
    }
    void countsDamageAndGapsInTheNumbersOfTheExchanges()
    {
        m_settings.model.lostRate = 0.2;
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->reports > 30; }));
        m_kit->port->kit().printGarbage(200);
        QVERIFY(m_kit->runUntil([&] { return tag()->reports > 60; }));
        QVERIFY(tag()->missed > 0);
        QCOMPARE(snapshot().missed, tag()->missed);
        QVERIFY(snapshot().link.dropped > 0);
        QVERIFY(!snapshot().link.dropDetail.empty());
    }
    void nothingIsSentToACloneUnlessTheOperatorAsks()
    {
        m_settings.dialect = UwbDialect::UlmFour;
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position && tag()->reports > 50; }));
        QVERIFY(snapshot().dialect == UwbDialect::UlmFour);
        QVERIFY(snapshot().unitNote.find("clone") != std::string::npos);
        QCOMPARE(m_kit->port->kit().receivedBytes(), std::uint64_t{0});
        m_link->ask();
        QVERIFY(m_kit->runUntil([&] { return m_kit->port->kit().receivedBytes() == 5; }));
    }
    void nothingIsSentToAPortThatIsNotATrekUnits()
    {
        m_plant.uwb.port.usb = UsbId{0x1a86, 0x7523};
        start(UsbId{0x1a86, 0x7523});
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position; }));
        QCOMPARE(m_kit->port->kit().receivedBytes(), std::uint64_t{0});
        QVERIFY(!snapshot().unitNote.empty());
    }
    void everyDialectGivesPositions_data()
    {
        QTest::addColumn<int>("dialect");
        for (std::size_t i = 1; i < uwbDialectCount; ++i)
            QTest::newRow(toText(static_cast<UwbDialect>(i))) << static_cast<int>(i);
    }
    void everyDialectGivesPositions()
    {
        QFETCH(int, dialect);
        m_settings.dialect = static_cast<UwbDialect>(dialect);
        start();
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}, 0.05); }));
        QVERIFY(snapshot().dialect == m_settings.dialect);
    }
    void theDialectOfThePlantFileHolds()
    {
        m_plant.uwb.dialect = UwbDialect::UlmFour;
        m_settings.dialect = UwbDialect::UlmFour;
        start();
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}, 0.05); }));
        QVERIFY(snapshot().dialect == UwbDialect::UlmFour && snapshot().dialectIsChosen);
    }
    void aTagFollowsWhenItIsMoved()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}, 0.05); }));
        m_kit->tags[0].x = 2.0;
        QVERIFY(m_kit->runUntil([&] { return isAt({2.0, 1.5}, 0.1); }));
    }
    void threeAnchorsAreEnoughAndTwoAreAReason()
    {
        start();
        m_kit->port->kit().setAnchorMissing(3, true);
        QVERIFY(m_kit->runUntil([&] { return isAt({1.0, 1.5}, 0.05); }));
        cleanup();
        start();
        m_kit->port->kit().setAnchorMissing(2, true);
        m_kit->port->kit().setAnchorMissing(3, true);
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->reports > 5; }));
        QVERIFY(!tag()->position);
        QVERIFY(tag()->reason.starts_with("Only 2 of the 3 ranges"));
    }
    void anAnchorThatIsNotInThePlantFileIsNamed()
    {
        m_plant.anchors.resize(2);
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->reports > 5; }));
        QVERIFY(!tag()->position);
        QVERIFY(tag()->reason.starts_with("Anchor 3 measures this tag, but is not in the plant file"));
    }
    void aTagThatIsSwitchedOffLosesItsPositionAndSaysSo()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position; }));
        const UwbTagSnapshot later = m_link->snapshot(monotonicNow() + std::chrono::seconds(12)).tags.front();
        QVERIFY(!later.position);
        QCOMPARE(later.reason, std::string("Not heard for 12 s: the tag is off or out of reach"));
    }
    void anUnpluggedUnitIsFoundWhereItIsPluggedInAgain()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position; }));
        m_kit->unplug();
        QVERIFY(m_kit->runUntil([&] {
            return snapshot().link.reason.find("There is no serial port USB 0483:5740") != std::string::npos;
        }));
        const std::uint64_t before = tag()->reports;
        QVERIFY(m_kit->plug());
        QVERIFY(m_kit->runUntil([&] { return tag()->reports > before + 10; }));
        QCOMPARE(snapshot().link.state, LinkState::Up);
        QVERIFY(m_kit->runUntil([&] { return snapshot().unit.has_value(); }));
    }
    void closingEndsTheTriesAndOpeningBeginsThemAgain()
    {
        start();
        QVERIFY(m_kit->runUntil([&] { return snapshot().link.state == LinkState::Up; }));
        m_link->close();
        QCOMPARE(snapshot().link.state, LinkState::Down);
        m_link->open();
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position; }));
    }
    void anotherPortCanBeChosen()
    {
        m_plant.uwb.port.path = "/dev/no-such-port";
        start();
        QVERIFY(m_kit->runUntil([&] { return snapshot().link.state == LinkState::Waiting; }));
        QVERIFY(snapshot().link.reason.starts_with("There is no serial port /dev/no-such-port"));
        m_link->setPort({m_kit->port->path(), trekUsbId, {}});
        QVERIFY(m_kit->runUntil([&] { return tag() && tag()->position; }));
    }

private:
    void start(UsbId usb = trekUsbId)
    {
        m_kit =
            std::make_unique<KitOnPort>(m_settings, std::vector<simulation::UwbTagPlace>{{5, 1.0, 1.5, 0.3}});
        QVERIFY(m_kit->port != nullptr);
        m_kit->usb = usb;
        m_link = std::make_unique<UwbLink>(m_plant, m_kit->parameters(), nullptr);
        m_link->open();
    }
    UwbSnapshot snapshot() const { return m_link->snapshot(monotonicNow()); }
    std::optional<UwbTagSnapshot> tag() const
    {
        const UwbSnapshot now = snapshot();
        return now.tags.empty() ? std::nullopt : std::optional(now.tags.front());
    }
    bool isAt(Point2 place, double tolerance_m) const
    {
        const auto found = tag();
        return found && found->position && distance(*found->position, place) < tolerance_m;
    }

    PlantLayout m_plant;
    simulation::UwbKitSettings m_settings;
    std::unique_ptr<KitOnPort> m_kit;
    std::unique_ptr<UwbLink> m_link;
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::UwbLinkTest)
#include "test_uwb_link.moc"
