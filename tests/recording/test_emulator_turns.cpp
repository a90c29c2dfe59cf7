// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/emulator_turns.h"

#include "recording/emulator_setup.h"
#include "recording/recording_support.h"

#include <map>
#include <nlohmann/json.hpp>

namespace agv::recording {
namespace {

using test::dataFile;
using test::largeField;
using test::NumbersAndRssi;
using test::parsed;
using test::readsOf;

/// Reads of each stop at the emulator's default pose, from the reference vectors.
std::vector<NumbersAndRssi> referenceReads()
{
    const auto text = readTextFile(std::string(AGV_TEST_DATA) + "/vectors/emulator.json", 1U << 20U);
    std::vector<NumbersAndRssi> stops;
    const auto json = nlohmann::json::parse(text.value());
    for (const auto& row : json["cases"][0]["rows"])
        stops.push_back(row.get<NumbersAndRssi>());
    return stops;
}

TEST(EmulatorTurns, filteredAndReaderLikeFilesOfAllReadingsGiveEveryReading)
{
    const auto options = largeField();
    const auto reference = referenceReads();
    for (const char* name : {"emulator_filtered11.txt", "emulator_reader12.txt"}) {
        const TurnFile file = dataFile(name, options);
        EXPECT_EQ(file.format, TurnFileFormat::Emulator) << name;
        ASSERT_EQ(file.turns.size(), 1U) << name;
        const TurnRecord& record = file.turns[0].record.value();
        EXPECT_NEAR(record.nominalStep, radFromDeg(45.0), 1e-12);
        EXPECT_EQ(record.turnTime_s, 1.125);
        ASSERT_EQ(record.stops.size(), reference.size()) << name;
        for (std::size_t stop = 0; stop < reference.size(); ++stop) {
            EXPECT_EQ(readsOf(record.stops[stop], options), reference[stop]) << name << " stop " << stop;
            EXPECT_TRUE(record.stops[stop].unknownIfUnseen.empty());
        }
    }
}

/// A log of changes never says more than the truth; what it does not say is unknown, never "not read".
TEST(EmulatorTurns, filesOfChangesGiveNoFalseReadingAndCallTheRestUnknown)
{
    const auto options = largeField();
    const auto reference = referenceReads();
    for (const char* name : {"emulator_changes13.txt", "emulator_reader_changes14.txt"}) {
        const TurnFile file = dataFile(name, options);
        const TurnRecord& record = file.turns.at(0).record.value();
        ASSERT_EQ(record.stops.size(), reference.size()) << name;
        int found = 0;
        int possible = 0;
        for (std::size_t stop = 0; stop < reference.size(); ++stop) {
            std::map<int, int> truth(reference[stop].begin(), reference[stop].end());
            for (const auto& [number, rssi] : truth)
                possible += rssi > 0 ? 1 : 0;
            for (const auto& [number, rssi] : readsOf(record.stops[stop], options)) {
                ASSERT_TRUE(truth.contains(number)) << name << " stop " << stop << " tag " << number;
                EXPECT_EQ(truth[number], rssi) << name << " stop " << stop << " tag " << number;
                ++found;
            }
            EXPECT_EQ(record.stops[stop].reads.size() + record.stops[stop].unknownIfUnseen.size(), 121U);
        }
        EXPECT_GE(found, possible - 3) << name << ": " << possible << " readings could be recovered";
    }
}

TEST(EmulatorTurns, aChangeHoldsUntilTheNextLineOfItsTag)
{
    const auto options = largeField();
    const TurnFile file = parsed("0 5 3\n0 17 4\n45 17 5\n90 5 0\n135 5 2\n", options);
    const TurnRecord& record = file.turns.at(0).record.value();
    ASSERT_EQ(record.stops.size(), 4U);
    EXPECT_EQ(readsOf(record.stops[1], options), (NumbersAndRssi{{5, 3}, {17, 5}}));
    EXPECT_EQ(readsOf(record.stops[2], options), (NumbersAndRssi{{17, 5}}));
    EXPECT_EQ(readsOf(record.stops[3], options), (NumbersAndRssi{{5, 2}, {17, 5}}));
}

TEST(EmulatorTurns, theDefectsValueOfATagThatLeftIsNoReading)
{
    const auto options = largeField();
    // Tag 17 repeats its own RSSI: it has left. Tag 28 repeats that of tag 5 before it: unclear, then clear.
    const TurnFile file = parsed("0 5 3\n0 17 4\n0 28 6\n45 17 4\n45 28 3\n90 28 7\n", options);
    const TurnRecord& record = file.turns.at(0).record.value();
    EXPECT_EQ(readsOf(record.stops[1], options), (NumbersAndRssi{{5, 3}}));
    EXPECT_EQ(readsOf(record.stops[2], options), (NumbersAndRssi{{5, 3}, {28, 7}}));
}

TEST(EmulatorTurns, aTagFirstLoggedWithRssiZeroMeansThatAllReadingsAreListed)
{
    const auto options = largeField();
    const TurnFile file = parsed("0 5 3\n45 5 2\n45 6 0\n90 6 1\n", options);
    const TurnRecord& record = file.turns.at(0).record.value();
    EXPECT_EQ(readsOf(record.stops[2], options), (NumbersAndRssi{{6, 1}}));
    EXPECT_TRUE(record.stops[2].unknownIfUnseen.empty());
}

TEST(EmulatorTurns, aSmallerAngleBeginsTheNextTurnAndStopsWithoutLinesAreFilledIn)
{
    const auto options = largeField();
    const TurnFile file = parsed("0 5 0\n30 5 0\n90 6 1\n0 7 0\n2.250000e+01 8 1\n", options);
    ASSERT_EQ(file.turns.size(), 2U);
    ASSERT_EQ(file.turns[0].record->stops.size(), 4U);
    EXPECT_NEAR(file.turns[0].record->nominalStep, radFromDeg(30.0), 1e-12);
    EXPECT_TRUE(file.turns[0].record->stops[2].reads.empty());
    EXPECT_EQ(file.turns[1].line, 4);
    EXPECT_NEAR(file.turns[1].record->nominalStep, radFromDeg(22.5), 1e-12);
}

TEST(EmulatorTurns, linesOfTheReaderThatAreNoReadingsArePassedOver)
{
    const auto options = largeField();
    const TurnFile file =
        parsed("OK\n0 OK\n0 SCAN:+UID=E004000000000005,+RSSI=3/2<\\r>\n0 SCAN:-UID=7<\\r>\n\n"
               "45 SCAN:+UID=6+RSSI=0<\\r>\n",
               options);
    const TurnRecord& record = file.turns.at(0).record.value();
    EXPECT_EQ(readsOf(record.stops[0], options), (NumbersAndRssi{{5, 3}}));
    EXPECT_EQ(readsOf(record.stops[1], options), (NumbersAndRssi{{6, 0}}));
}

TEST(EmulatorTurns, aBadLineNamesItsNumberAndStopsOnlyItsTurn)
{
    for (const char* bad : {"45 5", "45 5 8", "45 x 3", "45 0 3", "x 5 3", "-45 5 3", "45 SCAN:+UID=5",
                            "45 5 3 1", "45 SCAN:+UID=5+RSSI=9", "45 SCAN:+UID=+RSSI=1", "1e99 5 3"}) {
        const TurnFile file =
            parsed(std::string("0 5 0\n45 5 1\n") + bad + "\n90 5 1\n0 6 0\n45 6 0\n", largeField());
        ASSERT_GE(file.turns.size(), 2U) << bad;
        ASSERT_FALSE(file.turns.front().record.has_value()) << bad;
        EXPECT_EQ(file.turns.front().record.error().line, 3)
            << bad << file.turns.front().record.error().reason;
        EXPECT_TRUE(file.turns.back().record.has_value()) << bad;
    }
}

TEST(EmulatorTurns, anglesThatAreNoMultiplesOfTheirStepAreRefused)
{
    for (const char* bad : {"0 5 0\n45 5 1\n57 5 1\n", "0 5 0\n0.5 5 0\n", "0 5 0\n190 5 0\n"})
        EXPECT_FALSE(parsed(bad, largeField()).turns.at(0).record.has_value()) << bad;
}

TEST(EmulatorSetup, isReadFromTheFileBeside)
{
    const auto setup = findEmulatorSetup(std::string(AGV_TEST_DATA) + "/turns/emulator_filtered11.txt");
    ASSERT_TRUE(setup.has_value());
    EXPECT_EQ(setup->tags, 121);
    EXPECT_DOUBLE_EQ(setup->length_m, 1.0);
    EXPECT_NEAR(setup->startAngle, radFromDeg(22.5), 1e-4);
    EXPECT_DOUBLE_EQ(setup->start.x, 0.225);
    EXPECT_DOUBLE_EQ(setup->start.y, 0.515);
    EXPECT_FALSE(findEmulatorSetup(std::string(AGV_TEST_DATA) + "/turns/table10.csv").has_value());
}

TEST(EmulatorSetup, givesTheEmulatorsField)
{
    const auto tags = fieldOf({121, 1.0, 0.0, {}}, TagUid{1});
    ASSERT_TRUE(tags.has_value());
    ASSERT_EQ(tags->size(), 121U);
    EXPECT_NEAR((*tags)[12].position.x, 0.1, 1e-12);
    EXPECT_NEAR((*tags)[12].position.y, 0.1, 1e-12);
    EXPECT_FALSE(fieldOf({120, 1.0, 0.0, {}}, TagUid{1}).has_value());
    EXPECT_FALSE(fieldOf({121, 1.05, 0.0, {}}, TagUid{1}).has_value());
}

TEST(EmulatorSetup, refusesWhatIsNoSideFile)
{
    for (const char* bad : {"", "1\n2\n3\n4", "1 2 3 4 5 6", "x 100 0 0 0", "0 100 0 0 0", "1.5 100 0 0 0",
                            "121 0 0 0 0", "121 1e9 0 0 0"})
        EXPECT_FALSE(parseEmulatorSetup(bad).has_value()) << bad;
}

} // namespace
} // namespace agv::recording
