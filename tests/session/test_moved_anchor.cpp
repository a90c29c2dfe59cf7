// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated kit in virtual time, heard through the decoder, track and watch that the console uses.
#include "estimation/uwb/anchor_watch.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"
#include "session/uwb_tag_track.h"
#include "simulation/uwb_kit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace agv::session {
namespace {

using namespace std::chrono_literals;
using simulation::UwbKitSettings;
using Path = std::function<Point2(double time_s)>;

/// Of a plant of 6 m by 4 m.
std::vector<UwbAnchor> kitAnchors(int count)
{
    PlantLayout plant;
    plant.width_m = 6.0;
    plant.height_m = 4.0;
    return simulation::defaultUwbAnchors(plant, count);
}

/// Up and down the plant at about 0.3 m/s.
Point2 drive(double time_s)
{
    return {3.0 + 2.4 * std::sin(0.11 * time_s), 2.0 + 1.5 * std::sin(0.171 * time_s + 1.0)};
}

struct Doubt {
    int anchor = 0; ///< id
    std::string text;
};

std::optional<Doubt> doubtOf(const estimation::AnchorWatch& watch)
{
    if (!watch.doubt())
        return std::nullopt;
    return Doubt{watch.doubt()->index, toText(*watch.doubt())}; // the kit's anchors are numbered from 0
}

/// A kit whose anchors stand at `listed` but for what is changed, and the doubts of the track of one tag.
struct Plant {
    explicit Plant(std::vector<UwbAnchor> list, std::uint64_t seed = 1) : listed(std::move(list))
    {
        settings.anchors = listed;
        settings.seed = seed;
        settings.anchorRanges = false;
        if (listed.size() > 4)
            settings.dialect = UwbDialect::UlmEight;
    }

    /// The doubts that were ever had and how often at a report.
    const std::map<std::string, int>& run(Duration duration, const Path& path)
    {
        simulation::UwbKit kit(settings, Time{} + 100s);
        UwbTagTrack track({.id = 5, .label = {}, .agv = {}, .z_m = 0.3, .mount = {}}, listed);
        estimation::AnchorWatch watch;
        protocol::TrekStream stream;
        protocol::TrekRanges reader;
        reader.setReportPeriod(0.1);
        for (Time now = Time{} + 100s; now < Time{} + 100s + duration; now += 5ms) {
            const Point2 at = path(secondsFrom(now - Time{} - 100s));
            const simulation::UwbTagPlace place{5, at.x, at.y, 0.3};
            if (beforeStep)
                beforeStep(kit, at, now);
            kit.step(now, {&place, 1});
            for (const simulation::UwbOutput& output : kit.take(now))
                stream.feed(output.bytes, output.at, [&](const protocol::TrekReport& report) {
                    if (report.kind == protocol::TrekLineKind::Raw)
                        return;
                    const protocol::RangeSet ranges = reader.read(report);
                    track.take(ranges, secondsFrom(report.firstByte.time_since_epoch()));
                    if (!ranges.empty())
                        watch.add(5, track.corrected(), track.height_m(), track.measured_s());
                    ++reports;
                    if (const auto doubt = doubtOf(watch))
                        ++doubts["A" + std::to_string(doubt->anchor) + " " + doubt->text];
                });
        }
        last = doubtOf(watch);
        return doubts;
    }

    std::vector<UwbAnchor> listed;
    UwbKitSettings settings;
    std::map<std::string, int> doubts;
    std::optional<Doubt> last;
    int reports = 0;
    /// Faults that depend on where the tag is and when.
    std::function<void(simulation::UwbKit&, Point2, Time)> beforeStep;
};

/// What is said of any anchor, without its end.
std::set<std::string> saidOf(const Plant& plant)
{
    std::set<std::string> said;
    for (const auto& [text, count] : plant.doubts)
        said.insert(text.substr(0, text.find(" mm")));
    return said;
}

bool isNamed(const Plant& plant, int anchor, const std::string& beginning)
{
    return plant.last && plant.last->anchor == anchor && plant.last->text.starts_with(beginning);
}

TEST(MovedAnchor, IsNamedAndItsDisplacementToldWhileATagDrives)
{
    for (const std::uint64_t seed : {1U, 2U, 4U}) {
        Plant four(kitAnchors(4), seed);
        four.settings.anchors[2].x += 0.5;
        four.run(180s, drive);
        ASSERT_TRUE(isNamed(four, 2, "Ranges fit a place ")) << seed;
        EXPECT_TRUE(four.last->text.ends_with(
            " mm from the one in the list: measure the anchor again or restore it"));
        EXPECT_NEAR(std::stod(four.last->text.substr(19)), 500.0, 100.0);
    }
}

TEST(MovedAnchor, NoOtherIsNamedWhicheverIsMovedAndWhereTo)
{
    for (const int count : {4, 8}) {
        int named = 0;
        for (std::size_t moved = 0; moved < static_cast<std::size_t>(count); ++moved)
            for (const Point2 by :
                 {Point2{0.5, 0.0}, Point2{0.0, 0.5}, Point2{-0.35, -0.35}, Point2{-0.35, 0.35}}) {
                Plant plant(kitAnchors(count), 7 + moved);
                plant.settings.anchors[moved].x += by.x;
                plant.settings.anchors[moved].y += by.y;
                plant.run(180s, drive);
                for (const auto& [text, times] : plant.doubts)
                    EXPECT_TRUE(text.starts_with("A" + std::to_string(moved))) << moved << ": " << text;
                named += plant.doubts.empty() ? 0 : 1;
            }
        RecordProperty("named_of_" + std::to_string(4 * count), named);
        EXPECT_GE(named, 3 * count); // not always, but often enough to be worth looking at
    }
}

TEST(MovedAnchor, ObstructionsOfTenMinutesAreNoReasonWhetherTheTagDrivesOrStands)
{
    const Path stand = [](double) { return Point2{2.2, 1.3}; };
    for (const int count : {4, 8})
        for (const std::uint64_t seed : {1U, 2U, 3U})
            for (const Path& path : {Path(drive), stand}) {
                Plant plant(kitAnchors(count), seed);
                plant.run(600s, path);
                EXPECT_TRUE(plant.doubts.empty()) << plant.doubts.begin()->first;
                EXPECT_GT(plant.reports, 5800);
            }
}

TEST(MovedAnchor, RangesThatAreNotCalibratedAreNoReason)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Plant plant(kitAnchors(4), seed);
        plant.settings.model.pairBiasSd_m = 0.12;
        plant.settings.model.bias_m = 0.1;
        plant.run(300s, drive);
        EXPECT_TRUE(plant.doubts.empty()) << plant.doubts.begin()->first;
    }
}

TEST(MovedAnchor, AnAnchorThatIsHiddenEverywhereIsNotCalledMoved)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Plant plant(kitAnchors(8), seed);
        plant.beforeStep = [](simulation::UwbKit& kit, Point2, Time now) {
            kit.blockAnchor(3, 0.5, 1s, now);
        };
        plant.run(180s, drive);
        for (const std::string& said : saidOf(plant))
            EXPECT_TRUE(said.starts_with("A3 Ranges are ")) << said;
    }
}

TEST(MovedAnchor, AnAnchorThatIsHiddenFromHalfThePlantIsNotCalledMoved)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Plant plant(kitAnchors(4), seed);
        plant.beforeStep = [](simulation::UwbKit& kit, Point2 at, Time now) {
            if (at.x > 3.0)
                kit.blockAnchor(0, 0.4, 20ms, now);
        };
        plant.run(300s, drive);
        for (const std::string& said : saidOf(plant))
            EXPECT_FALSE(said.find("fit a place") != std::string::npos) << said;
    }
}

TEST(MovedAnchor, OfATagThatStandsOnlyTheErrorOfTheRangesIsKnownAndSaidAfterAMinute)
{
    const Path stand = [](double) { return Point2{2.2, 1.3}; };
    Plant early(kitAnchors(4));
    early.settings.anchors[3].x += 0.5;
    early.run(55s, stand);
    EXPECT_TRUE(early.doubts.empty());
    Plant late(kitAnchors(4));
    late.settings.anchors[3].x += 0.5;
    late.run(100s, stand);
    ASSERT_TRUE(isNamed(late, 3, "Ranges are "));
    EXPECT_TRUE(
        late.last->text.ends_with(" mm too long: the anchor may have been moved or be hidden; look at it"));
    Plant nearer(kitAnchors(4));
    nearer.settings.anchors[0].x += 0.5;
    nearer.run(100s, stand);
    ASSERT_TRUE(isNamed(nearer, 0, "Ranges are "));
    EXPECT_NE(nearer.last->text.find(" mm too short: the anchor may have been moved"), std::string::npos);
}

TEST(MovedAnchor, SomebodyWhoStandsInTheWayForHalfAMinuteIsNoReason)
{
    Plant plant(kitAnchors(4));
    plant.beforeStep = [](simulation::UwbKit& kit, Point2, Time now) {
        if (now > Time{} + 170s && now < Time{} + 195s)
            kit.blockAnchor(3, 0.6, 20ms, now);
    };
    plant.run(150s, [](double) { return Point2{2.2, 1.3}; });
    EXPECT_TRUE(plant.doubts.empty()) << plant.doubts.begin()->first;
}

TEST(MovedAnchor, ThreeAnchorsCannotTell)
{
    Plant plant(kitAnchors(3));
    plant.settings.anchors[2].x += 0.5;
    plant.run(180s, drive);
    EXPECT_TRUE(plant.doubts.empty());
}

} // namespace
} // namespace agv::session
