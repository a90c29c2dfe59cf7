// SPDX-License-Identifier: GPL-3.0-or-later
// Fusion filters against the reference results (1e-9) and the goals of the accuracy study: a closed route of
// 10 m at 0.02 m/s, ranges with drifting errors that are lost far from the anchors, floor tags on part of it.
#include "estimation/error_metrics.h"
#include "estimation/fusion/position_fusion.h"
#include "estimation/fusion/vehicle_fusion.h"
#include "estimation/uwb/linear_toa.h"
#include "estimation/uwb/robust_fix.h"
#include "estimation/uwb/switching_rule.h"
#include "estimation/uwb/uwb_vectors.h"

#include <gtest/gtest.h>

namespace agv::estimation {
namespace {

const std::vector<Eigen::Vector3d> kAnchors{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
constexpr double kPeriod_s = 10.0 / 0.02 / 312.0;

struct Route {
    CsvColumns c;
    explicit Route(int run)
        : c(loadColumns(AGV_TEST_DATA "/vectors/fusion_run_" + std::to_string(run) + ".csv"))
    {}
    std::size_t size() const { return c.at("k").size(); }
    Eigen::Vector2d at(const char* x, const char* y, std::size_t k) const { return {c.at(x)[k], c.at(y)[k]}; }
    std::vector<AnchorRange> ranges(std::size_t k) const
    {
        std::vector<AnchorRange> result;
        const char* names[] = {"r0", "r1", "r2", "r3"};
        for (int i = 0; i < 4; ++i)
            if (std::isfinite(c.at(names[i])[k]))
                result.push_back({kAnchors[static_cast<std::size_t>(i)], c.at(names[i])[k], 0.07, i});
        return result;
    }
    std::optional<Eigen::Vector2d> floorTag(std::size_t k) const
    {
        const Eigen::Vector2d p = at("rfid_x", "rfid_y", k);
        return p.allFinite() ? std::optional(p) : std::nullopt;
    }
    OdometryStep odometry(std::size_t k) const { return {c.at("odo_dx")[k], c.at("odo_dy")[k], 0.0}; }
};

/// The reference's noise model of this scenario.
RangeModelSettings referenceModel()
{
    return {.weighing = RangeWeighing::Gate,
            .height_m = 0.0,
            .gate = 3.0,
            .sdPerMetre = 0.10,
            .sdFrom_m = 2.0,
            .biasSd_m = 0.07,
            .biasTime_s = 15.0,
            .commonBiasSd_m = 0.0,
            .floorTagSd_m = 0.045,
            .obstruction = {}};
}

PositionFusion positionFilter()
{
    return PositionFusion({.model = referenceModel(),
                           .anchors = 4,
                           .acceleration = 0.002,
                           .startSd_m = 0.15,
                           .startSpeedSd = 0.03});
}

VehicleFusion vehicleFilter()
{
    VehicleFusionSettings settings;
    settings.model = referenceModel();
    settings.turnScaleSd = 0.0;
    settings.distanceNoise = 0.03;
    settings.placeWalk = std::sqrt(1e-8 / kPeriod_s);
    settings.headingWalk = settings.scaleWalk = std::sqrt(1e-7 / kPeriod_s);
    settings.headingSd = radFromDeg(3.0);
    return VehicleFusion(settings);
}

/// Runs a filter over the route; start(position) is called at the first epoch with a fix.
template<typename Filter, typename Predict, typename Check>
void drive(const Route& route, Filter& filter, Predict predict, Check check)
{
    for (std::size_t k = 0; k < route.size(); ++k) {
        if (filter.started()) {
            predict(k);
            filter.update(route.ranges(k));
            if (const auto tag = route.floorTag(k))
                filter.updateFloorTag(*tag);
        }
        check(k);
    }
}

TEST(PositionFusion, EqualsTheReferenceWithoutOdometry)
{
    for (int run = 0; run < 10; ++run) {
        const Route route(run);
        PositionFusion filter = positionFilter();
        drive(
            route, filter, [&](std::size_t) { filter.predict(kPeriod_s); },
            [&](std::size_t k) {
                const Eigen::Vector2d expected = route.at("ekf_x", "ekf_y", k);
                if (!filter.started() && expected.allFinite()) {
                    filter.start(expected);
                } else if (filter.started()) {
                    ASSERT_LT((filter.position() - expected).norm(), 1e-9 * expected.norm()) << k;
                }
            });
        EXPECT_TRUE(filter.started());
    }
}

TEST(VehicleFusion, EqualsTheReferenceWithOdometry)
{
    for (int run = 0; run < 10; ++run) {
        const Route route(run);
        VehicleFusion filter = vehicleFilter();
        drive(
            route, filter, [&](std::size_t k) { filter.predict(route.odometry(k), kPeriod_s); },
            [&](std::size_t k) {
                const Eigen::Vector2d expected = route.at("ekfodo_x", "ekfodo_y", k);
                if (!filter.started() && expected.allFinite()) {
                    filter.start(Pose2{{expected.x(), expected.y()}, 0.0});
                } else if (filter.started()) {
                    const Point2 p = filter.pose().position;
                    ASSERT_LT(std::hypot(p.x - expected.x(), p.y - expected.y()), 1e-9 * expected.norm());
                    const PoseCovariance c = filter.covariance();
                    ASSERT_NEAR(std::sqrt(c[0] + c[4]), route.c.at("ekfodo_sd")[k], 1e-9);
                }
            });
    }
}

/// First position of a route: the floor tag's or the robust fix, without looking at the reference.
std::optional<Eigen::Vector2d> firstPosition(const Route& route, std::size_t k)
{
    if (const auto tag = route.floorTag(k))
        return tag;
    const UwbFix fix = robustFix(route.ranges(k), {.height = TagHeight{0.0}, .obstruction = {}}).fix;
    return fix.ok() ? std::optional<Eigen::Vector2d>(fix.position.head<2>()) : std::nullopt;
}

TEST(Fusion, StartedByItselfKeepsTheGoalsWithAndWithoutOdometry)
{
    ErrorSample without;
    ErrorSample with;
    ErrorSample switching;
    for (int run = 0; run < 10; ++run) {
        const Route route(run);
        PositionFusion position = positionFilter();
        VehicleFusion vehicle = vehicleFilter();
        SwitchingRule rule(kAnchors);
        drive(
            route, position, [&](std::size_t) { position.predict(kPeriod_s); },
            [&](std::size_t k) {
                if (!position.started())
                    if (const auto first = firstPosition(route, k))
                        position.start(*first);
                if (position.started())
                    without.add((position.position() - route.at("tx", "ty", k)).norm());
                const UwbFix fix = linearToa2d(route.ranges(k));
                const auto tag = route.floorTag(k);
                const auto choice = rule.choose(
                    fix.ok() ? std::optional(Point2{fix.position.x(), fix.position.y()}) : std::nullopt,
                    tag ? std::optional(Point2{tag->x(), tag->y()}) : std::nullopt);
                if (choice.position)
                    switching.add(distance(*choice.position, {route.c.at("tx")[k], route.c.at("ty")[k]}));
            });
        drive(
            route, vehicle, [&](std::size_t k) { vehicle.predict(route.odometry(k), kPeriod_s); },
            [&](std::size_t k) {
                if (!vehicle.started())
                    if (const auto first = firstPosition(route, k))
                        vehicle.start(Pose2{{first->x(), first->y()}, 0.0});
                if (vehicle.started())
                    with.add(distance(vehicle.pose().position, {route.c.at("tx")[k], route.c.at("ty")[k]}));
            });
    }
    std::printf("switching rule %.4f m; fusion without odometry %.4f m; with %.4f m, p95 %.4f m\n",
                switching.mean(), without.mean(), with.mean(), with.quantile(0.95));
    EXPECT_LE(without.mean(), 0.058);
    EXPECT_LE(with.mean(), 0.022);
    EXPECT_LE(with.quantile(0.95), 0.065);
    EXPECT_NEAR(switching.mean(), 0.1253, 0.02);
}

} // namespace
} // namespace agv::estimation
