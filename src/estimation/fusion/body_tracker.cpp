// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fusion/body_tracker.h"

#include "estimation/uwb/robust_fix.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace agv::estimation {

namespace {

constexpr int kIterations = 20;
constexpr int kStarts = 8;
constexpr double kSettled = 1e-8;
/// Residuals beyond this many sds weigh less (Huber): nothing is known yet about hidden anchors.
constexpr double kHuber = 2.0;

struct Equations {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double cost = 0.0;
};

Equations equationsAt(std::span<const BodyTagRanges> tags, double height_m, const Eigen::Vector3d& pose)
{
    Equations equations;
    for (const BodyTagRanges& tag : tags) {
        const Point2 p = fromVehicleFrame({{pose.x(), pose.y()}, pose.z()}, tag.mount);
        const Eigen::Vector2d arm(p.x - pose.x(), p.y - pose.y());
        for (const AnchorRange& range : tag.ranges) {
            const Eigen::Vector3d away(p.x - range.anchor.x(), p.y - range.anchor.y(),
                                       height_m - range.anchor.z());
            const double d = std::max(away.norm(), kLeastDistance_m);
            const Eigen::Vector3d row(away.x() / d, away.y() / d,
                                      (away.y() * arm.x() - away.x() * arm.y()) / d);
            const double e = (range.range_m - d) / range.sd_m;
            const double weight = std::abs(e) > kHuber ? kHuber / std::abs(e) : 1.0;
            equations.information += weight * row * row.transpose() / (range.sd_m * range.sd_m);
            equations.right += weight * row * e / range.sd_m;
            equations.cost +=
                std::abs(e) > kHuber ? kHuber * std::abs(e) - 0.5 * kHuber * kHuber : 0.5 * e * e;
        }
    }
    return equations;
}

Eigen::Vector3d descend(std::span<const BodyTagRanges> tags, double height_m, Eigen::Vector3d pose)
{
    for (int k = 0; k < kIterations; ++k) {
        const Equations equations = equationsAt(tags, height_m, pose);
        Eigen::Matrix3d damped = equations.information;
        damped.diagonal() *= 1.001;
        const Eigen::Vector3d step = damped.ldlt().solve(equations.right);
        if (!step.allFinite())
            break;
        pose += step.cwiseMax(-1.0).cwiseMin(1.0);
        if (step.norm() < kSettled)
            break;
    }
    return pose;
}

} // namespace

BodyFix bodyFix(std::span<const BodyTagRanges> tags, double height_m)
{
    BodyFix result;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    int fixes = 0;
    for (const BodyTagRanges& tag : tags) {
        const UwbFix fix = robustFix(tag.ranges, {.height = TagHeight{height_m}, .obstruction = {}}).fix;
        if (!fix.ok()) {
            if (fixes == 0)
                result.status = fix.status;
            continue;
        }
        middle += fix.position;
        ++fixes;
    }
    if (fixes < 2)
        return result;
    middle /= fixes;
    double best = 1e300;
    Eigen::Vector3d pose = Eigen::Vector3d::Zero();
    for (int k = 0; k < kStarts; ++k) {
        const Eigen::Vector3d found =
            descend(tags, height_m, {middle.x(), middle.y(), 2.0 * std::numbers::pi * k / kStarts});
        const double cost = equationsAt(tags, height_m, found).cost;
        if (cost < best) {
            best = cost;
            pose = found;
        }
    }
    const Eigen::LDLT<Eigen::Matrix3d> factor(equationsAt(tags, height_m, pose).information);
    if (!(factor.vectorD().minCoeff() > 1e-9 * factor.vectorD().maxCoeff())) {
        result.status = FixStatus::UnseenDirection;
        return result;
    }
    result.status = FixStatus::Ok;
    result.pose = {{pose.x(), pose.y()}, wrapAngle(pose.z())};
    result.chiSquared = 2.0 * best;
    Eigen::Map<Eigen::Matrix3d>(result.covariance.data()) = factor.solve(Eigen::Matrix3d::Identity());
    return result;
}

BodyTracker::BodyTracker(const BodyTrackerSettings& settings)
    : m_settings(settings),
      m_models{RangeModel(settings.model), RangeModel(settings.model), RangeModel(settings.model),
               RangeModel(settings.model)},
      m_state(6 + biasStates())
{}

int BodyTracker::biasStates() const
{
    if (m_settings.model.biasSd_m <= 0.0)
        return 0;
    return std::clamp(kMaxBodyTags * m_settings.anchors, 0, GaussianState::kMaxStates - 6);
}

int BodyTracker::firstBias(int tag) const { return biasStates() > 0 ? 6 + tag * m_settings.anchors : -1; }

void BodyTracker::start(const Pose2& pose)
{
    m_state = GaussianState(m_state.size());
    m_models.fill(RangeModel(m_settings.model));
    m_state.mean.head<3>() << pose.position.x, pose.position.y, pose.heading;
    const double place = m_settings.startSd_m * m_settings.startSd_m;
    m_state.p.diagonal().head<6>() << place, place, m_settings.startHeadingSd * m_settings.startHeadingSd,
        0.25, 0.25, 0.25;
    m_started = true;
}

bool BodyTracker::start(std::span<const BodyTagRanges> tags)
{
    const BodyFix fix = bodyFix(tags, m_settings.model.height_m);
    if (fix.ok())
        start(fix.pose);
    return fix.ok();
}

void BodyTracker::predict(double dt_s)
{
    if (!m_started || !(dt_s > 0.0) || !std::isfinite(dt_s))
        return;
    m_state.mean.head<3>() += dt_s * m_state.mean.segment<3>(3);
    m_state.mean(2) = wrapAngle(m_state.mean(2));
    GaussianState::Matrix& p = m_state.p;
    p.topRows<3>() += dt_s * p.middleRows<3>(3);
    p.leftCols<3>() += dt_s * p.middleCols<3>(3);
    const double half = 0.5 * dt_s * dt_s;
    for (const int i : {0, 1, 2}) {
        const double sd = i < 2 ? m_settings.acceleration : m_settings.turnAcceleration;
        const double q = sd * sd;
        p(i, i) += q * half * half;
        p(i + 3, i + 3) += q * dt_s * dt_s;
        p(i, i + 3) += q * half * dt_s;
        p(i + 3, i) += q * half * dt_s;
    }
    // All errors change alike; the models differ in their line-of-sight states only.
    for (RangeModel& model : m_models)
        model.predict(m_state, &model == m_models.data() ? firstBias(0) : -1, dt_s);
    if (m_settings.sideSlip > 0.0)
        keepToHeading();
}

/// Wheels roll along the heading: the speed across it is measured as zero.
void BodyTracker::keepToHeading()
{
    const double c = std::cos(m_state.mean(2));
    const double s = std::sin(m_state.mean(2));
    const double vx = m_state.mean(3);
    const double vy = m_state.mean(4);
    SensitivityRow row;
    row.add({2, -(c * vx + s * vy)});
    row.add({3, -s});
    row.add({4, c});
    const double variance = m_state.variance(row) + m_settings.sideSlip * m_settings.sideSlip;
    m_state.update(row, s * vx - c * vy, variance);
}

const MeasurementRecords& BodyTracker::update(std::span<const BodyTagRanges> tags)
{
    m_records.clear();
    for (const BodyTagRanges& tag : tags) {
        if (!m_started || tag.tag < 0 || tag.tag >= kMaxBodyTags)
            continue;
        for (const AnchorRange& range : tag.ranges) {
            const Pose2 now = pose();
            const Point2 p = fromVehicleFrame(now, tag.mount);
            Placement place;
            place.position = {p.x, p.y};
            place.x.add({0, 1.0});
            place.x.add({2, now.position.y - p.y});
            place.y.add({1, 1.0});
            place.y.add({2, p.x - now.position.x});
            m_records.add(
                m_models[static_cast<std::size_t>(tag.tag)].range(m_state, place, range, firstBias(tag.tag)));
        }
    }
    return m_records;
}

Pose2 BodyTracker::pose() const { return {{m_state.mean(0), m_state.mean(1)}, wrapAngle(m_state.mean(2))}; }

PoseCovariance BodyTracker::covariance() const
{
    PoseCovariance result{};
    Eigen::Map<Eigen::Matrix3d>(result.data()) = m_state.p.topLeftCorner<3, 3>();
    return result;
}

} // namespace agv::estimation
