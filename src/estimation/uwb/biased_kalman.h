// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/measurement_record.h"

#include <Eigen/Core>

namespace agv::estimation {

struct BiasedKalmanSettings {
    double sd_m = 0.05;         ///< of a range, > 0
    double meanBias_m = 0.0;    ///< C: mean of the obstructed range's error, 0 with line of sight
    double acceleration = 0.15; ///< sd of the range's second derivative, m/s^2
    double startSpeedSd = 0.3;  ///< m/s
};

/// Kalman filter of one range, state (r, dr/dt): thesis equations 3.3 to 3.11, with a known mean error C of
/// the measurement. Printed faults corrected: the gain of 3.5 is P G' (R + G P G')^-1, 3.7 is (I - A G) P.
/// One object per anchor. Its weakness is C, which nobody knows beforehand: kept for comparison.
class BiasedKalman {
public:
    explicit BiasedKalman(const BiasedKalmanSettings& settings = {}) : m_settings(settings) {}

    void start(const Eigen::Vector2d& state, const Eigen::Matrix2d& covariance);
    bool started() const { return m_started; }
    /// dt in s, > 0; Gamma = (0, dt).
    void predict(double dt_s);
    /// The first measurement starts the filter at z - C.
    MeasurementRecord update(double range_m);

    double range_m() const { return m_state(0); }
    double speed_m_s() const { return m_state(1); }
    const Eigen::Matrix2d& covariance() const { return m_covariance; }

private:
    BiasedKalmanSettings m_settings;
    Eigen::Vector2d m_state = Eigen::Vector2d::Zero();
    Eigen::Matrix2d m_covariance = Eigen::Matrix2d::Zero();
    bool m_started = false;
};

} // namespace agv::estimation
