// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drive.h"

#include <algorithm>
#include <cmath>

namespace agv::simulation {
namespace {

double approach(double speed, double wanted, double largestChange)
{
    return speed + std::clamp(wanted - speed, -largestChange, largestChange);
}

} // namespace

Drive::Drive(const DriveModel& model, SplitMix64 random)
    : m_model(model),
      m_random(random),
      m_imbalance(model.imbalanceSd * m_random.normal()),
      m_encoderScale(1.0 + model.encoderScaleSd * m_random.normal())
{}

Drive::Step Drive::step(WheelSpeeds commanded, double batteryFactor, double seconds)
{
    const double change = m_model.acceleration_m_s2 * seconds;
    const WheelSpeeds before = m_speeds;
    m_speeds.left = approach(m_speeds.left, commanded.left * batteryFactor * (1.0 - m_imbalance), change);
    m_speeds.right = approach(m_speeds.right, commanded.right * batteryFactor * (1.0 + m_imbalance), change);
    const WheelTravel turned{0.5 * (before.left + m_speeds.left) * seconds,
                             0.5 * (before.right + m_speeds.right) * seconds};
    return {{slipped(turned.left), slipped(turned.right)},
            {turned.left * m_encoderScale, turned.right * m_encoderScale}};
}

double Drive::slipped(double travel)
{
    if (travel == 0.0)
        return 0.0;
    const double noise = m_model.slipNoise_sqrtM > 0.0
                             ? m_model.slipNoise_sqrtM * std::sqrt(std::abs(travel)) * m_random.normal()
                             : 0.0;
    return travel * (1.0 - m_slip) + noise;
}

Pose2 rolled(const Pose2& pose, WheelTravel travel, double track_m)
{
    const double forward = 0.5 * (travel.left + travel.right);
    const double turn = (travel.right - travel.left) / track_m;
    const double direction = pose.heading + 0.5 * turn;
    return {
        {pose.position.x + forward * std::cos(direction), pose.position.y + forward * std::sin(direction)},
        wrapAngle(pose.heading + turn)};
}

} // namespace agv::simulation
