// SPDX-License-Identifier: GPL-3.0-or-later
// Trackers against the reference results (1e-9) and against the goals of the accuracy study.
#include "estimation/uwb/biased_kalman.h"
#include "estimation/uwb/range_ekf.h"
#include "estimation/uwb/range_particle_filter.h"
#include "estimation/uwb/track_vectors.h"

#include <gtest/gtest.h>

namespace agv::estimation {
namespace {

RangeEkf referenceFilter(RangeEkfMode mode, const ReferenceTrack& track)
{
    RangeEkf filter(
        {.mode = mode, .height_m = kTrackHeight_m, .acceleration = 0.15, .gate = 1.5, .obstruction = {}});
    const Eigen::Vector2d first = track.truth(0);
    RangeEkf::Covariance covariance = RangeEkf::Covariance::Zero();
    covariance.diagonal() << 0.3 * 0.3, 0.3 * 0.3, 0.12 * 0.12, 0.12 * 0.12;
    filter.start({first.x() + 0.05, first.y() - 0.05, 0.0, 0.0}, covariance);
    return filter;
}

void expectSame(double value, double expected, std::size_t k)
{
    ASSERT_NEAR(value, expected, 1e-9 * std::max(1.0, std::abs(expected))) << "epoch " << k;
}

void compareWithReference(RangeEkfMode mode, const std::string& column)
{
    for (const std::string obstruction : {"none", "one", "burst"})
        for (int run = 0; run < 5; ++run) {
            const ReferenceTrack track(obstruction, run);
            ASSERT_GT(track.size(), 700U);
            RangeEkf filter = referenceFilter(mode, track);
            for (std::size_t k = 0; k < track.size(); ++k) {
                if (k > 0)
                    filter.predict(kTrackPeriod_s);
                filter.update(track.ranges(k));
                const Eigen::Vector2d expected = track.at(column + "_x", column + "_y", k);
                expectSame(filter.state()(0), expected.x(), k);
                expectSame(filter.state()(1), expected.y(), k);
                if (mode != RangeEkfMode::LineOfSight)
                    continue;
                expectSame(filter.state()(2), track.columns.at("hmm_vx")[k], k);
                expectSame(filter.covariance()(0, 0), track.columns.at("hmm_Pxx")[k], k);
                expectSame(filter.covariance()(0, 1), track.columns.at("hmm_Pxy")[k], k);
            }
        }
}

TEST(RangeEkf, EqualsThePlainReference) { compareWithReference(RangeEkfMode::Plain, "plain"); }
TEST(RangeEkf, EqualsTheRobustReference) { compareWithReference(RangeEkfMode::Robust, "robust"); }
TEST(RangeEkf, EqualsTheReferenceWithLineOfSightStates)
{
    compareWithReference(RangeEkfMode::LineOfSight, "hmm");
}

TEST(BiasedKalman, EqualsTheReference)
{
    const auto reference = loadVector("biased_kf.json");
    BiasedKalman filter(
        {.sd_m = reference.at("sigma"), .meanBias_m = reference.at("c"), .acceleration = reference.at("qs")});
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    covariance.diagonal() << reference.at("P0").at(0).get<double>(), reference.at("P0").at(1).get<double>();
    filter.start({reference.at("s0").at(0).get<double>(), reference.at("s0").at(1).get<double>()},
                 covariance);
    std::size_t k = 0;
    for (const double z : reference.at("z").get<std::vector<double>>()) {
        if (k > 0)
            filter.predict(reference.at("dt"));
        const MeasurementRecord record = filter.update(z);
        EXPECT_TRUE(record.fused);
        const auto& expected = reference.at("out").at(k);
        expectSame(filter.range_m(), expected.at(0), k);
        expectSame(filter.speed_m_s(), expected.at(1), k);
        expectSame(filter.covariance()(0, 0), expected.at(2), k);
        ++k;
    }
    EXPECT_EQ(k, 200U);
}

struct Goal {
    std::string obstruction;
    double mean_m;
    double p95_m;
};

TEST(RangeEkf, StartedByItselfKeepsTheGoalsWithAndWithoutObstruction)
{
    for (const Goal& goal : {Goal{"none", 0.030, 1.0}, Goal{"one", 0.040, 1.0}, Goal{"burst", 0.050, 0.14}}) {
        ErrorSample errors;
        for (int run = 0; run < 5; ++run) {
            const ReferenceTrack track(goal.obstruction, run);
            RangeEkf filter({.height_m = kTrackHeight_m, .obstruction = {}});
            for (std::size_t k = 0; k < track.size(); ++k) {
                const auto ranges = track.ranges(k);
                if (filter.started()) {
                    filter.predict(kTrackPeriod_s);
                } else {
                    ASSERT_TRUE(filter.start(ranges));
                }
                filter.update(ranges);
                if (k >= kTrackStart)
                    errors.add((filter.state().head<2>() - track.truth(k)).norm());
            }
        }
        std::printf("line-of-sight EKF, %-5s mean %.2f cm, p95 %.2f cm\n", goal.obstruction.c_str(),
                    100.0 * errors.mean(), 100.0 * errors.quantile(0.95));
        EXPECT_LE(errors.mean(), goal.mean_m) << goal.obstruction;
        EXPECT_LE(errors.quantile(0.95), goal.p95_m) << goal.obstruction;
    }
}

TEST(RangeParticleFilter, TracksAsTheStudySaysItDoes)
{
    for (const Goal& goal : {Goal{"none", 0.035, 0.08}, Goal{"one", 0.07, 0.16}, Goal{"burst", 0.09, 0.30}}) {
        ErrorSample errors;
        for (int run = 0; run < 2; ++run) {
            const ReferenceTrack track(goal.obstruction, run);
            RangeParticleFilter filter({.height_m = kTrackHeight_m,
                                        .hidden = goal.obstruction == "none" ? 0.02 : 0.25,
                                        .startSpeedSd = 0.12});
            ASSERT_TRUE(filter.start(track.ranges(0)));
            for (std::size_t k = 0; k < track.size(); ++k) {
                if (k > 0)
                    filter.predict(kTrackPeriod_s);
                filter.update(track.ranges(k));
                if (k >= kTrackStart)
                    errors.add((filter.position() - track.truth(k)).norm());
            }
        }
        std::printf("particle filter,   %-5s mean %.2f cm, p95 %.2f cm\n", goal.obstruction.c_str(),
                    100.0 * errors.mean(), 100.0 * errors.quantile(0.95));
        EXPECT_LE(errors.mean(), goal.mean_m) << goal.obstruction;
        EXPECT_LE(errors.quantile(0.95), goal.p95_m) << goal.obstruction;
    }
}

} // namespace
} // namespace agv::estimation
