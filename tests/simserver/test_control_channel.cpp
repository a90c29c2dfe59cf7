// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonDocument>
#include <QSignalSpy>
#include <QTest>

#include "simserver/control_channel.h"

#include <array>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

using namespace agv;
using namespace agv::simserver;

/// Commands through a real pipe, answers as signals.
class TestControlChannel : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void commandCutAnywhereIsStillOneCommand();
    void emptyLinesGetNoAnswer();
    void badCommandGetsAnErrorAndNothingElse();
    void overlongLineIsIgnoredWholeAndTheNextOneWorks();
    void lastLineNeedsNoEnd();
    void endOfInputIsReportedOnce();

private:
    void write(const QByteArray& bytes) const
    {
        QCOMPARE(::write(m_ends[1], bytes.data(), static_cast<std::size_t>(bytes.size())), bytes.size());
    }
    void endInput()
    {
        ::close(m_ends[1]);
        m_ends[1] = -1;
    }
    QJsonObject answer(qsizetype index) const
    {
        return QJsonDocument::fromJson(m_lines->at(index)[0].toByteArray()).object();
    }

    std::array<int, 2> m_ends{-1, -1};
    std::unique_ptr<PlantServer> m_server;
    std::unique_ptr<ControlChannel> m_channel;
    std::unique_ptr<QSignalSpy> m_lines;
};

void TestControlChannel::init()
{
    PlantLayout layout;
    layout.width_m = layout.height_m = 3.0;
    layout.floorTags = tagGrid(31, 31, 0.1, {0.0, 0.0}, TagUid{0xE00401503A5B0001});
    layout.agvs.push_back({.id = {1}, .name = "AGV 1", .robotHost = "127.0.0.2"});
    QCOMPARE(::pipe2(m_ends.data(), O_CLOEXEC), 0);
    auto plant = simulation::Plant::create(layout, simulation::idealSettings());
    QVERIFY(plant);
    m_server = std::make_unique<PlantServer>(std::move(*plant), ServerOptions{});
    m_channel = std::make_unique<ControlChannel>(*m_server, m_ends[0]);
    m_lines = std::make_unique<QSignalSpy>(m_channel.get(), &ControlChannel::line);
}

void TestControlChannel::cleanup()
{
    m_lines.reset();
    m_channel.reset();
    m_server.reset();
    ::close(m_ends[0]);
    if (m_ends[1] >= 0)
        endInput();
}

void TestControlChannel::commandCutAnywhereIsStillOneCommand()
{
    for (const char c : QByteArray("battery 1 50\r\n")) {
        QVERIFY(m_lines->isEmpty());
        write(QByteArray(1, c));
        QCoreApplication::processEvents();
    }
    QTRY_COMPARE(m_lines->size(), 1);
    QCOMPARE(answer(0)["ok"].toBool(), true);
    QCOMPARE(m_server->plant().truth(RobotId{1})->charge, 0.5);
}

void TestControlChannel::emptyLinesGetNoAnswer()
{
    write("\n  \n\r\ntruth\n");
    QTRY_COMPARE(m_lines->size(), 1);
    QVERIFY(answer(0).contains("truth"));
}

void TestControlChannel::badCommandGetsAnErrorAndNothingElse()
{
    const auto before = m_server->plant().truth(RobotId{1})->charge;
    write("battery 1 500\n");
    QTRY_COMPARE(m_lines->size(), 1);
    QVERIFY(answer(0)["error"].toString().contains("'500'"));
    QCOMPARE(answer(0).size(), 1);
    QCOMPARE(m_server->plant().truth(RobotId{1})->charge, before);
}

void TestControlChannel::overlongLineIsIgnoredWholeAndTheNextOneWorks()
{
    write(QByteArray(20'000, 'x') + "\nbattery 1 50\n");
    QTRY_COMPARE(m_lines->size(), 2);
    QVERIFY(answer(0)["error"].toString().contains("4096"));
    QVERIFY(answer(1)["ok"].toBool());
}

void TestControlChannel::lastLineNeedsNoEnd()
{
    write("battery 1 50");
    endInput();
    QTRY_COMPARE(m_lines->size(), 1);
    QVERIFY(answer(0)["ok"].toBool());
}

void TestControlChannel::endOfInputIsReportedOnce()
{
    QSignalSpy ended(m_channel.get(), &ControlChannel::inputEnded);
    endInput();
    QTRY_COMPARE(ended.size(), 1);
    QCoreApplication::processEvents();
    QCOMPARE(ended.size(), 1);
    QVERIFY(m_lines->isEmpty());
}

QTEST_GUILESS_MAIN(TestControlChannel)
#include "test_control_channel.moc"
