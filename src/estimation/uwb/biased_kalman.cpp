// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/biased_kalman.h"

#include <cmath>

namespace agv::estimation {

namespace {

constexpr double kBiasedGate = 3.0;

} // namespace

void BiasedKalman::start(const Eigen::Vector2d& state, const Eigen::Matrix2d& covariance)
{
    m_state = state;
    m_covariance = covariance;
    m_started = true;
}

void BiasedKalman::predict(double dt_s)
{
    if (!m_started || !(dt_s > 0.0))
        return;
    Eigen::Matrix2d h = Eigen::Matrix2d::Identity();
    h(0, 1) = dt_s;
    m_state = (h * m_state).eval();
    m_covariance = (h * m_covariance * h.transpose()).eval();
    m_covariance(1, 1) += std::pow(m_settings.acceleration * dt_s, 2);
}

MeasurementRecord BiasedKalman::update(double range_m)
{
    MeasurementRecord record;
    if (!std::isfinite(range_m)) {
        record.rejected = true;
        return record;
    }
    const double noise = m_settings.sd_m * m_settings.sd_m;
    if (!m_started) {
        Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
        covariance(0, 0) = noise;
        covariance(1, 1) = m_settings.startSpeedSd * m_settings.startSpeedSd;
        start({range_m - m_settings.meanBias_m, 0.0}, covariance);
    }
    record.innovation = range_m - m_settings.meanBias_m - m_state(0);
    record.variance = m_covariance(0, 0) + noise;
    record.testRatio = record.innovation * record.innovation / (kBiasedGate * kBiasedGate * record.variance);
    record.weight = 1.0;
    record.fused = true;
    const Eigen::Vector2d gain = m_covariance.col(0) / record.variance;
    m_state += gain * record.innovation;
    m_covariance -= (gain * m_covariance.row(0)).eval();
    return record;
}

} // namespace agv::estimation
