// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant_fixture.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace agv;
using namespace agv::simulation;

namespace {

/// UID -> RSSI as the table says for the tags in range of the antenna.
std::map<TagUid, int> expectedAt(const PlantUnderTest& test)
{
    std::map<TagUid, int> expected;
    const RobotTruth truth = test.plant.truth(RobotId{1}).value();
    for (const TagFloor::Tag& tag : test.plant.floor().tags())
        if (const auto rssi = rssiAt(seedRssiTable(), distance(tag.position, truth.antenna)))
            expected[tag.uid] = *rssi;
    return expected;
}

std::map<TagUid, int> lastReads(const PlantUnderTest& test)
{
    std::map<TagUid, int> reads;
    for (const protocol::CompleteRead& read : test.reads())
        reads[read.uid] = read.rssi;
    return reads;
}

PlantSettings readerNoise(auto&& change)
{
    PlantSettings settings = idealSettings();
    change(settings.reader);
    return settings;
}

/// Reads of one standing robot; the settings' noise shows in them.
struct Share {
    double incomplete;
    double wrongRssi;
    double perSecond;
};

Share sharesOver(Duration duration, const PlantSettings& settings)
{
    PlantUnderTest test(settings);
    test.plant.placeRobot(RobotId{1}, {{1.53, 2.02}, 0.4});
    test.run(duration);
    const auto expected = expectedAt(test);
    const auto reads = test.reads();
    double wrong = 0.0;
    for (const protocol::CompleteRead& read : reads)
        wrong += read.rssi != expected.at(read.uid) ? 1.0 : 0.0;
    const double complete = static_cast<double>(test.lineCounts().complete);
    const double incomplete = static_cast<double>(test.lineCounts().incomplete);
    return {incomplete / (complete + incomplete), wrong / complete, complete / secondsFrom(duration)};
}

} // namespace

TEST(RfidReader, readsEveryTagInRangeWithTheRssiOfTheTable)
{
    PlantUnderTest test;
    for (const Pose2 pose : {Pose2{{1.5, 2.0}, 0.0}, Pose2{{1.55, 2.05}, 1.0}, Pose2{{1.513, 2.077}, -2.5}}) {
        test.plant.placeRobot(RobotId{1}, pose);
        test.run(1s);
        test.lines.clear();
        test.run(1s);
        EXPECT_EQ(lastReads(test), expectedAt(test));
        EXPECT_GE(expectedAt(test).size(), 4U);
    }
}

TEST(RfidReader, neverReadsFasterThanOncePerThirtyMilliseconds)
{
    PlantUnderTest test;
    test.run(1s);
    for (int i = 0; i < 200; ++i) {
        test.lines.clear();
        test.run(30ms);
        EXPECT_LE(test.reads().size(), 1U);
    }
}

TEST(RfidReader, readsAboutAsFastAsTheSeedSays)
{
    PlantSettings settings;
    const Share share = sharesOver(60s, settings);
    EXPECT_GT(share.perSecond, 15.0);
    EXPECT_LT(share.perSecond, 33.3);
}

TEST(RfidReader, givesTheAuxiliaryChannelEqualOrOneLess)
{
    PlantUnderTest test;
    test.run(5s);
    std::set<int> differences;
    for (const protocol::CompleteRead& read : test.reads()) {
        differences.insert(read.rssi - read.auxiliaryRssi);
        EXPECT_GE(read.auxiliaryRssi, 0);
    }
    EXPECT_EQ(differences, (std::set<int>{0, 1}));
}

TEST(RfidReader, linesAreWholeLinesOfTheReader)
{
    PlantUnderTest test;
    test.run(5s);
    EXPECT_EQ(test.lineCounts().droppedTotal(), 0U);
    EXPECT_EQ(test.lineCounts().other, 2U); // OK to AT+Scan=OFF and AT+Scan=AC,RSSI
}

TEST(RfidReader, answersOkWhileNoTagIsInRange)
{
    PlantLayout layout = hall();
    PlantUnderTest test(idealSettings(), layout);
    test.plant.placeRobot(RobotId{1}, {{-5.0, -5.0}, 0.0});
    test.run(1s);
    const auto before = test.lineCounts();
    test.run(10s);
    EXPECT_NEAR(static_cast<double>(test.lineCounts().other - before.other), 20.0, 2.0);
    EXPECT_EQ(test.lineCounts().complete, before.complete);
}

TEST(RfidReader, printsTheWantedShareOfIncompleteLines)
{
    const Share share = sharesOver(120s, readerNoise([](ReaderModel& r) { r.incompleteRate = 0.1; }));
    EXPECT_NEAR(share.incomplete, 0.1, 0.02);
    EXPECT_EQ(share.wrongRssi, 0.0);
}

TEST(RfidReader, getsTheWantedShareOfRssiWrongByOne)
{
    // At RSSI 0 and 7 half of the errors are clipped away.
    const Share share = sharesOver(120s, readerNoise([](ReaderModel& r) { r.noiseRate = 0.4; }));
    EXPECT_GT(share.wrongRssi, 0.19);
    EXPECT_LT(share.wrongRssi, 0.42);
}

TEST(RfidReader, missesTheWantedShareOfAnswers)
{
    const double all = sharesOver(120s, idealSettings()).perSecond;
    const double most = sharesOver(120s, readerNoise([](ReaderModel& r) { r.missRate = 0.3; })).perSecond;
    EXPECT_NEAR(most / all, 0.7, 0.03);
}

TEST(RfidReader, readingLongerDoesNotHearATagItIsDeafTo)
{
    int deaf = 0;
    int all = 0;
    for (int i = 0; i < 40; ++i) {
        PlantUnderTest test(readerNoise([](ReaderModel& r) { r.deafRate = 0.3; }));
        test.plant.placeRobot(RobotId{1}, {{1.0 + 0.02 * i, 2.02}, 0.4});
        test.run(1s);
        test.lines.clear();
        test.run(3s);
        all += static_cast<int>(expectedAt(test).size());
        deaf += static_cast<int>(expectedAt(test).size() - lastReads(test).size());
    }
    EXPECT_NEAR(static_cast<double>(deaf) / all, 0.3, 0.1);
}

TEST(RfidReader, reportsTagsLateThatLeftTheRangeWhileTurning)
{
    const auto lateReads = [](double rate) {
        PlantUnderTest test(readerNoise([=](ReaderModel& r) { r.lateRate = rate; }));
        test.drive(-0.5, 0.5);
        int late = 0;
        for (int i = 0; i < 3000; ++i) {
            test.lines.clear();
            test.run(10ms);
            const auto expected = expectedAt(test);
            for (const protocol::CompleteRead& read : test.reads())
                late += expected.contains(read.uid) ? 0 : 1;
        }
        return late;
    };
    const int none = lateReads(0.0);
    EXPECT_GT(lateReads(1.0), none + 20);
}

TEST(RfidReader, heardNothingOfADeadTag)
{
    PlantUnderTest test;
    const TagUid dead = expectedAt(test).begin()->first;
    ASSERT_TRUE(test.plant.killTag(dead));
    test.run(1s);
    test.lines.clear();
    test.run(3s);
    EXPECT_FALSE(lastReads(test).contains(dead));
    test.plant.restore();
    test.run(1s);
    EXPECT_TRUE(lastReads(test).contains(dead));
    EXPECT_FALSE(test.plant.killTag(TagUid{1}));
}

TEST(RfidReader, killsAsManyRandomTagsAsAsked)
{
    PlantUnderTest test;
    EXPECT_EQ(test.plant.killRandomTags(100).size(), 100U);
    EXPECT_EQ(test.plant.killRandomTags(100'000).size(), 31U * 41U - 100U);
    test.run(1s);
    test.lines.clear();
    test.run(1s);
    EXPECT_TRUE(test.reads().empty());
}

TEST(RfidReader, readsASwappedTagInTheOthersPlace)
{
    PlantUnderTest test;
    const auto before = expectedAt(test);
    const TagUid here = before.begin()->first;
    const TagUid far = test.plant.floor().tags().front().uid;
    ASSERT_TRUE(test.plant.swapTags(here, far));
    test.run(1s);
    EXPECT_FALSE(lastReads(test).contains(here));
    ASSERT_TRUE(lastReads(test).contains(far));
    EXPECT_EQ(lastReads(test).at(far), before.at(here));
    EXPECT_FALSE(test.plant.swapTags(here, TagUid{1}));
}

TEST(RfidReader, hearsFartherWithTheTableTooShort)
{
    PlantUnderTest test;
    test.plant.placeRobot(RobotId{1}, {{1.55, 2.0}, 0.0}); // antenna at (1.45, 2.0)
    test.plant.setTableError(0.10);
    test.run(2s);
    const std::size_t more = lastReads(test).size();
    test.plant.restore();
    test.run(1s);
    test.lines.clear();
    test.run(1s);
    EXPECT_EQ(lastReads(test).size(), expectedAt(test).size());
    EXPECT_GT(more, expectedAt(test).size());
}

TEST(RfidReader, antennaShiftMovesTheAntennaInTheVehiclesFrame)
{
    PlantUnderTest test;
    test.plant.placeRobot(RobotId{1}, {{1.5, 2.0}, radFromDeg(90.0)});
    test.plant.shiftAntenna(RobotId{1}, {0.010, 0.020});
    const Point2 antenna = test.plant.truth(RobotId{1})->antenna;
    EXPECT_NEAR(antenna.x, 1.5 - 0.020, 1e-12);
    EXPECT_NEAR(antenna.y, 2.0 - 0.090, 1e-12);
    test.plant.restore();
    EXPECT_NEAR(test.plant.truth(RobotId{1})->antenna.y, 1.9, 1e-12);
}

TEST(RfidReader, garbageIsDroppedAndTheReadsGoOn)
{
    PlantUnderTest test;
    test.run(1s);
    test.plant.printGarbage(RobotId{1}, 500);
    test.run(2s);
    const auto counts = test.lineCounts();
    EXPECT_GT(counts.droppedTotal(), 0U);
    EXPECT_GT(counts.complete, 60U);
}
