// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QJsonArray>
#include <QSerialPort>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "protocol/trek_stream.h"
#include "simserver/plant_server.h"
#include "simserver/uwb_port.h"
#include "simulation/trainer_command.h"

#include <filesystem>
#include <memory>

#include <poll.h>

using namespace agv;
using namespace agv::simserver;
using namespace std::chrono_literals;

namespace {

const std::vector<UwbAnchor> fourAnchors{{0, "A0", 0.0, 0.0, 2.0, true},
                                         {1, "A1", 3.0, 0.0, 2.0, true},
                                         {2, "A2", 3.0, 4.0, 2.0, true},
                                         {3, "A3", 0.0, 4.0, 2.5, true}};
const std::array<simulation::UwbTagPlace, 1> oneTag{{{5, 1.0, 2.0, 0.3}}};

PlantLayout plantWithAnchors()
{
    PlantLayout plant;
    plant.name = "test";
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    plant.floorTags = tagGrid(31, 41, 0.1, {0.0, 0.0}, TagUid{0xE00401503A5B0001});
    plant.anchors = fourAnchors;
    AgvConfig agv;
    agv.id = {1};
    agv.robotHost = "127.0.0.2";
    agv.reader = {agv.robotHost, 8883};
    plant.agvs.push_back(agv);
    return plant;
}

/// A console's end of the port: opens it and counts the reports.
class Reader {
public:
    explicit Reader(const QString& path) : port(path) { port.open(QIODevice::ReadWrite); }
    void read()
    {
        const QByteArray bytes = port.readAll();
        all += bytes;
        stream.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}, Time{},
                    [this](const protocol::TrekReport& report) {
                        if (report.kind == protocol::TrekLineKind::Corrected)
                            last = report;
                    });
    }
    QSerialPort port;
    QByteArray all;
    protocol::TrekStream stream;
    protocol::TrekReport last;
};

} // namespace

class UwbPortTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_now = Time{};
        make({});
    }
    void aConsoleReadsTheReportsOfTheKitFromARealSerialPort()
    {
        Reader reader(path());
        QVERIFY(reader.port.isOpen());
        const auto reports = [&] {
            run(100ms);
            reader.read();
            return reader.stream.counts().reports;
        };
        QTRY_VERIFY(reports() > 20);
        QCOMPARE(reader.stream.counts().damaged(), std::uint64_t{0});
        QCOMPARE(reader.last.tag, std::int16_t{5});
    }
    void theKitAnswersWhatItIsAsked()
    {
        Reader reader(path());
        reader.port.write("decA$");
        const auto answer = [&] {
            run(5ms);
            reader.read();
            return reader.all;
        };
        QTRY_VERIFY(answer().contains("nVer.2.25mx TREK"));
        QCOMPARE(m_port->kit().receivedBytes(), std::uint64_t{5});
    }
    void bytesThatNobodyReadsAreLostAndNeverComeBackToTheKit()
    {
        for (int i = 0; i < 50; ++i)
            run(100ms);
        {
            Reader reader(path());
            run(1ms);
            // At most what leaves the port in this very millisecond, not five seconds of reports.
            reader.port.waitForReadyRead(20);
            QVERIFY(reader.port.readAll().size() < 300);
            run(100ms);
            QVERIFY(reader.port.waitForReadyRead());
        }
        for (int i = 0; i < 50; ++i)
            run(100ms);
        QCOMPARE(m_port->kit().receivedBytes(), std::uint64_t{0});
    }
    void aReaderThatDoesNotKeepUpLosesBytesButBlocksNobody()
    {
        Reader reader(path());
        for (int i = 0; i < 2000; ++i)
            run(100ms);
        const auto reports = [&] {
            reader.read();
            run(100ms);
            return reader.stream.counts().reports;
        };
        QTRY_VERIFY(reports() > 10);
    }
    void unpluggingEndsTheDeviceAndPluggingMakesANewOne()
    {
        Reader reader(path());
        const QString before = path();
        const auto hasHungUp = [&reader] {
            pollfd asked{reader.port.handle(), POLLIN, 0};
            return ::poll(&asked, 1, 0) >= 0 && (asked.revents & POLLHUP) != 0;
        };
        QVERIFY(!hasHungUp());
        m_port->unplug({}, m_now);
        QTRY_VERIFY(hasHungUp());
        reader.port.close();
        QVERIFY(!m_port->isPlugged());
        QVERIFY(!QFile::exists(before));
        run(100s);
        QVERIFY(!m_port->isPlugged());
        QVERIFY(m_port->plug(m_now));
        readSomething();
    }
    void unpluggedForATimeItComesBackByItself()
    {
        m_port->unplug(2s, m_now);
        run(1900ms);
        QVERIFY(!m_port->isPlugged());
        run(200ms);
        QVERIFY(m_port->isPlugged());
        readSomething();
    }
    void theLinkLeadsToTheDeviceWhileItIsPluggedIn()
    {
        const QTemporaryDir folder;
        const std::string link = folder.filePath("uwb").toStdString();
        std::filesystem::create_symlink("/dev/pts/no-such", link); // of a program that was killed
        make(link);
        QCOMPARE(std::filesystem::read_symlink(link).string(), m_port->path());
        m_port->unplug({}, m_now);
        QVERIFY(!std::filesystem::is_symlink(link));
        QVERIFY(m_port->plug(m_now));
        QCOMPARE(std::filesystem::read_symlink(link).string(), m_port->path());
        m_port.reset();
        QVERIFY(!std::filesystem::is_symlink(link));
    }
    void aFileIsNotReplacedByTheLink()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath("uwb"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        const auto port = UwbPort::create(settings(), file.fileName().toStdString(), m_now);
        QVERIFY(!port);
        QCOMPARE(port.error().code, ErrorCode::InUse);
        QVERIFY(file.exists());
        const auto nowhere = UwbPort::create(settings(), folder.filePath("no/uwb").toStdString(), m_now);
        QCOMPARE(nowhere.error().code, ErrorCode::Io);
    }

    void thePlantServesItsKitAndTrainersUnplugIt()
    {
        auto server = serverOf(plantWithAnchors());
        QVERIFY(server->start());
        QSignalSpy events(server.get(), &PlantServer::event);
        const QString device = server->readyMessage()["uwb"].toObject()["path"].toString();
        auto reader = std::make_unique<Reader>(device);
        const auto reports = [&] {
            reader->read();
            return reader->stream.counts().reports;
        };
        QTRY_VERIFY(reports() > 5);
        reader.reset();

        QVERIFY(server->execute(simulation::UnplugUwb{}));
        QTRY_COMPARE(eventNames(events), QStringList({"uwb-unplugged"}));
        QVERIFY(!QFile::exists(device));
        QVERIFY(server->execute(simulation::PlugUwb{}));
        QTRY_COMPARE(eventNames(events), QStringList({"uwb-unplugged", "uwb-plugged"}));
        const QString again = events.back()[0].toJsonObject()["path"].toString();
        reader = std::make_unique<Reader>(again);
        QTRY_VERIFY(reports() > 5);
    }
    void aDroppedAnchorMeasuresNothingUntilTheFaultsAreUndone()
    {
        auto server = serverOf(plantWithAnchors());
        QVERIFY(server->start());
        Reader reader(server->readyMessage()["uwb"].toObject()["path"].toString());
        const auto mask = [&] {
            reader.read();
            return static_cast<int>(reader.last.mask);
        };
        QTRY_COMPARE(mask() & 4, 4);
        QVERIFY(server->execute(simulation::DropAnchor{2}));
        QTRY_COMPARE(mask(), 0x0b);
        QVERIFY(server->execute(simulation::Restore{}));
        QTRY_COMPARE(mask() & 4, 4);
    }
    void theTagsAreThoseThatThePlantFileSaysAgvsCarry()
    {
        PlantLayout plant = plantWithAnchors();
        QCOMPARE(simulatedUwbTags(plant).size(), std::size_t{1});
        QCOMPARE(simulatedUwbTags(plant)[0].z_m, plant.uwb.tagHeight_m);
        plant.uwb.tags = {{7, "Front", RobotId{1}, 0.4, {0.1, 0.0}}, {8, "Trolley", {}, 1.0, {}}};
        QCOMPARE(simulatedUwbTags(plant), std::vector<UwbTag>{plant.uwb.tags[0]});
    }
    void commandsForAKitOrAnchorThatIsNotThereAreRefused()
    {
        auto server = serverOf(plantWithAnchors());
        QVERIFY(server->start());
        QVERIFY(server->execute(simulation::BlockAnchor{3, 0.5, 10.0}));
        QCOMPARE(server->execute(simulation::BlockAnchor{4, 0.5, 10.0}).error().code, ErrorCode::NotFound);
        PlantLayout bare = plantWithAnchors();
        bare.anchors.clear();
        server = serverOf(bare);
        QVERIFY(server->start());
        QVERIFY(!server->readyMessage().contains("uwb"));
        QVERIFY(server->execute(simulation::UnplugUwb{}).error().detail.find("names no anchors") !=
                std::string::npos);
    }

private:
    static simulation::UwbKitSettings settings() { return simulation::idealUwbKitSettings(fourAnchors); }
    void make(std::optional<std::string> link)
    {
        auto port = UwbPort::create(settings(), std::move(link), m_now);
        QVERIFY2(port.has_value(), port ? "" : port.error().detail.c_str());
        m_port = std::move(*port);
    }
    QString path() const { return QString::fromStdString(m_port->path()); }
    void run(Duration duration)
    {
        m_now += duration;
        m_port->advance(m_now, oneTag);
    }
    void readSomething()
    {
        Reader reader(path());
        const auto reports = [&] {
            run(100ms);
            reader.read();
            return reader.stream.counts().reports;
        };
        QTRY_VERIFY(reports() > 5);
    }
    static std::unique_ptr<PlantServer> serverOf(const PlantLayout& layout)
    {
        auto plant = simulation::Plant::create(layout, {});
        ServerOptions options;
        options.console = Endpoint{"127.0.0.1", 9};
        options.telemetryPort = 9;
        return std::make_unique<PlantServer>(std::move(*plant), options);
    }
    static QStringList eventNames(const QSignalSpy& events)
    {
        QStringList names;
        for (const QList<QVariant>& event : events)
            names << event[0].toJsonObject()["event"].toString();
        return names;
    }

    Time m_now;
    std::unique_ptr<UwbPort> m_port;
};

QTEST_GUILESS_MAIN(UwbPortTest)
#include "test_uwb_port.moc"
