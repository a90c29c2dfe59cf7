// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "session/kit_on_port.h"
#include "session/read_back.h"
#include "session/session.h"

namespace agv::session {

class UwbReplugTest : public QObject {
    Q_OBJECT
private slots:
    void positionsComeBackEachOfAHundredTimesThatTheUnitIsUnpluggedAndPluggedInAndNoRowIsLost();
};

void UwbReplugTest::positionsComeBackEachOfAHundredTimesThatTheUnitIsUnpluggedAndPluggedInAndNoRowIsLost()
{
    PlantLayout plant = plantWithUwb();
    plant.robotListen = {"127.0.0.1", 0};
    plant.telemetryPort = 0;
    KitOnPort kit(simulation::idealUwbKitSettings(plant.anchors), {{5, 1.0, 1.5, 0.3}, {6, 2.0, 3.0, 0.3}});
    QVERIFY(kit.port != nullptr);
    SessionOptions options;
    options.uwb = kit.parameters();
    const QTemporaryDir runs;
    options.recording.runs = runs.path().toStdString();
    auto owned = std::make_unique<Session>(plant, options);
    Session& session = *owned;
    UwbSnapshot last;
    RecordingSnapshot recording;
    std::string bytes;
    int losses = 0;
    connect(&session, &Session::snapshotReady, this, [&](const PlantSnapshot& snapshot) {
        last = *snapshot.uwb;
        recording = snapshot.recording;
    });
    connect(&session, &Session::uwbBytes, this, [&](const QByteArray& more) { bytes += more.toStdString(); });
    connect(&session, &Session::eventLogged, this, [&](const EventEntry& event) {
        losses += event.source == "UWB" && event.text.find("was unplugged") != std::string::npos ? 1 : 0;
    });
    session.start();
    session.startRun();
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
    QVERIFY(!bytes.empty());

    QCOMPARE(recording.state, RecordingState::Recording);
    const std::uint64_t reports = last.tags[0].reports + last.tags[1].reports;
    owned.reset(); // ends the run
    auto run = recording::RunReader::open(recording.folder);
    QVERIFY2(run, run ? "" : run.error().detail.c_str());
    QVERIFY(recordedBytes(*run, "uwb") == bytes);
    // A report has the ranges to four anchors. What came behind the last snapshot is recorded as well.
    const std::uint64_t ranges = recordedRows(*run, "ranges");
    QVERIFY2(ranges >= 4 * reports && ranges <= 4 * reports + 40, qPrintable(QString::number(ranges)));
}

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::UwbReplugTest)
#include "test_uwb_replug.moc"
