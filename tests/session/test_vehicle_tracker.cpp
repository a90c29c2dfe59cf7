// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated plant in virtual time, driven by commands and heard through the decoders of the console; the
// tracker knows the commands, the reads and the ranges, the test knows the truth.
#include "estimation/fusion/vehicle_tracker.h"
#include "protocol/reader_stream.h"
#include "protocol/robot_frame.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"
#include "session/uwb_tag_track.h"
#include "simulation/plant.h"
#include "simulation/uwb_kit.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace agv::session {
namespace {

using namespace std::chrono_literals;
using estimation::VehicleTracker;

constexpr RobotId agvOne{1};
constexpr WheelSpeeds ahead{0.1, 0.1};
constexpr WheelSpeeds turnLeft{-0.1, 0.1};
/// sd 3 mm and 2 degrees: what an initialisation turn leaves.
constexpr PoseCovariance afterTurn{9e-6, 0, 0, 0, 9e-6, 0, 0, 0, 1.22e-3};

PlantLayout hall(bool hasFloorTags)
{
    PlantLayout plant;
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    if (hasFloorTags)
        plant.floorTags = tagGrid(31, 41, 0.1, {}, TagUid{0xE00401503A5B0001});
    AgvConfig agv;
    agv.id = agvOne;
    plant.agvs = {agv};
    plant.anchors = simulation::defaultUwbAnchors(plant, 4);
    return plant;
}

simulation::PlantSettings settingsFor(std::uint64_t seed, double acceleration_m_s2)
{
    simulation::PlantSettings settings;
    settings.seed = seed;
    settings.drive.acceleration_m_s2 = acceleration_m_s2;
    return settings;
}

/// One AGV that stands where a turn has just found it.
class Drive {
public:
    /// Without floor tags: the console knows of none.
    explicit Drive(std::uint64_t seed, bool hasFloorTags = true, bool hasUwb = false,
                   double acceleration_m_s2 = 1.0)
        : layout(hall(hasFloorTags)),
          plant(simulation::Plant::create(hall(true), settingsFor(seed, acceleration_m_s2)).value()),
          tracker(layout, layout.agvs[0], seed),
          m_random(seed)
    {
        plant.consoleConnected(agvOne);
        plant.placeRobot(agvOne, {{1.5, 1.2}, 0.4});
        if (hasUwb) {
            simulation::UwbKitSettings settings;
            settings.seed = seed;
            settings.anchors = layout.anchors;
            m_kit.emplace(settings, plant.now());
            m_ranges.setReportPeriod(0.1);
        }
        Pose2 found = truth();
        found.position.x += 0.003 * m_random.normal();
        found.position.y += 0.003 * m_random.normal();
        found.heading += 0.035 * m_random.normal();
        tracker.start(found, afterTurn, plant.now());
    }

    Pose2 truth() const { return plant.truth(agvOne)->pose; }
    TrackedPose tracked() { return tracker.pose(plant.now()); }

    void command(const WheelSpeeds& speeds)
    {
        plant.receive(agvOne, protocol::encodeCommand(protocol::DirectDrive{speeds}).value());
        tracker.wheels(speeds, plant.now());
    }

    /// Lets `duration` pass; every 100 ms a sample of the errors.
    void run(Duration duration)
    {
        const Time end = plant.now() + duration;
        for (int i = 0; plant.now() < end; ++i) {
            plant.advance(plant.now() + 5ms);
            hearReader();
            hearUwb();
            if (i % 20 == 19)
                sample();
        }
    }
    void drive(const WheelSpeeds& speeds, Duration duration)
    {
        command(speeds);
        run(duration);
    }
    /// Along a rectangle: ahead, a quarter turn, ahead, ... and stop.
    void driveAround()
    {
        for (const Duration side : {9000ms, 9000ms, 8000ms, 9000ms}) {
            drive(ahead, side);
            drive(turnLeft, 2250ms);
        }
        drive({}, 1s);
    }

    PlantLayout layout;
    simulation::Plant plant;
    VehicleTracker tracker;
    std::vector<double> errors_m;
    std::vector<double> errors_rad;
    int inside = 0; ///< samples whose true place is within the 95 % ellipse

private:
    void hearReader()
    {
        m_reader.feed(plant.takeReaderBytes(agvOne), plant.now(),
                      [&](const protocol::ReaderReport& report, Time at) {
                          if (const auto* read = std::get_if<protocol::CompleteRead>(&report))
                              tracker.read({at, read->uid, read->rssi});
                      });
    }
    void hearUwb()
    {
        if (!m_kit)
            return;
        const Pose2 pose = truth();
        const simulation::UwbTagPlace place{5, pose.position.x, pose.position.y, 0.3};
        m_kit->step(plant.now(), {&place, 1});
        for (const simulation::UwbOutput& output : m_kit->take(plant.now()))
            m_uwb.feed(output.bytes, output.at, [&](const protocol::TrekReport& report) {
                const protocol::RangeSet ranges = m_ranges.read(report);
                if (report.kind == protocol::TrekLineKind::Raw ||
                    report.kind == protocol::TrekLineKind::Anchors || ranges.empty())
                    return;
                m_track.take(ranges, secondsFrom(report.firstByte.time_since_epoch()));
                tracker.ranges(m_track.corrected(), {}, 0.3, Time(durationFromSeconds(m_track.measured_s())));
            });
    }
    void sample()
    {
        const TrackedPose now = tracked();
        const Pose2 real = truth();
        const Eigen::Vector2d off(now.pose.position.x - real.position.x,
                                  now.pose.position.y - real.position.y);
        Eigen::Matrix2d covariance;
        covariance << now.covariance[0], now.covariance[1], now.covariance[3], now.covariance[4];
        errors_m.push_back(off.norm());
        errors_rad.push_back(std::abs(wrapAngle(now.pose.heading - real.heading)));
        inside += off.dot(covariance.inverse() * off) < 5.991 ? 1 : 0;
    }

    SplitMix64 m_random;
    protocol::ReaderStream m_reader;
    std::optional<simulation::UwbKit> m_kit;
    protocol::TrekStream m_uwb;
    protocol::TrekRanges m_ranges;
    UwbTagTrack m_track{{.id = 5, .label = {}, .agv = agvOne, .z_m = 0.3, .mount = {}}, hall(false).anchors};
};

double mean(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

double percentile95(std::vector<double> values)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size()));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Nobody knows how fast the wheels of the real robots take up another speed.
class VehicleTrackerOnWheels : public testing::TestWithParam<double> {};

TEST_P(VehicleTrackerOnWheels, FollowsADriveOverTheFloorTagsByTheCommandsAloneWithAnHonestUncertainty)
{
    std::vector<double> errors_m;
    std::vector<double> errors_rad;
    int inside = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Drive drive(seed, true, false, GetParam());
        drive.driveAround();
        EXPECT_EQ(drive.tracked().health, PoseHealth::Tracked) << seed << drive.tracked().note;
        errors_m.insert(errors_m.end(), drive.errors_m.begin(), drive.errors_m.end());
        errors_rad.insert(errors_rad.end(), drive.errors_rad.begin(), drive.errors_rad.end());
        inside += drive.inside;
    }
    const double share = static_cast<double>(inside) / static_cast<double>(errors_m.size());
    RecordProperty("mean_mm", std::to_string(mmFromMetres(mean(errors_m))));
    RecordProperty("p95_mm", std::to_string(mmFromMetres(percentile95(errors_m))));
    RecordProperty("heading_mean_deg", std::to_string(degFromRad(mean(errors_rad))));
    RecordProperty("inside_95", std::to_string(share));
    EXPECT_LT(mmFromMetres(mean(errors_m)), 5.5);
    EXPECT_LT(mmFromMetres(percentile95(errors_m)), 12.0);
    EXPECT_LT(degFromRad(mean(errors_rad)), 1.3);
    EXPECT_GT(share, 0.85);
}

INSTANTIATE_TEST_SUITE_P(Accelerations, VehicleTrackerOnWheels, testing::Values(0.5, 1.0, 4.0));

TEST(VehicleTracker, ForAnHourOfStandingThePoseGetsNeitherBetterNorWorse)
{
    Drive drive(3);
    drive.drive(ahead, 5s);
    drive.drive({}, 2s);
    const TrackedPose before = drive.tracked();
    drive.run(3600s);
    const TrackedPose after = drive.tracked();
    EXPECT_EQ(after.health, PoseHealth::Tracked);
    EXPECT_LT(distance(before.pose.position, after.pose.position), 0.003);
    EXPECT_GT(after.covariance[0], 0.3 * before.covariance[0]);
    EXPECT_LT(after.covariance[0], 1.5 * before.covariance[0]);
    EXPECT_LT(distance(after.pose.position, drive.truth().position), 0.02);
}

TEST(VehicleTracker, DoubtsThePoseOfAnAgvThatIsPushedByHandWithinAFewSeconds)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Drive drive(seed);
        drive.run(5s);
        ASSERT_EQ(drive.tracked().health, PoseHealth::Tracked);
        drive.plant.placeRobot(agvOne, {{0.8, 2.6}, -2.0});
        drive.run(4s);
        EXPECT_EQ(drive.tracked().health, PoseHealth::Doubted) << seed;
        EXPECT_NE(drive.tracked().note.find("calibrate"), std::string::npos);
        drive.tracker.start(drive.truth(), afterTurn, drive.plant.now());
        drive.run(4s);
        EXPECT_EQ(drive.tracked().health, PoseHealth::Tracked) << seed;
    }
}

TEST(VehicleTracker, WithoutFloorTagsAndUwbThePoseIsPredictedAndItsUncertaintyGrowsWithTheWay)
{
    Drive drive(2, false);
    EXPECT_EQ(drive.tracked().health, PoseHealth::Tracked);
    drive.drive(ahead, 1s);
    const double early = drive.tracked().covariance[0] + drive.tracked().covariance[4];
    drive.run(5s);
    EXPECT_EQ(drive.tracked().health, PoseHealth::Predicted);
    EXPECT_NE(drive.tracked().note.find(" mm of its way"), std::string::npos);
    EXPECT_GT(drive.tracked().covariance[0] + drive.tracked().covariance[4], 4.0 * early);
}

TEST(VehicleTracker, WithoutFloorTagsRangesKeepThePoseFromDriftingAway)
{
    std::vector<double> withRanges_m;
    std::vector<double> without_m;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Drive drive(seed, false, true);
        drive.driveAround();
        withRanges_m.push_back(drive.errors_m.back());
        EXPECT_EQ(drive.tracked().health, PoseHealth::Tracked) << seed << drive.tracked().note;
        Drive blind(seed, false);
        blind.driveAround();
        without_m.push_back(blind.errors_m.back());
    }
    RecordProperty("with_ranges_mm", std::to_string(mmFromMetres(mean(withRanges_m))));
    RecordProperty("without_mm", std::to_string(mmFromMetres(mean(without_m))));
    EXPECT_LT(mean(withRanges_m), 0.5 * mean(without_m));
    EXPECT_LT(mean(withRanges_m), 0.20);
}

TEST(VehicleTracker, DoubtsThePoseOfAnAgvThatIsCarriedAwayWhereOnlyUwbSeesIt)
{
    Drive drive(4, false, true);
    drive.run(5s);
    ASSERT_EQ(drive.tracked().health, PoseHealth::Tracked);
    drive.plant.placeRobot(agvOne, {{2.5, 3.4}, 0.0});
    drive.run(8s);
    EXPECT_EQ(drive.tracked().health, PoseHealth::Doubted);
}

TEST(VehicleTracker, KnowsNoPoseBeforeTheFirstTurnAndTakesADoubtFromOutsideUntilTheNext)
{
    const PlantLayout layout = hall(true);
    VehicleTracker tracker(layout, layout.agvs[0]);
    tracker.doubt("It docked: calibrate it again");
    tracker.wheels(ahead, Time{} + 1s);
    tracker.read({Time{} + 1s, layout.floorTags[0].uid, 5});
    EXPECT_EQ(tracker.pose(Time{} + 2s).health, PoseHealth::None);
    tracker.start({{1.0, 1.0}, 0.0}, afterTurn, Time{} + 3s);
    EXPECT_EQ(tracker.pose(Time{} + 3s).health, PoseHealth::Tracked);
    tracker.doubt("It docked: calibrate it again");
    EXPECT_EQ(tracker.pose(Time{} + 4s).note, "It docked: calibrate it again");
    tracker.start({{1.0, 1.0}, 0.0}, afterTurn, Time{} + 5s);
    EXPECT_EQ(tracker.pose(Time{} + 5s).note, "");
}

TEST(VehicleTracker, TagsThatThePlanDoesNotHaveChangeNothing)
{
    Drive drive(5);
    const TrackedPose before = drive.tracked();
    for (int i = 0; i < 200; ++i)
        drive.tracker.read(
            {drive.plant.now(), TagUid{0xE004015000000000ULL + static_cast<std::uint64_t>(i)}, 4});
    EXPECT_EQ(drive.tracked(), before);
}

} // namespace
} // namespace agv::session
