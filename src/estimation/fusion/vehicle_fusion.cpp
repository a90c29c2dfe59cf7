// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fusion/vehicle_fusion.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

enum State : std::uint8_t { X, Y, Heading, Scale, TurnScale };

Eigen::Vector2d turned(double angle, double x, double y)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * x - s * y, s * x + c * y};
}

} // namespace

OdometryStep odometryFromWheels(double left_m, double right_m, double track_m)
{
    return {0.5 * (left_m + right_m), 0.0, (right_m - left_m) / track_m};
}

VehicleFusion::VehicleFusion(const VehicleFusionSettings& settings)
    : m_settings(settings),
      m_model(settings.model),
      m_state(5 + RangeModel::biasStates(settings.model, settings.anchors))
{}

void VehicleFusion::reset()
{
    m_state = GaussianState(m_state.size());
    m_model = RangeModel(m_settings.model);
    m_state.p(Scale, Scale) = m_settings.scaleSd * m_settings.scaleSd;
    m_state.p(TurnScale, TurnScale) = m_settings.turnScaleSd * m_settings.turnScaleSd;
    m_model.startBiases(m_state, firstBias());
    m_velocity.setZero();
    m_started = true;
}

void VehicleFusion::start(const Pose2& pose, const PoseCovariance& covariance)
{
    reset();
    m_state.mean.head<3>() << pose.position.x, pose.position.y, pose.heading;
    m_state.p.topLeftCorner<3, 3>() = Eigen::Map<const Eigen::Matrix3d>(covariance.data());
}

void VehicleFusion::start(const Pose2& pose)
{
    const double place = m_settings.startSd_m * m_settings.startSd_m;
    start(pose, {place, 0.0, 0.0, 0.0, place, 0.0, 0.0, 0.0, m_settings.headingSd * m_settings.headingSd});
}

void VehicleFusion::predict(const OdometryStep& odometry, double dt_s)
{
    if (!m_started || !(dt_s > 0.0) || !std::isfinite(dt_s) || !std::isfinite(odometry.forward_m) ||
        !std::isfinite(odometry.left_m) || !std::isfinite(odometry.turn))
        return;
    GaussianState::Vector& x = m_state.mean;
    GaussianState::Matrix& p = m_state.p;
    const double scale = 1.0 + x(Scale);
    const double turn = (1.0 + x(TurnScale)) * odometry.turn;
    const Eigen::Vector2d way = turned(x(Heading) + 0.5 * turn, odometry.forward_m, odometry.left_m);
    const Eigen::Vector2d across = scale * Eigen::Vector2d(-way.y(), way.x());
    // F P F' with the rows of F that are not the identity's.
    const auto moveRows = [&](auto&& rowOf) {
        for (const int i : {0, 1})
            rowOf(i) += way(i) * rowOf(Scale) + across(i) * rowOf(Heading) +
                        0.5 * odometry.turn * across(i) * rowOf(TurnScale);
        rowOf(Heading) += odometry.turn * rowOf(TurnScale);
    };
    moveRows([&](int i) { return p.row(i); });
    moveRows([&](int i) { return p.col(i); });
    x.head<2>() += scale * way;
    x(Heading) = wrapAngle(x(Heading) + turn);
    m_velocity = scale * way / dt_s;
    m_model.predict(m_state, firstBias(), dt_s);

    const double place = std::pow(m_settings.distanceNoise, 2) * way.squaredNorm() +
                         m_settings.placeWalk * m_settings.placeWalk * dt_s;
    p(X, X) += place;
    p(Y, Y) += place;
    p(Heading, Heading) += std::pow(m_settings.turnNoise * odometry.turn, 2) +
                           m_settings.headingWalk * m_settings.headingWalk * dt_s;
    p(Scale, Scale) += m_settings.scaleWalk * m_settings.scaleWalk * dt_s;
    if (m_settings.turnScaleSd > 0.0)
        p(TurnScale, TurnScale) += m_settings.scaleWalk * m_settings.scaleWalk * dt_s;
}

Placement VehicleFusion::placement(Point2 offset, double age_s) const
{
    Placement place;
    const Eigen::Vector2d arm = turned(m_state.mean(Heading), offset.x, offset.y);
    place.position = m_state.mean.head<2>() + arm - age_s * m_velocity;
    place.x.add({X, 1.0});
    place.y.add({Y, 1.0});
    if (offset != Point2{}) {
        place.x.add({Heading, -arm.y()});
        place.y.add({Heading, arm.x()});
    }
    return place;
}

const MeasurementRecords& VehicleFusion::update(AnchorRanges ranges, Point2 tag, double age_s)
{
    m_records.clear();
    if (m_started)
        for (const AnchorRange& range : ranges)
            m_records.add(m_model.range(m_state, placement(tag, age_s), range, firstBias()));
    return m_records;
}

MeasurementRecord VehicleFusion::updateFloorTag(const Eigen::Vector2d& position, Point2 antenna, double sd_m)
{
    MeasurementRecord record;
    record.kind = MeasurementKind::FloorTag;
    return m_started ? m_model.floorTag(m_state, placement(antenna, 0.0), position, sd_m) : record;
}

Pose2 VehicleFusion::pose() const
{
    return {{m_state.mean(X), m_state.mean(Y)}, wrapAngle(m_state.mean(Heading))};
}

PoseCovariance VehicleFusion::covariance() const
{
    PoseCovariance result{};
    Eigen::Map<Eigen::Matrix3d>(result.data()) = m_state.p.topLeftCorner<3, 3>();
    return result;
}

double VehicleFusion::bias_m(int anchor) const
{
    return firstBias() >= 0 && anchor >= 0 && anchor < m_settings.anchors ? m_state.mean(firstBias() + anchor)
                                                                          : 0.0;
}

} // namespace agv::estimation
