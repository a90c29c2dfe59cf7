// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "session/kit_on_port.h"
#include "session/session.h"

namespace agv::session {

class UwbReplugTest : public QObject {
    Q_OBJECT
private slots:
    void positionsComeBackEachOfAHundredTimesThatTheUnitIsUnpluggedAndPluggedIn();
};

void UwbReplugTest::positionsComeBackEachOfAHundredTimesThatTheUnitIsUnpluggedAndPluggedIn()
{
    PlantLayout plant = plantWithUwb();
    plant.robotListen = {"127.0.0.1", 0};
    plant.telemetryPort = 0;
    KitOnPort kit(simulation::idealUwbKitSettings(plant.anchors), {{5, 1.0, 1.5, 0.3}, {6, 2.0, 3.0, 0.3}});
    QVERIFY(kit.port != nullptr);
    SessionOptions options;
    options.uwb = kit.parameters();
    Session session(plant, options);
    UwbSnapshot last;
    std::uint64_t bytes = 0;
    int losses = 0;
    connect(&session, &Session::snapshotReady, this,
            [&](const PlantSnapshot& snapshot) { last = *snapshot.uwb; });
    connect(&session, &Session::uwbBytes, this,
            [&](const QByteArray& more) { bytes += static_cast<std::uint64_t>(more.size()); });
    connect(&session, &Session::eventLogged, this, [&](const EventEntry& event) {
        losses += event.source == "UWB" && event.text.find("was unplugged") != std::string::npos ? 1 : 0;
    });
    session.start();
    session.openUwb();

    std::uint64_t heardBefore = 0;
    const auto bothAreThere = [&] {
        if (last.link.state != LinkState::Up || last.tags.size() != 2)
            return false;
        const auto isAt = [&](const UwbTagSnapshot& tag, Point2 place) {
            return tag.position && distance(*tag.position, place) < 0.05 && tag.reports > heardBefore;
        };
        return isAt(last.tags[0], {1.0, 1.5}) && isAt(last.tags[1], {2.0, 3.0});
    };
    QVERIFY(kit.runUntil(bothAreThere));
    for (int i = 1; i <= 100; ++i) {
        kit.unplug();
        QVERIFY2(kit.runUntil([&] { return !isConnected(last.link); }), qPrintable(QString::number(i)));
        heardBefore = std::max(last.tags[0].reports, last.tags[1].reports);
        QVERIFY(kit.plug());
        QVERIFY2(kit.runUntil(bothAreThere), qPrintable(QString::number(i)));
    }
    QCOMPARE(losses, 100);
    QCOMPARE(last.link.dropped, std::uint64_t{0});
    QVERIFY(bytes > 0);
}

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::UwbReplugTest)
#include "test_uwb_replug.moc"
